"""What happens in a run beside its steps: clocks, events of FMUs, and those that the system states."""
