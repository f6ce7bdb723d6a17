"""From instantiated FMUs to consistent values at the start, and whether that is what was asked for."""
