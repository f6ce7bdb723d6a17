"""A plan as a picture: its components in the order in which they step, and what goes from one to another."""
