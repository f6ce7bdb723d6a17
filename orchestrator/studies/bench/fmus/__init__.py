"""Small FMUs in C and the systems of them that are measured; tests use them too."""
