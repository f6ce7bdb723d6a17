"""The generated C is read by name too: cells of records have names, equations their numbers, errors their lines."""

from __future__ import annotations

import importlib
import importlib.util
import io
import re
import tokenize
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from driven import component
from rovbrush.components.build import COMPONENTS
from rovbrush.components.errors import BuildError
from rovbrush.components.lowering.lowered import lowered
from rovbrush.components.native.translate import kernel_in_c

pytest.importorskip("pyccel")
COMPONENTS_OF_A_VECTOR = 4


@cache
def c_text(name: str) -> str:
    return kernel_in_c(importlib.import_module(f"rovbrush.components.{name}.kernel"))


def functions(text: str) -> dict[str, str]:
    """The functions of a C text: name and all from the signature on."""
    return {m[1]: m[0] for m in re.finditer(r"^static \w+ (\w+)\(.*?^\}$", text, re.MULTILINE | re.DOTALL)}


def own_functions(name: str) -> list[str]:
    """The functions that are not of the shared library, which takes vectors and matrices of any meaning apart."""
    parts = lowered(importlib.import_module(f"rovbrush.components.{name}.kernel")).parts
    return [found for p in parts if "library" not in p.path.parts for found in re.findall(r"^def (\w+)", p.text, re.M)]


def accesses(text: str) -> Iterator[tuple[str, str]]:
    """(array, index) of each element; of a matrix each index by itself."""
    yield from re.findall(r"(\w+)\[([^\[\]]+)\]", text)
    for array, row, column in re.findall(r"\bAT\((\w+), ([^,]+?), ([^,]+?)\)(?= [-+*/=)]|[;,)]| )", text):
        yield array, row
        yield array, column


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", COMPONENTS)
def test_no_index_in_the_c_of_a_component_stands_for_a_name(name: str) -> None:
    own, made = own_functions(name), functions(c_text(name))
    seen = 0
    for function in own:
        for array, index in accesses(made[function]):
            seen += 1
            where = f"{name}: {function}: {array}[{index}]"
            named = re.fullmatch(r"[A-Z]\w*_\w+(?: \+ (.+))?", index)
            rest = (named[1] or "0") if named else index
            if rest.isdigit():
                assert int(rest) < COMPONENTS_OF_A_VECTOR, where
            else:
                assert not [n for n in re.findall(r"(?<![\w.*])(?<!\* )(\d+)(?! \*)", rest) if int(n) > 1], where
    assert seen > 4


@pytest.mark.parametrize("name", COMPONENTS)
def test_cells_of_outputs_are_named_as_the_outputs_are(name: str) -> None:
    at = 0
    for variable in component(name).outputs:
        assert re.search(
            rf"^    Outputs_{variable.name} = {at}, /\* .*{re.escape(variable.description)} ", c_text(name), re.M
        )
        at += len(variable.start)
    for function in functions(c_text(name)).values():
        if re.search(r"double \*restrict y\b", function):
            assert all(index.startswith("Outputs_") for array, index in accesses(function) if array == "y")


@pytest.mark.parametrize("name", COMPONENTS)
def test_the_numbers_of_equations_stay(name: str) -> None:
    written: Counter[str] = Counter()
    for part in lowered(importlib.import_module(f"rovbrush.components.{name}.kernel")).parts:
        text = part.path.read_text(encoding="utf-8")
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.COMMENT:
                written.update(re.findall(r"Eqs?\. [\d, -]*\d", token.string))
    made = Counter(re.findall(r"Eqs?\. [\d, -]*\d", "".join(re.findall(r"/\* (.*?) \*/", c_text(name)))))
    assert not {number: times for number, times in written.items() if made[number] < times}


def test_an_error_of_pyccel_points_at_the_line_of_the_source(tmp_path: Path) -> None:
    (tmp_path / "pointing").mkdir()
    (tmp_path / "pointing" / "kernel.py").write_text(
        '"""A kernel."""\n\n\ndef step(h: float, n: int) -> float:\n    """Too much."""\n    a = h + 1.0  # Eq. 1\n'
        '    return a + "no number"\n'
    )
    spec = importlib.util.spec_from_file_location("pointing.kernel", tmp_path / "pointing" / "kernel.py")
    assert spec is not None and spec.loader is not None
    kernel = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(kernel)
    with pytest.raises(BuildError, match=r"Pyccel cannot translate pointing\.kernel") as caught:
        kernel_in_c(kernel)
    assert f"{tmp_path / 'pointing' / 'kernel.py'}:7" in str(caught.value)
