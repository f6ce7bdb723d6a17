"""What the tab key finds in a shell: systems, sweeps, components, what can be set, recorded or drawn.

It reads files by itself, quickly and without complaint: what a run needs is not loaded, and where
something is wrong there is nothing to offer. Shells evaluate what they are told, so that only plain names are.
"""

from __future__ import annotations

import re
import tomllib
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import typer

from ..system.file.shipped import SWEEPS, SYSTEMS, shipped_systems

Found = list[tuple[str, str]]  # words, and what is said of them
PLAIN = re.compile(r"[\w./+=,:\[\]*-]+")  # no quotes, spaces or signs that a shell takes for its own
SAID = re.compile(r"[^\w .,/()=-]")
LARGEST = 20_000_000  # bytes of a model description that is looked into
SETTABLE = ("parameter", "input", "structuralParameter")
RECORDABLE = ("output", "local", "parameter", "calculatedParameter")


def _offered(complete: Callable[[typer.Context], Iterable[tuple[str, str]]]) -> Callable[[typer.Context, str], Found]:
    """The words that begin as what is typed; none, if anything goes wrong."""

    def found(ctx: typer.Context, incomplete: str) -> Found:
        try:
            words = [(word, SAID.sub(" ", said)) for word, said in complete(ctx) if word.startswith(incomplete)]
        except Exception:  # a file that cannot be read is told by the command itself, not here
            return []
        return [(word, said) for word, said in words if PLAIN.fullmatch(word)]

    return found


def _data(path: Path) -> dict[str, Any]:
    return tomllib.loads(path.read_text(encoding="utf-8"))


def _described(paths: Iterable[Path]) -> Iterator[tuple[str, str]]:
    for path in paths:
        found = re.search(r'^description = "(.*)"', path.read_text(encoding="utf-8"), re.MULTILINE)
        yield path.stem, found[1] if found else ""


def _files(*endings: str) -> Iterator[tuple[str, str]]:
    """Files of the present folder."""
    for path in sorted(Path().iterdir()):
        if path.suffix.lower() in endings and not path.name.startswith("."):
            yield path.name, ""


def _systems(_: typer.Context) -> Iterator[tuple[str, str]]:
    yield from _described(SYSTEMS / f"{name}.toml" for name in shipped_systems())
    yield from _files(".toml", ".ssp", ".ssd", ".fmu")


def _sweeps(ctx: typer.Context) -> Iterator[tuple[str, str]]:
    yield from _described(sorted(SWEEPS.glob("*.toml")))
    yield from _systems(ctx)


def _copies(_: typer.Context) -> Iterator[tuple[str, str]]:
    yield from _described(SYSTEMS / f"{name}.toml" for name in shipped_systems())
    yield from _described(sorted(SWEEPS.glob("*.toml")))


def _sets(_: typer.Context) -> Iterator[tuple[str, str]]:
    for path in sorted(SYSTEMS.glob("*.toml")):
        tables = {key: value for key, value in _data(path).items() if key != "description"}
        if tables and "components" not in tables and all(isinstance(value, dict) for value in tables.values()):
            yield path.stem, ""


def _system_of(ctx: typer.Context) -> tuple[Path, dict[str, Any]]:
    """The file of the system that is typed already, or of that of a sweep, and what it says."""
    words = [word for word in ctx.args if not word.startswith("-")]  # not assigned yet behind an option without value
    name = str(words[0] if words else ctx.params.get("system") or ctx.params.get("name") or "")
    if (SWEEPS / f"{name}.toml").is_file():
        name = str(_data(SWEEPS / f"{name}.toml")["system"])
    path = Path(name) if name.endswith((".toml", ".fmu")) else SYSTEMS / f"{name}.toml"
    if path.suffix == ".fmu":
        return path, {"components": {path.stem: {"fmu": str(path.absolute())}}}
    data = _data(path)
    if "components" not in data and "system" in data:  # a sweep of one's own
        named = str(data["system"])
        path = path.parent / named if named.endswith(".toml") else SYSTEMS / f"{named}.toml"
        data = _data(path)
    return path, data


def _components(ctx: typer.Context) -> Iterator[tuple[str, str]]:
    for name, table in _system_of(ctx)[1]["components"].items():
        yield name, str(table.get("fmu", ""))


