"""What an OspSystemStructure.xml has that is not supported, or wrong, is one error that says what and where."""

from __future__ import annotations

from pathlib import Path

import pytest
from osp_files import group, groups, simulator, structure, wire, write_osp
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.file.reader import load_system

PAIR = [simulator("a"), simulator("b")]
SUM = '<Sum name="s" inputCount="2"/>'
ABOUT = "<EndTime>1</EndTime>"
WRONG = {
    "no simulator": (structure([]), r"OspSystemStructure\.xml holds no simulator"),
    "another root": ("<a/>", r"<a> is no <OspSystemStructure> \(OspSystemStructure\.xml, line 1\)"),
    "not well-formed": ("<a", r"OspSystemStructure\.xml is not well-formed"),
    "a document type": ('<!DOCTYPE a [<!ENTITY e "x">]><a/>', r"has a document type declaration"),
    "no source": (structure([simulator("a", "")]), r"<Simulator>: the attribute source is empty .*line 2"),
    "lost": (structure([simulator("a", "lost.fmu")]), r"simulator 'a': there is no file 'lost\.fmu' from case on"),
    "remote": (structure([simulator("a", "http://x/a.fmu")]), r"is on another machine; nothing is fetched"),
    "proxy": (
        structure([simulator("a", "proxyfmu://localhost:9090?file=Spring.fmu")]),
        r'put Spring\.fmu beside the file and write source="Spring\.fmu"',
    ),
    "NUL": (structure([simulator("a", "a%00.fmu")]), r"there is no file 'a%00\.fmu'"),
    "no address": (structure([simulator("a", "http://[x")]), r"is no address of a file"),
    "two of one name": (structure([simulator("a"), simulator("a")]), r"there are two simulators 'a'"),
    "no variable": (structure(PAIR, [wire("a.z", "b.u")]), r"'a' has no variable 'z'; there are"),
    "unknown simulator": (structure(PAIR, [wire("x.y", "b.u")]), r"there is no simulator 'x'; there are a, b"),
    "unknown value": (structure([simulator("a", values={"kk": 1.0})]), r"a\.kk is unknown"),
    "out of range": (structure([simulator("a", values={"k": 1e9})]), r"a\.k = 1e\+09 is out of range"),
    "output to output": (structure(PAIR, [wire("a.y", "b.y")]), r"output and output cannot be connected .*line 2"),
    "to a parameter": (structure(PAIR, [wire("a.y", "b.k")]), r"an output cannot drive a parameter"),
    "driven twice": (
        structure([*PAIR, simulator("c")], [wire("a.y", "c.u"), wire("b.y", "c.u")]), r"c\.u is driven twice, by a\.y"
    ),
    "one end": (
        structure(PAIR, ['<VariableConnection><Variable simulator="a" name="y"/></VariableConnection>']),
        r"it needs two ends, not 1",
    ),
    "a connection of another kind": (
        structure(PAIR, ["<PlugConnection/>"]), r"<PlugConnection> in <Connections> is not supported"
    ),
    "a function of another kind": (
        structure(PAIR, [], '<Product name="p"/>'), r"<Product> in <Functions> is not supported"
    ),
    "no such function": (structure(PAIR, [wire("a.y", "t:in[0]")], SUM), r"there is no function 't'; there are s"),
    "no such signal": (structure(PAIR, [wire("a.y", "s:in[7]")], SUM), r"the function 's' has no signal 'in\[7\]'"),
    "nothing added": (structure(PAIR, [wire("s:out", "b.u")], SUM), r"nothing drives the function 's'"),
    "a circle": (
        structure(PAIR, [wire("f:in", "g:out"), wire("g:in", "f:out"), wire("f:out", "a.u")],
                  '<LinearTransformation name="f"/><LinearTransformation name="g"/>'),
        r"functions feed each other in a circle",
    ),
    "too many": (
        structure(PAIR, [], '<VectorSum name="v" inputCount="9999" dimension="9999"/>'), r"are more than 10000"
    ),
    "a count that is none": (
        structure(PAIR, [], '<Sum name="s" inputCount="-1"/>'), r"inputCount = '-1' is no number from 1 to 10000"
    ),
    "no groups": (
        structure(PAIR, [wire("a.out", "b.in", "VariableGroup")]),
        r"the groups of 'a' are not known; put gain_OspModelDescription\.xml beside its FMU",
    ),
    "a base step that is none": (structure(PAIR, step="-1"), r"BaseStepSize .* = -1 is not a positive time"),
    "a step that is none": (structure([simulator("a", step="soon")]), r"stepSize = 'soon' is no finite number"),
    "a step beyond the end": (structure([simulator("a", step="1e7")], step=""), r"steps of a are longer than the run"),
    "an algorithm": (
        structure(PAIR, head=f"{ABOUT}<Algorithm>magic</Algorithm>"), r"the algorithm 'magic' is not supported; fixed"
    ),
    "half a bond": (
        structure(PAIR, [wire("a.y", "b.u", bond="p")], head=f"{ABOUT}<Algorithm>ecco</Algorithm>"),
        r"power bond 'p' needs two connections, not 1",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_not_supported_or_wrong_is_one_error(case: str, tmp_path: Path, fmus: Path) -> None:
    text, message = WRONG[case]
    with pytest.raises(InputError, match=message):
        load_system(str(write_osp(tmp_path / "case", fmus, text)))


def test_groups_that_do_not_fit_are_one_error(tmp_path: Path, fmus: Path) -> None:
    known = groups(group("Generic", "out", "y", "held") + group("Generic", "in", "u"))
    text = structure(PAIR, [wire("a.out", "b.in", "VariableGroup")])
    with pytest.raises(InputError, match=r"'out' has 2 variables and 0 groups, 'in' 1 variables and 0 groups"):
        load_system(str(write_osp(tmp_path / "case", fmus, text, gain=known)))
    text = structure(PAIR, [wire("a.outt", "b.in", "VariableGroup")])
    with pytest.raises(InputError, match=r"'a' has no group 'outt'; did you mean 'out'\?"):
        load_system(str(write_osp(tmp_path / "case", fmus, text, gain=known)))


def test_a_file_that_is_not_there_is_one_error(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"system file .*lost\.xml does not exist"):
        load_system(str(tmp_path / "lost.xml"))
