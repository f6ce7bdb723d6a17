"""What is called here in place of a function under wine, by the kind of its arguments (`functions.Shape`)."""