def _variables(path: Path, table: Mapping[str, Any], fmus: Path | None) -> Iterator[tuple[str, str, str, str]]:
    """Name, causality, start and description of the variables of a component's FMU."""
    from ..fmu.files.places import named_fmu

    stated = str(table["fmu"])
    file = path.parent / stated
    file = file if stated.endswith(".fmu") and file.is_file() else named_fmu(stated, fmus)
    with zipfile.ZipFile(file) as archive:
        if archive.getinfo("modelDescription.xml").file_size > LARGEST:
            return
        text = archive.read("modelDescription.xml")
    if b"<!DOCTYPE" in text or b"<!ENTITY" in text:
        return
    for one in ElementTree.fromstring(text).iterfind("ModelVariables/*"):
        kind = one[0].attrib if one.tag == "ScalarVariable" and len(one) else {}
        start = one.attrib.get("start", kind.get("start", ""))
        said = f"{one.attrib.get('description', '')} {kind.get('unit', one.attrib.get('unit', ''))}".strip()
        yield one.attrib["name"], one.attrib.get("causality", "local"), start, said


def _named(ctx: typer.Context, causalities: tuple[str, ...]) -> Iterator[tuple[str, str, str]]:
    """`component.variable`, its value and what is said of it; inputs that are driven are left out."""
    path, data = _system_of(ctx)
    fmus = ctx.params.get("fmus")
    driven = {re.sub(r"\s*\(.*", "", text.partition("->")[2]).strip() for text in data.get("connections", ())}
    shared: dict[str, Any] = {}
    if isinstance(data.get("parameters"), str):
        beside = path.parent / f"{data['parameters']}.toml"
        shared = _data(beside if beside.is_file() else SYSTEMS / f"{data['parameters']}.toml")
    for owner, table in data["components"].items():
        values = {**shared.get(owner, {}), **table.get("parameters", {}), **table.get("inputs", {})}
        for name, causality, start, said in _variables(path, table, Path(fmus) if fmus else None):
            if causality in causalities and f"{owner}.{name}" not in driven:
                yield f"{owner}.{name}", str(values.get(name, start)), said


def _settable(ctx: typer.Context) -> Iterator[tuple[str, str]]:
    """With the value that it has, to be changed."""
    for name, value, said in _named(ctx, SETTABLE):
        yield f"{name}={value}".replace(" ", ""), said


def _varied(ctx: typer.Context) -> Iterator[tuple[str, str]]:
    """From a fifth below the value that it has to a fifth above, in five points."""
    for name, value, said in _named(ctx, SETTABLE):
        try:
            low, high = sorted((0.8 * float(value), 1.2 * float(value)))
        except ValueError:
            continue
        yield (f"{name}={low:g}:{high:g}:5" if low < high else f"{name}=0:1:5"), said


def _recorded(ctx: typer.Context) -> Iterator[tuple[str, str]]:
    for owner, said in _components(ctx):
        yield f"{owner}.*", f"all outputs of {said}"
    for name, _, said in _named(ctx, RECORDABLE):
        yield name, said


def _drawn(ctx: typer.Context) -> Iterator[tuple[str, str]]:
    """What is in the results folder that is typed already, the first of several: signals, or a sweep's figures."""
    from ..results.names import names_in

    given = ctx.params.get("folder") or ctx.params.get("folders") or ctx.args
    folder = Path(given[0] if isinstance(given, list | tuple) else given)
    found = list(names_in(next(path for path in (folder / "result.nc", folder / "sweep.nc") if path.is_file())))
    for owner in dict.fromkeys(name.partition(".")[0] for name, _ in found if "." in name):
        yield f"{owner}.*", f"all signals of {owner}"
    yield from found


def _assigned(ctx: typer.Context) -> Iterator[tuple[str, str]]:
    for name, said in _components(ctx):
        yield f"{name}=", said


systems, sweeps, copies, sets = map(_offered, (_systems, _sweeps, _copies, _sets))
settable, varied, recorded, drawn = map(_offered, (_settable, _varied, _recorded, _drawn))
components, assigned = map(_offered, (_components, _assigned))
