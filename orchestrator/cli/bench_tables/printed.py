"""Each part with what prints it."""

from __future__ import annotations

from .comparisons import print_against, print_folders
from .components import print_components, print_elsewhere, print_outside, print_sizes, print_windows
from .masters import print_foreign, print_start, print_systems
from .runs import (
    print_growth,
    print_gym,
    print_long_runs,
    print_loop,
    print_observers,
    print_pacing,
    print_solvers,
    print_sweeps,
    print_workers,
)

PRINTED = {
    "masters": print_systems, "loop": print_loop, "foreign": print_foreign, "start": print_start,
    "components": print_components, "sizes": print_sizes,
    "long": print_long_runs,
    "growth": print_growth, "solvers": print_solvers, "windows": print_windows, "gym": print_gym,
    "elsewhere": print_elsewhere, "outside": print_outside, "pacing": print_pacing,
    "observers": print_observers, "sweeps": print_sweeps, "workers": print_workers,
    "against": print_against, "fmus": print_folders,
}  # fmt: skip
