"""What an FMU says of itself: archive, description, types, variables."""
