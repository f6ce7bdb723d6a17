"""`python -m rovbrush`: the same as the command `rovbrush`."""

from importlib import import_module

if __name__ == "__main__":  # processes of a sweep may import this file
    import_module(f"{__package__}.orchestrator.cli.main").program()
