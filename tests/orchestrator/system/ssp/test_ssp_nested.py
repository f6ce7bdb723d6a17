"""Systems from elsewhere in a component's place: .ssp and .ssd files in an SSP, and systems of the same file again."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.ssp.files import rules
from ssp_files import (
    GAINS,
    Read,
    bindings,
    component,
    connection,
    connectors,
    document,
    inline,
    real,
    system,
    write_ssp_file,
)  # fmt: skip

HEAD = connectors(**{"in": "input", "out": "output"}) + bindings(inline(real("b.k", "2")))
INNER = system(component("b", "gain"), connection("in", "b.u") + connection("b.y", "out"), head=HEAD)
WIRES = connection("a.y", "sub.in") + connection("sub.out", "c.u")
ENDS = component("a", "gain") + component("c", "gain")
PACKAGE, DEFINITION = "application/x-ssp-package", "application/x-ssp-definition"


def part(source: str, type_: str = "", inside: str = "", name: str = "sub") -> str:
    typed = f' type="{type_}"' if type_ else ""
    return f'<ssd:Component name="{name}" source="{source}"{typed}>{inside}</ssd:Component>'


@pytest.fixture
def packed(tmp_path: Path, fmus: Path) -> bytes:
    """A .ssp of the inner system, with a second structure."""
    other = document(system(component("other", "gain"), head=connectors(**{"in": "input", "out": "output"})))
    return write_ssp_file(tmp_path / "inner.ssp", fmus, document(INNER), ("gain",), {"B.ssd": other}).read_bytes()


def added(path: Path, name: str, content: bytes) -> Path:
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr(name, content)
    return path


@pytest.mark.parametrize("type_", [PACKAGE, ""])
def test_a_nested_package_is_the_system_that_is_in_it(type_: str, packed: bytes, tmp_path: Path, fmus: Path) -> None:
    text = document(system(ENDS + part("resources/inner.ssp", type_), WIRES))
    path = added(write_ssp_file(tmp_path / "case.ssp", fmus, text, ("gain",)), "resources/inner.ssp", packed)
    found = load_system(str(path))
    assert sorted(c.label for c in found.connections) == ["a.y -> sub_b.u", "sub_b.y -> c.u"]
    assert found.components["sub_b"].parameters == {"k": 2.0}
    assert [note.rule for note in found.breaches] == ([] if type_ else [rules.KIND_OF_SOURCE])


def test_bindings_of_the_component_come_after_those_in_it(packed: bytes, tmp_path: Path, fmus: Path) -> None:
    text = document(system(part("inner.ssp", PACKAGE, bindings(inline(real("b.k", "3"))))))
    path = added(write_ssp_file(tmp_path / "case.ssp", fmus, text, ()), "inner.ssp", packed)
    assert load_system(str(path)).components["sub_b"].parameters == {"k": 3.0}


def test_a_fragment_names_the_structure_of_a_nested_package(packed: bytes, tmp_path: Path, fmus: Path) -> None:
    def reading(fragment: str) -> set[str]:
        text = document(system(part(f"inner.ssp#{fragment}", PACKAGE)))
        path = added(write_ssp_file(tmp_path / f"{fragment}.ssp", fmus, text, ()), "inner.ssp", packed)
        return set(load_system(str(path)).components)

    assert reading("B.ssd") == {"sub_other"}
    with pytest.raises(InputError, match=r"inner\.ssp has no structure 'C\.ssd'"):
        reading("C.ssd")


def test_an_ssd_in_a_component_starts_its_sources_where_it_is(read: Read) -> None:
    inner = document(INNER.replace("resources/gain", "gain"))
    found = read(
        document(system(ENDS + part("resources/inner.ssd", DEFINITION), WIRES)), {"resources/inner.ssd": inner}
    )
    assert sorted(c.label for c in found.connections) == ["a.y -> sub_b.u", "sub_b.y -> c.u"]


def test_a_system_is_taken_again_by_its_id(read: Read) -> None:
    original = INNER.replace('name="whole"', 'name="first" id="core"')
    top = system(original + part("#core", DEFINITION, name="second"), connection("first.out", "second.in"))
    found = read(document(top))
    assert [c.label for c in found.connections] == ["first_b.y -> second_b.u"]
    assert [c.parameters for c in found.components.values()] == [{"k": 2.0}] * 2


@pytest.mark.parametrize("source", ["SystemStructure.ssd", "#all", "resources/a.ssd"])
def test_what_holds_itself_is_an_error(source: str, read: Read) -> None:
    top = document(system(part(source, DEFINITION)).replace('name="whole"', 'name="whole" id="all"'))
    files = {"resources/a.ssd": top.replace("resources/a.ssd", "a.ssd")}
    with pytest.raises(InputError, match=r"component 'sub': it holds itself; take that source out \(case\.ssp/"):
        read(top, files)


def test_systems_that_double_with_every_level_are_an_error(read: Read) -> None:
    levels = [system(part(f"#l{n + 1}", DEFINITION, name="x") + part(f"#l{n + 1}", DEFINITION, name="y"), name=f"l{n}")
              .replace("<ssd:System ", f'<ssd:System id="l{n}" ') for n in range(40)]  # fmt: skip
    last = system(component("a", "gain"), name="l40").replace("<ssd:System ", '<ssd:System id="l40" ')
    with pytest.raises(InputError, match="there are more than 10000 elements"):
        read(document(system("".join(levels) + last), version="2.0"))


def test_a_nested_package_may_use_what_is_beside_it_and_nothing_further_up(tmp_path: Path, fmus: Path) -> None:
    def reading(source: str) -> set[str]:
        inner = write_ssp_file(
            tmp_path / "inner.ssp", fmus, document(system(f'<ssd:Component name="b" source="{source}"/>')), ()
        )
        text = document(system(part("resources/inner.ssp", PACKAGE)))
        path = write_ssp_file(tmp_path / "case.ssp", fmus, text, ("gain",))
        return set(load_system(str(added(path, "resources/inner.ssp", inner.read_bytes()))).components)

    assert reading("../gain.fmu") == {"sub_b"}
    with pytest.raises(InputError, match=r"'\.\./\.\./\.\./gain\.fmu' leaves the folder of the SSP"):
        reading("../../../gain.fmu")


def test_values_reach_nested_systems_by_their_names(packed: bytes, tmp_path: Path, fmus: Path) -> None:
    text = document(system(part("inner.ssp", PACKAGE) + GAINS, head=bindings(inline(real("sub.b.k", "5")))))
    path = added(write_ssp_file(tmp_path / "case.ssp", fmus, text, ("gain",)), "inner.ssp", packed)
    assert load_system(str(path)).components["sub_b"].parameters == {"k": 5.0}
