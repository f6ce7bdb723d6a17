"""Studies: what is done with runs of the shipped systems. Only here does the master's package know the paper."""
