"""Long evidence: claims of many thousand seeded cases, that a test of a few seconds cannot hold. See README.md."""

from __future__ import annotations

import os
import random
import sys
from pathlib import Path

TESTS = Path(__file__).parent.parent
for shared in ("orchestrator", "fmus", "components", "."):
    sys.path.insert(0, str(TESTS / shared))  # helpers, native_build and the like: as the tests see them


def seeded(name: str, index: int) -> random.Random:
    """The random numbers of a case: the run's seed, the claim's name and the index decide them, nothing else."""
    return random.Random(f"{os.environ.get('EVIDENCE_SEED', '0')}/{name}/{index}")
