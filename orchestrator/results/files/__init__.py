"""The files of a run: rows first, then each product apart, in a folder that says whose it is."""
