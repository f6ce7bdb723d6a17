"""`python -m rovbrush.orchestrator`: the same as the command `rovbrush`."""

from .cli.main import program

if __name__ == "__main__":  # processes of a sweep may import this file
    program()
