"""A component to begin with: a small one that works, written into a folder of one's own."""
