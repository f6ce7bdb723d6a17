"""Whatever takes part in a run: its life, its calls, its faults."""
