"""A run that is advanced piece by piece, and what becomes of it behind each piece."""
