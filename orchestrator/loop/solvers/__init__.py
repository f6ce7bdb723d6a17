"""Solvers that the loop holds: of iterated steps and algebraic loops, and of the length of steps."""
