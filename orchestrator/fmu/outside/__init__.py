"""Participants that are no FMU and take part as FMUs do: what they declare of themselves, and what they do. How the
loop calls them is in `participant/outside`."""
