"""Functions that several kernels share, each once; they are carried and compiled with the kernel that imports them."""
