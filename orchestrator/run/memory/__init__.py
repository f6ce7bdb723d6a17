"""Where the numbers of a run are: its cells, and how they are read and set by name."""
