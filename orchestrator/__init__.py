"""How it is run: a multirate co-simulation master for FMUs whose loop has no Python in it."""
