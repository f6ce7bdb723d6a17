"""A run on disk: written whole or not at all, and gone on with only where everything is as it was."""
