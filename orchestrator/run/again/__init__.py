"""A run of one plan again and again, by FMUs that stay loaded."""
