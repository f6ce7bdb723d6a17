"""A run that keeps pace with the clock on the wall: how fast, what a missed deadline means, and how late it was."""
