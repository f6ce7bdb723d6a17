"""A new algorithm is a file and a line: nobody else asks for one by its name."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path

import pytest
from rovbrush.orchestrator.plan.algorithms import registry
from rovbrush.orchestrator.plan.algorithms.base import Algorithm
from rovbrush.orchestrator.plan.algorithms.registry import ALGORITHMS, algorithm_names, settings_tables
from rovbrush.orchestrator.system.schema.keys.system import SystemTable
from rovbrush.orchestrator.system.schema.pages import Algorithms, json_schema

HERE = Path(registry.__file__).parent
PACKAGE = HERE.parent.parent


def asked_for(path: Path) -> Iterator[str]:
    """Names of algorithms that are compared with anything, looked up, or matched in a file."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        parts = [*ast.walk(node)] if isinstance(node, ast.Compare | ast.Match) else []
        keys = node.keys if isinstance(node, ast.Dict) else []
        for part in (*parts, *keys):
            if isinstance(part, ast.Constant) and part.value in algorithm_names():
                yield f"{path.relative_to(PACKAGE)}:{part.lineno}: {part.value}"


def test_nobody_else_asks_which_algorithm_it_is() -> None:
    files = [path for path in PACKAGE.rglob("*.py") if HERE not in path.parents]
    assert len(files) > 100
    transfers = PACKAGE / "plan" / "schedule" / "formulas.py"  # the transfer that iterates is called as its algorithm
    assert [line for path in files if path != transfers for line in asked_for(path)] == []


@pytest.mark.parametrize("kind", ALGORITHMS, ids=algorithm_names())
def test_an_algorithm_is_in_a_file_of_its_own_name_and_says_all_of_itself(kind: type[Algorithm]) -> None:
    assert Path(HERE / f"{kind.name.replace('-', '_')}.py").is_file()
    assert kind.__module__.endswith(kind.name.replace("-", "_"))
    assert kind(kind.Settings()).explanation()
    assert bool(kind.heading) == bool(fields(kind.Settings))


def test_the_default_is_the_first() -> None:
    assert algorithm_names()[0] == SystemTable(stop_time="1 s", components={}).algorithm
    assert len({kind.heading for kind in ALGORITHMS if kind.heading}) == sum(bool(kind.heading) for kind in ALGORITHMS)


def test_the_schema_tells_every_setting_with_its_type_default_and_meaning() -> None:
    schema = json_schema("system", Algorithms(algorithm_names(), settings_tables()))
    found = {heading: schema["$defs"]["SystemTable"]["properties"][heading] for heading in settings_tables()}
    assert set(found) == {"iteration", "ecco", "adaptive"}
    tolerance = found["adaptive"]["properties"]["tolerance"]
    assert (tolerance["type"], tolerance["exclusiveMinimum"], tolerance["default"]) == ("number", 0, 1e-4)
    assert found["iteration"]["properties"]["inputs"]["enum"] == ["end", "mean"]
    assert found["iteration"]["properties"]["max_iterations"]["type"] == "integer"
    assert found["ecco"]["properties"]["minimum"]["type"] == ["number", "string"]
    for table in found.values():
        assert table["additionalProperties"] is False
        assert all(entry["description"] for entry in table["properties"].values())
