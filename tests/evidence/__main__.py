"""`python -m tests.evidence [NAME...]`: try the claims, print the table; exit code 1 if any case is bad."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from .claims import HERE, Claim, found
from .journal import FOLDER, Journal, Tried
from .runner import run

COLUMNS = ("claim", "asked", "done", "good", "bad", "slowest")


def main(arguments: list[str] | None = None, folder: Path = HERE, kept: Path = FOLDER) -> int:
    claims = found(folder)
    parser = argparse.ArgumentParser(prog="python -m tests.evidence", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(claim.name for claim in claims))
    parser.add_argument("--count", type=int, help="cases of each claim; else what the claim says")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", type=int, metavar="INDEX", help="this case alone, whether tried before or not")
    parser.add_argument("--fresh", action="store_true", help="forget what was tried before")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args(arguments)
    unknown = set(options.names) - {claim.name for claim in claims}
    if unknown:
        parser.error(f"no claim {', '.join(sorted(unknown))}; there are {', '.join(claim.name for claim in claims)}")
    os.environ["EVIDENCE_SEED"] = str(options.seed)
    os.environ.setdefault("ROVBRUSH_CACHE", str(kept / "cache"))  # never the user's own
    table = []
    stopped = False
    for claim in claims:
        if options.names and claim.name not in options.names:
            continue
        count = claim.count if options.count is None else options.count
        count = min(count, claim.count) if claim.finite else count
        journal = Journal(claim, options.seed, kept, options.fresh)
        tried = {index: case for index, case in journal.read().items() if index < count}
        wanted = [index for index in range(count) if index not in tried]
        for case in tried.values():
            if case.said:
                print(f"{claim.name} {case.index}: {case.said}")
        if options.only is not None:
            tried, wanted, count = {}, [options.only], 1
        try:
            if not stopped:
                run(claim, wanted, options.jobs, lambda case, c=claim, j=journal, t=tried: _noted(c, j, t, case))
        except KeyboardInterrupt:
            stopped = True
        table.append(_row(claim, count, tried))
    _print(table)
    return 1 if stopped or any(row[4] != "0" for row in table) else 0


def _noted(claim: Claim, journal: Journal, tried: dict[int, Tried], case: Tried) -> None:
    journal.add(case)
    tried[case.index] = case
    if case.said:
        print(f"{claim.name} {case.index}: {case.said}", flush=True)
    if case.wrong:
        again = f"python -m tests.evidence {claim.name} --seed {journal.head['seed']} --only {case.index}"
        print(f"BAD {claim.name} {case.index}: {case.wrong}\n    again: {again}", flush=True)


def _row(claim: Claim, count: int, tried: dict[int, Tried]) -> tuple[str, ...]:
    bad = sum(1 for case in tried.values() if case.wrong)
    slowest = max((case.seconds for case in tried.values()), default=0.0)
    name = f"{claim.name}: {claim.claim}"
    return name, f"{count} {claim.unit}", str(len(tried)), str(len(tried) - bad), str(bad), f"{slowest:.2f} s"


def _print(table: list[tuple[str, ...]]) -> None:
    widths = [max(len(row[column]) for row in (COLUMNS, *table)) for column in range(len(COLUMNS))]
    for row in (COLUMNS, *table):
        print(f"{row[0]:<{widths[0]}}  " + "  ".join(f"{cell:>{widths[k + 1]}}" for k, cell in enumerate(row[1:])))


if __name__ == "__main__":
    sys.exit(main())
