"""The FMUs for Model Exchange of a run: brought together to one group, or integrated alone."""
