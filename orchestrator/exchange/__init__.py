"""With other people: what an FMU is checked for, recordings, systems for other tools."""
