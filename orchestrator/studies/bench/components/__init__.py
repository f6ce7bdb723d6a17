"""What a step of a component costs: here and elsewhere, as it grows, and where it is no FMU."""
