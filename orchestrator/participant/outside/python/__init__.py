"""Python functions and classes as components: called step by step, or as machine code where Numba has compiled them."""
