"""A session that is stepped by hand, and goes back to where it was."""
