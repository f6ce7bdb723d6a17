"""What fmus/README.md promises: tables are the declarations, and the numbers come out."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import fmpy
import pytest
from helpers import ROOT
from rovbrush.components.build import COMPONENTS
from rovbrush.components.describe.tables import BEGIN, README, described, main, section
from rovbrush.components.errors import BuildError
from rovbrush.components.python.component import component_class
from rovbrush.orchestrator.clock import duration

SYSTEMS = ROOT / "orchestrator" / "systems"


def rows(text: str) -> Iterator[list[str]]:
    """Cells of the table rows that begin with a name in backquotes or with a number."""
    for line in text.splitlines():
        if re.match(r"\| (`|\d)", line):
            yield [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def component_rows() -> dict[str, list[str]]:
    """Step and first run of each component, from the guide."""
    guide = README.read_text(encoding="utf-8").partition(BEGIN)[0]
    return {cells[0].strip("`"): cells for cells in rows(guide) if cells[0].strip("`") in COMPONENTS}


# --- tables ---


def test_variable_tables_are_those_of_the_declarations() -> None:
    text = README.read_text(encoding="utf-8")
    assert text == described(text), "run `python -m rovbrush.components.describe`"


@pytest.mark.parametrize("name", COMPONENTS)
def test_variable_table_agrees_with_the_file_that_is_handed_over(name: str, native: Path) -> None:
    description = fmpy.read_model_description(str(native / "fmi3" / f"{name}.fmu"))
    variables = [v for v in description.modelVariables if v.causality != "independent"]
    table = list(rows(section(name)))
    assert len(table) == len(variables)
    for cells, v in zip(table, variables, strict=True):
        reference, shown, causality, kind, unit = cells[:5]
        assert (int(reference), shown) == (v.valueReference, f"`{v.name}`")
        assert causality.replace("calculated parameter", "calculatedParameter") == v.causality
        assert unit == (v.unit or "")
        size = re.search(r"\[(\d+)\]", kind)
        assert [int(size[1])] == [int(d.start) for d in v.dimensions] if size else not v.dimensions


def test_tables_are_written_between_the_marks_only(tmp_path: Path) -> None:
    path = tmp_path / "README.md"
    path.write_text(f"before\n{BEGIN}\nof yesterday\n<!-- end of variables -->\nafter\n", encoding="utf-8")
    main(path)
    text = path.read_text(encoding="utf-8")
    assert text.startswith("before\n") and text.endswith("\nafter\n") and "of yesterday" not in text
    assert all(f"### {name}\n" in text for name in COMPONENTS)
    with pytest.raises(BuildError, match="put them into the file"):
        described("no marks")
    with pytest.raises(SystemExit, match="nowhere"):
        main(tmp_path / "nowhere.md")


# --- the guide's numbers ---


def test_every_component_has_the_step_of_the_shipped_systems() -> None:
    known: dict[str, set[str]] = {name: set() for name in COMPONENTS}
    for path in SYSTEMS.glob("*.toml"):
        for part in tomllib.loads(path.read_text(encoding="utf-8")).get("components", {}).values():
            if "fmu" in part:  # all but links to programs elsewhere
                known[part["fmu"]].add(part["period"])
    steps = {name: cells[2] for name, cells in component_rows().items()}
    assert list(steps) == list(COMPONENTS)
    assert all(step in known[name] for name, step in steps.items())
    assert {name: float(duration(step, name)) for name, step in steps.items()} == {
        name: component_class(name).default_step for name in COMPONENTS
    }  # which is what the FMU suggests to a host


@pytest.mark.parametrize("name", COMPONENTS)
def test_first_run_gives_the_numbers_of_the_guide(name: str, native: Path) -> None:
    _, _, step, run = component_rows()[name]
    given, expected = (
        {key: float(value) for key, value in re.findall(r"`([\w\[\]]+)` = (-?[\d.]+)", part)}
        for part in run.split(": ")
    )
    found = fmpy.simulate_fmu(
        str(native / "fmi2" / f"{name}.fmu"),
        stop_time=2.0, output_interval=float(duration(step, name)), start_values=given, output=list(expected),
    )  # fmt: skip
    assert expected
    for key, value in expected.items():
        assert found[key][-1] == pytest.approx(value, rel=1e-6)  # seven digits are printed
