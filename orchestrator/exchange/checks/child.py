"""The process of an FMU under check: `python -m rovbrush.orchestrator.exchange.checks.child FMU REPORT RULE...`.

Appends the row of each rule to REPORT as a JSON line when the rule ends, so that whoever started the process knows
which one a crash came from. Ends after whatever may have left the FMU in disorder: the next rule needs a new process.
"""

from __future__ import annotations

import json
import os
import sys
from dataclasses import asdict
from pathlib import Path

from .rows import Row
from .rules import good_manners, misuse
from .subject import Subject, open_subject
from .tried import EndedError, RefusedError, Tried

MODULE = "rovbrush.orchestrator.exchange.checks.child"
RULES = {**good_manners.RULES, **misuse.RULES}


def again(path: Path, name: str) -> str:
    """How to make the calls of one rule again, and see where they end."""
    return (
        f"make the same calls again: python -m {MODULE} {path} rows.jsonl "
        f"{name}; behind `gdb --args` a crash stops in its own line"
    )


def broken_off(name: str, found: str, mend: str) -> Row:
    """The row of a rule that did not reach its end."""
    return Row(stage_of(name), name.replace("_", " "), "error", found, mend)


def stage_of(name: str) -> str:
    """Of a rule by its name here."""
    order = misuse.RANGE if name in misuse.OUT_OF_RANGE else misuse.ORDER
    return good_manners.STAGE if name in good_manners.RULES else order


def ended(name: str, subject: Subject, found: str) -> Row:
    """The row of a rule in which the FMU asked to end the simulation: its right, if it does so when it merely runs."""
    said = f"it asks to end the simulation: {found}"
    if name == "runs":
        return Row(stage_of(name), "runs with its start values", "pass", said)
    try:
        good_manners.runs(subject)
    except EndedError:
        return Row(stage_of(name), name.replace("_", " "), "not applicable", said)
    return broken_off(name, found, again(subject.path, name))


def main() -> None:
    """Run the rules and end at once: some FMUs abort a process that ends the usual way."""
    subject = open_subject(Path(sys.argv[1]))
    with Path(sys.argv[2]).open("w", encoding="utf-8", buffering=1) as report:
        for name in sys.argv[3:]:
            try:
                row = RULES[name](subject)
            except EndedError as error:
                row = ended(name, subject, str(error))
            except RefusedError as error:
                row = broken_off(name, str(error), again(subject.path, name))
            except Exception as error:  # fmpy's, when the library lacks functions or does not load
                row = broken_off(name, f"{type(error).__name__}: {error}", again(subject.path, name))
            print(json.dumps(asdict(row)), file=report)
            if row.verdict in ("error", "finding") or Tried.doomed:
                break
    sys.stdout.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
