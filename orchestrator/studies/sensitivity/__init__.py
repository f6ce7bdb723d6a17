"""Which parameter matters: Sobol's indices and Morris's elementary effects of the figures of merit of a system."""
