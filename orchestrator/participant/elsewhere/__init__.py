"""FMUs that run on another machine, or elsewhere on this one: the isolated channel over TCP, and the server there."""
