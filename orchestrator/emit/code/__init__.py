"""From a plan to the text of its C functions: rows, instants, the start, and tables of what can be set and read."""
