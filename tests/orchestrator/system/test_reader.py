# ruff: noqa: E501  one row per case
"""Every way to write a wrong system file, and what the user is told: what, the value, what is allowed, and where."""

from __future__ import annotations

from pathlib import Path

import pytest
from good_system import GOOD, read
from helpers import system_text
from rovbrush.orchestrator.errors import FmuError, InputError, RovbrushError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.system.file.reader import load_system


def test_the_good_file_is_good(tmp_path: Path, fmus: Path) -> None:
    system = read(tmp_path, fmus, GOOD)
    assert dict(system.components["g"].parameters) == {
        "k": 2.0,
        "count": 3,
        "on": True,
        "weights[1]": 1.0,
        "weights[2]": 2.0,
    }
    assert [c.transfer for c in system.connections] == ["", "hold"]


# what is replaced in the good file, by what, and the words that must come back
WRONG: dict[str, tuple[str, str, list[str]]] = {
    "not TOML": ('stop_time = "1 s"', "stop_time = ", ["case.toml is not valid TOML", "line 3"]),
    "unknown top-level key": ('stop_time = "1 s"', 'stop_time = "1 s"\nalgoritm = "jacobi"', ["unknown key 'algoritm'", "did you mean 'algorithm'", "line 4"]),
    "unknown component key": ('period = "20 ms"', 'period = "20 ms"\nperid = 1', ["component i: unknown key 'perid'", "'period'", "line 26"]),
    "no stop time": ('stop_time = "1 s"', "", ["'stop_time' is missing"]),
    "stop time zero": ('stop_time = "1 s"', "stop_time = 0", ["the stop at 0 s is not after the start at 0 s", "line 3"]),
    "stop time no time": ('stop_time = "1 s"', 'stop_time = "soon"', ["stop_time = 'soon' is not a time", "line 3"]),
    "no FMU": ('fmu = "gain"\n', "", ["component g: 'fmu' is missing", "line 14"]),
    "no period": ('fmu = "integrator"\nperiod = "20 ms"', 'fmu = "integrator"', ["component i: 'period' is missing", "line 23"]),
    "negative period": ('period = "20 ms"', 'period = "-20 ms"', ["component i: period = -20 ms is not a positive time", "line 25"]),
    "period no time": ('period = "20 ms"', 'period = "20 parsec"', ["component i: period = '20 parsec' is not a time", "line 25"]),
    "FMU not built": ('fmu = "gain"', 'fmu = "gian"', ["gian.fmu does not exist"]),
    "unknown algorithm": ('stop_time = "1 s"', 'stop_time = "1 s"\nalgorithm = "jakobi"', ["unknown algorithm 'jakobi'", "'jacobi'", "line 4"]),
    "algorithm no text": ('stop_time = "1 s"', 'stop_time = "1 s"\nalgorithm = ["jacobi"]', ["unknown algorithm", "line 4"]),
    "order incomplete": ('stop_time = "1 s"', 'stop_time = "1 s"\norder = ["g", "i"]', ["order must name every component once", "source", "line 4"]),
    "order no list": ('stop_time = "1 s"', 'stop_time = "1 s"\norder = 5', ["order", "line 4"]),
    "no component": ("g.y -> i.u (hold)", "g.y -> j.u", ["g.y -> j.u: no component 'j'", "line 6"]),
    "misspelt component": ("source.y -> g.u", "sorce.y -> g.u", ["no component 'sorce'; did you mean 'source'?", "case.toml, line 5"]),
    "misspelt input": ("g.y -> i.u (hold)", "g.y -> i.uu", ["connection g.y -> i.uu: integrator has no input 'uu'; did you mean 'u'?", "line 6"]),
    "misspelt output": ("g.y -> i.u (hold)", "g.yy -> i.u", ["gain has no output 'yy'; did you mean 'y'?", "line 6"]),
    "input as source": ("g.y -> i.u (hold)", "g.u -> i.u", ["gain has no output 'u'", "line 6"]),
    "parameter as target": ("g.y -> i.u (hold)", "g.y -> i.x_start", ["integrator has no input 'x_start'", "line 6"]),
    "no arrow": ("g.y -> i.u (hold)", "g.y = i.u", ['is not of the form "a.output -> b.input"', "line 6"]),
    "unknown transfer": ("(hold)", "(held)", ["unknown transfer 'held'; did you mean 'hold'?", "line 6"]),
    "connections no list": (GOOD[GOOD.index("connections") : GOOD.index("]") + 1], 'connections = "g.y -> i.u"', ["connections must be a list", "line 4"]),
    "connection no text": ('"source.y -> g.u"', "5", ["connection 5 is not of the form", "line 5"]),
    "driven twice": ('"g.y -> i.u (hold)",', '"g.y -> i.u",\n  "source.y -> i.u"', ["input i.u is driven twice: by g.y -> i.u and by source.y -> i.u", "line 7"]),
    "driven and set": ("[components.i]", "[components.i]\ninputs = { u = 1.0 }", ["input i.u is driven by g.y -> i.u and has a value too", "line 24"]),
    "unknown parameter": ("k = 2.0", "kk = 2.0", ["g.kk is unknown; did you mean 'k'?", "line 18"]),
    "not settable": ("k = 2.0", "y = 2.0", ["g.y is of causality output and cannot be set", "line 18"]),
    "input among the parameters": ("k = 2.0", "u = 2.0", ["g.u is no parameter", "line 18"]),
    "too large": ("k = 2.0", "k = 2e6", ["g.k = 2e+06", "is out of range: -1e+06 to 1e+06", "allowed", "line 18"]),
    "not a number": ("k = 2.0", "k = nan", ["g.k = nan is not a finite number", "line 18"]),
    "infinite": ("k = 2.0", "k = inf", ["g.k = inf is not a finite number", "line 18"]),
    "text for a number": ("k = 2.0", 'k = "two"', ["g.k = two is not a finite number", "line 18"]),
    "a switch for a number": ("k = 2.0", "k = true", ["g.k = True is not a finite number", "line 18"]),
    "a table for a number": ("k = 2.0", "k = { a = 1 }", ["g.k", "is not a finite number", "line 18"]),
    "a fraction for a whole number": ("count = 3", "count = 2.5", ["g.count = 2.5 is not a whole number", "line 19"]),
    "a number for a switch": ("on = true", "on = 2", ["g.on = 2 is not true or false", "line 20"]),
    "too few elements": ("[1.0, 2.0]", "[1.0]", ["g.weights has 2 elements, not 1", "line 21"]),
    "an element out of range": ("[1.0, 2.0]", "[1.0, 11.0]", ["g.weights[2] = 11", "-10 to 10", "line 21"]),
    "a list for a scalar": ("k = 2.0", "k = [2.0, 3.0]", ["g.k has 1 elements, not 2", "line 18"]),
    "parameters no table": ("parameters = { c0 = 1.0 }", "parameters = 5", ["components.source: parameters must be a table", "line 12"]),
    "component no table": ("[components.i]", "[components]\ni = 5\n[components.k]", ["components: i must be a table", "line 24"]),
    "components no table": (GOOD[GOOD.index("[components.source]") :], "", ["'components' is missing"]),
    "missing parameter file": ('stop_time = "1 s"', 'stop_time = "1 s"\nparameters = "none.toml"', ["none.toml", "cannot be read"]),
    "parameters no file": ('stop_time = "1 s"', 'stop_time = "1 s"\nparameters = 5', ["parameters must be the name of a parameter set or of its file", "line 4"]),
    "component name": ("[components.i]", '[components."my motor"]', ["component name 'my motor'", "letters", "line 23"]),
    "record no list": ('stop_time = "1 s"', 'stop_time = "1 s"\nrecord = 5', ["record must be a list", "line 4"]),
    "bond without effort": ("[components.source]", '[[bonds]]\nname = "b"\nflow = "g.u"\n[components.source]', ["bond b: effort = None is no connected input", "g.u"]),
    "bond with a misspelt flow": ("[components.source]", '[[bonds]]\nname = "b"\neffort = "i.u"\nflow = "gg.u"\n[components.source]', ["flow = 'gg.u'", "did you mean 'g.u'?", "line 12"]),
    "bond that does not cross": ("[components.source]", '[[bonds]]\nname = "b"\neffort = "i.u"\nflow = "g.u"\n[components.source]', ["do not cross between the same two"]),
    "bond with a list for an effort": ("[components.source]", '[[bonds]]\nname = "b"\neffort = ["i.u"]\nflow = "g.u"\n[components.source]', ["bond b: effort must be text", "line 11"]),
    "an empty figure of merit": ("[components.source]", '[summary]\nx = ""\n[components.source]', ["summary x must be an operation and its signals", "line 10"]),
    "a number for a figure of merit": ("[components.source]", "[summary]\nx = 5\n[components.source]", ["summary x must be an operation", "line 10"]),
    "a number for an angle": ("[components.source]", "[summary]\nwindow = { angle = 5 }\n[components.source]", ["summary window: angle must be text", "line 10"]),
    "a number in a balance": ("[components.source]", "[balance]\nlost = [5]\n[components.source]", ["balance: lost must be a list, each entry text", "line 10"]),
    "a list for a kind of figure": ("[components.source]", '[[figures]]\nfile = "x.png"\nkind = ["x"]\n[components.source]', ["figure x.png: kind must be text", "line 11"]),
    "record of a misspelt name": ('description = "k"', 'description = "k"\nrecord = ["g.*", "g.yy"]', ["record = ['g.yy']: no variable is called so; did you mean 'g.y'?", "line 3"]),
    "a time beyond counting": ('period = "20 ms"', 'period = "1e300 s"', ["component i: period = 1e300 s is no time that can be counted", "line 25"]),
    "NUL in a name": ('fmu = "gain"', 'fmu = "ga\\u0000in"', ["components.g.fmu: the character NUL is not allowed", "line 15"]),
    "a name of 5000 letters": ('fmu = "gain"', 'fmu = "' + "x" * 5000 + '"', ["does not exist"]),
    "a unit that is a number": ("[components.g.parameters]", '[components.g.units]\nu = 5\n[components.g.parameters]', ["component g: units must be a table, or the name of a file"]),
    "bond no table": ("[components.source]", "[x]\n[components.source]", ["unknown key 'x'"]),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_a_wrong_file_says_what_and_where(case: str, tmp_path: Path, fmus: Path) -> None:
    old, new, hints = WRONG[case]
    assert old in GOOD
    with pytest.raises((InputError, FmuError)) as error:
        make_plan(read(tmp_path, fmus, GOOD.replace(old, new)))  # which checks what the reader keeps for algorithms
    for hint in hints:
        assert hint in str(error.value)
    assert "\n" not in str(error.value).strip()


def test_every_single_deletion_is_read_or_refused(tmp_path: Path, fmus: Path) -> None:
    """No line of a file can be lost, and no value exchanged for another type, such that a traceback comes out."""
    lines = GOOD.splitlines(keepends=True)
    texts = ["".join(lines[:k] + lines[k + 1 :]) for k in range(len(lines))]
    texts += ["".join([*lines[:k], line.split("=")[0] + "= " + value + "\n", *lines[k + 1 :]])
              for k, line in enumerate(lines) if " = " in line for value in ("5", '"a"', "[]", "[[1]]", "{}", "true", "1979-05-27")]  # fmt: skip
    for text in texts:
        try:
            make_plan(read(tmp_path, fmus, text))
        except RovbrushError as error:
            assert str(error)


def test_an_unknown_system_suggests_a_shipped_one(fmus: Path) -> None:
    with pytest.raises(InputError, match=r"no system 'nominel'; did you mean 'nominal'\?"):
        load_system("nominel", fmus)
    with pytest.raises(InputError, match=r"system file .*nowhere\.toml cannot be read"):
        load_system("nowhere.toml", fmus)


def test_a_file_that_is_no_text_is_refused(tmp_path: Path, fmus: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError, match="cannot be read"):
        load_system(str(path), fmus)


def test_a_wrong_bond_sign_is_refused(tmp_path: Path, fmus: Path) -> None:
    text = system_text({"w": ("wheel", "1 ms"), "c": ("chassis", "1 ms")}, ["c.v_c -> w.v_c", "w.F -> c.F"])
    bond = '[[bonds]]\neffort = "c.F"\nflow = "w.v_c"\nsign = {}\n'
    assert read(tmp_path, fmus, text + bond.format("-1")).bonds[0].sign == -1.0
    with pytest.raises(InputError, match=r"bond c.F: sign = 'x' .*1 or -1"):
        read(tmp_path, fmus, text + bond.format('"x"'))
    with pytest.raises(InputError, match="bonds"):
        read(tmp_path, fmus, "bonds = [5]\n" + text)
