"""What can be chosen when an FMU is built; the build writes its own copy of this file into the FMU."""

ROWS = 0  # how many rows of an array with columns (the filaments of the brush) are outputs of their own
