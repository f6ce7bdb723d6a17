"""A kernel's text, in which records are read and written by name, made into the text that Numba and Pyccel compile."""
