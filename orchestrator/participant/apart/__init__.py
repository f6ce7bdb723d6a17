"""What keeps the uses of an FMU in one process apart: a library of its own for each, modules of its own for each."""
