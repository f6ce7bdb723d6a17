"""A kernel's text straight to machine code by LLVM, kept in the cache, and called without Numba: `stages.py` first.

What this compiler does not know goes to Numba (`../kernels.py`), which knows it and takes its time."""
