"""What can be chosen when an FMU is built; the build writes its own copy of this file into the FMU."""

ROWS = 0  # how many elements of the vectors that can be shown (the filaments of the brush) are outputs
