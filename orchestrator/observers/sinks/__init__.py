"""The kinds of observers, one a file: each writes rows of a `layout.Layout` somewhere, and knows nothing of the run."""
