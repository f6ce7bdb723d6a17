"""Something to begin with that works, in a folder of one's own: a component, or a system of FMUs."""
