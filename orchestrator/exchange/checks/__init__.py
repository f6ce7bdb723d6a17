"""What `rovbrush check` looks at: archive, description, what other tools say, a dry run in its own processes."""
