"""Results to look at: figures that a system file asks for, an overview of any run, comparisons, charts of sweeps.

Drawn from signals and tables alone; nothing here runs anything.
"""
