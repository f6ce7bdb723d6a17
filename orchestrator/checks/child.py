"""The process that an FMU under check runs in: `python -m rovbrush.orchestrator.checks.child FMU REPORT RULE...`.

Writes a JSON line into REPORT when a rule begins and one with its row when it ends, so that whoever started the process
knows what a crash came from.
"""

from __future__ import annotations

import json
import os
import sys
from dataclasses import asdict
from pathlib import Path

from . import good_manners, misuse
from .subject import open_subject
from .rows import Row
from .tried import Refusal

RULES = {**good_manners.RULES, **misuse.RULES}
MEND = "run it in a debugger with the same calls; its log says more"


def title(name: str) -> str:
    """A rule in words, for a row about a rule that did not reach its end."""
    return name.replace("_", " ")


def main() -> None:
    """Run the rules and end at once: some FMUs abort a process that ends the usual way."""
    subject = open_subject(Path(sys.argv[1]))
    with Path(sys.argv[2]).open("w", encoding="utf-8", buffering=1) as report:
        for name in sys.argv[3:]:
            print(json.dumps({"begin": name}), file=report)
            try:
                row = RULES[name](subject)
            except Refusal as error:
                row = Row(good_manners.STAGE, title(name), "error", str(error), MEND)
            except Exception as error:  # fmpy's, when the library lacks functions or does not load
                row = Row(good_manners.STAGE, title(name), "error", f"{type(error).__name__}: {error}", MEND)
            print(json.dumps({"row": asdict(row)}), file=report)
    sys.stdout.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
