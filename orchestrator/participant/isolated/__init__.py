"""A participant in a process of its own: its crash or hang is an error that names it."""
