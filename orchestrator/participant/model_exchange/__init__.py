"""FMUs for Model Exchange: instances that have states but no solver, and the group of them that is one participant."""
