"""Somebody else's FMU in the place of a component: its names, units and directions, and what it lacks."""
