"""A run that goes on: from time 0, step by step, to its end, and again from a checkpoint."""
