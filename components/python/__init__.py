"""Components as Python FMUs: the slave class, kernels under Numba, and what builds the FMU file."""
