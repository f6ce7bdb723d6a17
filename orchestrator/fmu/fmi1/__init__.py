"""FMI 1.0: a description of it is written anew as FMI 2.0 has it, before anybody reads it."""
