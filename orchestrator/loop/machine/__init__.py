"""The loop as machine code: compiled by Numba and kept, or taken from a library that came with the package."""
