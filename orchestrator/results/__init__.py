"""What a run leaves: its tables, figures of merit, files and figures."""
