"""Random system files: each is a system with a plan, or one clear error; nothing else comes out."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from rovbrush.orchestrator.errors import RovbrushError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

WORDS = re.compile(r'"[^"\n]*"|[\w.+-]+|[=\[\]{},]')
SEED = """\
description = "a ring"
stop_time = "60 ms"
algorithm = "jacobi"
order = ["w", "g", "i"]
record = ["g.*"]
connections = [
  "w.y -> g.u (linear)",
  "g.y -> i.u",
]
[components.w]
fmu = "wave"
period = "2 ms"
parameters = { c0 = 1.0 }
[components.g]
fmu = "gain"
period = "3 ms"
isolation = "process"
timeout = "1 s"
parameters = { k = 2.0, count = 3, on = true, weights = [1.0, 2.0] }
[components.i]
fmu = "integrator"
period = "5 ms"
[[bonds]]
name = "b"
effort = "g.u"
flow = "g.y"
sign = -1
[[events]]
at = "10 ms"
fault = "hold"
on = "i.u"
until = "30 ms"
[[events]]
name = "e"
when = "w.y > 0.5"
after = "2 ms"
repeat = true
fault = "noise"
on = "g.u"
value = 0.1
seed = 1
for = "20 ms"
[[require]]
value = "w.y"
minimum = 0.0
message = "m"
[summary]
window = { start = 0.01, end = 0.05 }
mean_y = "mean g.y"
[[compare]]
label = "mean"
value = "mean_y"
reference = 1.0
unit = "1"
"""
# What may stand in the place of any word: other words of the file, and what people write by mistake.
STRANGERS = [
    "0", "-1", "1e400", "nan", "inf", '""', '"0 s"', '"-1 ms"', '"1/3 s"', '"1/0 s"', "[]", "{}", "true", '"a.b.c"',
    '"w.y -> w.y"', '"x -> y"', '"../../etc/passwd"', '"\\u0000"', "1979-05-27", "99999999999999999999",
    '"' + "x" * 5000 + '"', '"mean"', '"quadratic"', '"gauss-seidel"', '"gain.fmu"',
]  # fmt: skip


@st.composite
def texts(draw: Any) -> str:
    """The seed with a few words exchanged, lines dropped, doubled or moved."""
    text = SEED
    words = sorted(set(WORDS.findall(SEED)))
    for _ in range(draw(st.integers(1, 3))):
        found = list(WORDS.finditer(text))
        lines = text.splitlines(keepends=True)
        match draw(st.sampled_from(("word", "word", "word", "drop", "double", "move"))):
            case "word" if found:
                word = found[draw(st.integers(0, len(found) - 1))]
                other = draw(st.sampled_from(words + STRANGERS))
                text = text[: word.start()] + other + text[word.end() :]
            case "drop" if lines:
                del lines[draw(st.integers(0, len(lines) - 1))]
                text = "".join(lines)
            case "double" if lines:
                k = draw(st.integers(0, len(lines) - 1))
                text = "".join([*lines[:k], lines[k], *lines[k:]])
            case "move" if lines:
                line = lines.pop(draw(st.integers(0, len(lines) - 1)))
                lines.insert(draw(st.integers(0, len(lines))), line)
                text = "".join(lines)
    return text


def test_a_random_file_is_a_system_with_a_plan_or_one_clear_error(tmp_path: Path, fmus: Path) -> None:
    path = tmp_path / "case.toml"
    outcomes = {"plan": 0, "error": 0}

    @settings(max_examples=400, deadline=None, derandomize=True, database=None,
              suppress_health_check=list(HealthCheck))  # fmt: skip
    @given(texts())
    def read(text: str) -> None:
        path.write_text(text, encoding="utf-8")
        try:
            system = load_system(str(path), fmus)
            assert isinstance(system, System)
            assert make_plan(system).cycle.shape[1] == 8
            outcomes["plan"] += 1
        except RovbrushError as error:
            assert len(str(error).strip()) > 20, "a message that says nothing"
            outcomes["error"] += 1

    read()
    assert min(outcomes.values()) > 10, outcomes  # how many depends on Hypothesis's version
