"""What a system file can say at its top, and of its connections.

How its components are coupled, `algorithm`, and the tables of settings of algorithms are kept as they stand: what they
may be is known, and checked before time 0, by `plan/algorithms`.
"""

from __future__ import annotations

DEFAULT_ALGORITHM = "gauss-seidel"
TRANSFERS = ("hold", "linear", "quadratic", "interpolate", "mean")
KEYS = (
    *("description", "stop_time", "algorithm", "order", "parameters", "components", "connections", "bonds"),
    *("record", "require", "summary", "balance", "compare", "figures"),
)
