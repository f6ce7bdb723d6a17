"""A system file: its keys, read and checked; every error names the file, the line and the mend."""
