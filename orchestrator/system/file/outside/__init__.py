"""Components of a system file that are no FMU: Python, peers by UDP and shared memory, an autopilot."""
