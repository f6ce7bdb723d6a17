"""Connections as a file states them, checked: between variables, counters' means, clocks and whole terminals."""
