"""An FMU for Windows on Linux: wine runs its library in a process of its own, its functions are called from here."""
