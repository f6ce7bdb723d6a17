"""What can be typed behind `rovbrush`: the commands of one family in each file. Importing a file registers its commands
with the application of `options`; `main` does that in the order of the help."""
