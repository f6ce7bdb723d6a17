"""`python -m rovbrush.orchestrator`: the same as the command `rovbrush`."""

from .cli import main

main()
