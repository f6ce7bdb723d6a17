"""What has been tried: a line of JSON per case in .evidence/NAME.jsonl, so that a run goes on where it was stopped."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path

from .claims import Claim

ROOT = Path(__file__).parent.parent.parent
FOLDER = ROOT / ".evidence"


@dataclass(frozen=True)
class Tried:
    index: int
    seconds: float
    wrong: str  # "": good
    said: str = ""  # what it printed, of claims that say SAYS


class Journal:
    """Cases of one claim, seed and state of the source; lines of other sources or seeds do not count."""

    def __init__(self, claim: Claim, seed: int, folder: Path = FOLDER, fresh: bool = False) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / f"{claim.name}.jsonl"
        self.head = {"seed": seed, "source": source_of(claim)}
        if fresh:
            self.path.unlink(missing_ok=True)

    def read(self) -> dict[int, Tried]:
        tried = {}
        if self.path.is_file():
            for line in self.path.read_text(encoding="utf-8").splitlines():
                try:
                    row = json.loads(line)
                except ValueError:
                    continue  # the line that was being written when the last run was killed
                if {key: row[key] for key in self.head} == self.head:
                    tried[row["index"]] = Tried(row["index"], row["seconds"], row["wrong"], row.get("said", ""))
        return tried

    def add(self, case: Tried) -> None:
        row = {**self.head, "index": case.index, "seconds": round(case.seconds, 4), "wrong": case.wrong}
        if case.said:
            row["said"] = case.said
        with self.path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(row) + "\n")


def source_of(claim: Claim) -> str:
    """A digest of the program and of the claim's own file: what is tried says nothing of another program."""
    files = [claim.path, *sorted((ROOT / "orchestrator").rglob("*.py")), *sorted((ROOT / "components").rglob("*.py"))]
    digest = hashlib.sha256()
    for path in files:
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()[:12]
