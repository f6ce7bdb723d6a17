"""Variables of theirs that stand for none of ours, of any type, and FMUs that have none of ours at all."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import python
from native_build import feedthrough3, moody, needs_gcc
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.exchange.component_tests.compare import compare
from rovbrush.orchestrator.exchange.component_tests.fmu_unit import FmuUnit
from rovbrush.orchestrator.exchange.component_tests.suites import suite_of
from rovbrush.orchestrator.exchange.component_tests.verdicts import make_bench, require_outputs
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.system.replace.mapping import load_mapping

pytestmark = needs_gcc

OWN = """
[parameters]
"M[1,1]" = 5.0
"M[2,2]" = 6.0
[inputs]
Enumeration_in = 1
"a_in[3]" = 9.5
Boolean_in = true
String_in = "theirs"
t_in = ["x", "y"]
"""


def test_elements_of_arrays_and_values_of_every_type_can_be_given(tmp_path: Path) -> None:
    fmu = Fmu.open(feedthrough3(tmp_path / "feedthrough3.fmu", OPEN_END=1))
    path = tmp_path / "map.toml"
    path.write_text(OWN, encoding="utf-8")
    mapping = load_mapping(path)
    compare(fmu, suite_of("dc_motor"), mapping)
    unit = FmuUnit(fmu, {}, mapping)
    running = unit.new()
    found = {v: running.instance.get(f"{v}_out") for v in ("Enumeration", "Boolean", "String")}
    assert found == {"Enumeration": 1, "Boolean": True, "String": "theirs"}
    assert running.instance.get("a_out[3]") == 9.5 and running.instance.get("a_out[4]") == 4.0
    assert running.instance.get("t_out[2]") == "y" and running.instance.get("trace") == 11.0
    unit.release()


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("[parameters]\nM2 = 1.0", "has no variable 'M2'"),
        ('[inputs]\n"a_in[9]" = 1.0', "has no variable 'a_in[9]'"),
        ("[inputs]\nEnumeration_in = 1.5", "Enumeration_in = 1.5 is not a whole number"),
    ],
)
def test_a_value_that_does_not_fit_is_one_clear_error(line: str, words: str, tmp_path: Path) -> None:
    fmu = Fmu.open(feedthrough3(tmp_path / "feedthrough3.fmu", OPEN_END=1))
    path = tmp_path / "map.toml"
    path.write_text(line, encoding="utf-8")
    mapping = load_mapping(path)
    with pytest.raises(InputError) as error:
        compare(fmu, suite_of("dc_motor"), mapping)
        FmuUnit(fmu, {}, mapping).new()
    assert words in str(error.value)


def test_an_fmu_with_none_of_our_variables_gets_a_mapping_file_to_begin_with(tmp_path: Path) -> None:
    path = moody(tmp_path / "moody.fmu")
    with pytest.raises(RunError) as error:
        require_outputs(make_bench(path, "dc_motor", None))
    text = str(error.value)
    assert "moody.fmu has no output of dc_motor under its name" in text
    assert '[variables]\nV_in = ""  # input in V; there: u\n' in text and "# output in rad/s; there: x, y" in text
    begun = tmp_path / "map.toml"
    begun.write_text(text[text.index("[variables]") :].replace('V_in = ""', 'V_in = "u"'), encoding="utf-8")
    assert load_mapping(begun).entry("V_in").name == "u"


def test_so_it_does_on_the_command_line(tmp_path: Path) -> None:
    path = moody(tmp_path / "moody.fmu")
    code = "from rovbrush.orchestrator.cli.main import main; main()"
    done = python(code, "test-component", str(path), "--as", "dc_motor", timeout=300.0)
    assert done.returncode == 1 and "[variables]" in done.stderr and "unexpected" not in done.stderr
