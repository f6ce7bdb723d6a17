"""How FMU files are made: of a component, of a script of anybody's."""
