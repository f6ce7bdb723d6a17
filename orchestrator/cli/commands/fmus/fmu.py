"""The commands that show an FMU: what is in it, and how its names could stand for a component's."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any

import typer

from ...console import print_table, tell
from ...options import app

SHOWN = 30  # variables of a causality, where not all are asked for


@app.command()
def info(
    fmu: Annotated[Path, typer.Argument(metavar="FMU", help="The file to look into, FMI 1.0, 2.0 or 3.0.")],
    json_: Annotated[bool, typer.Option("--json", help="As JSON, everything.")] = False,
    all_: Annotated[bool, typer.Option("--all", help="Every variable, however many there are.")] = False,
) -> None:
    """Show what is in an FMU: variables with types, units, ranges and starts, capabilities, platforms, experiment."""
    from ....errors import counted
    from ....files import typed
    from ....fmu.contents import contents_of, in_order, readable

    read, why = readable(fmu)
    found = contents_of(read)
    if json_:
        print(json.dumps(found, indent=1, ensure_ascii=False))
        return
    told = " ".join((found["description"] or "").split())
    tell(f"{found['file']}: {found['model']}, FMI {found['fmi']}{f': {told}' if told else ''}")
    for key in ("tool", "author", "version"):
        if found[key]:
            tell(f"  {key:<13} {found[key]}")
    tell(f"  {'interfaces':<13} {', '.join(found['interfaces'])}")
    platforms = [*found["platforms"], *(["sources"] if found["sources"] else [])]
    tell(f"  {'platforms':<13} {', '.join(platforms) or 'none'}")
    experiment = ", ".join(f"{name} {value:g}{'' if name == 'tolerance' else ' s'}"
                           for name, value in found["experiment"].items())  # fmt: skip
    tell(f"  {'experiment':<13} {experiment or 'none stated'}")
    flags = (key if value in (True, "true") else f"{key} = {value}" for key, value in found["capabilities"].items())
    tell(f"  {'capabilities':<13} {', '.join(flags) or 'none'}")
    if equations := found["equations"]:
        tell(f"  {'equations':<13} {', '.join(counted(n, what.removesuffix('s')) for what, n in equations.items())}")
    if read.notes:
        broken = counted(len(read.notes), "point")
        tell(f"  {'standard':<13} broken in {broken}: `rovbrush check {typed(fmu)}` lists them")
    if not why and read.windows:
        tell(f"  {'run here':<13} by wine, in a process of its own ({read.windows})")
    if why:
        tell(f"  {'not run here':<13} {why}")
    for causality, variables in in_order(found["variables"]).items():
        shown = variables if all_ else variables[:SHOWN]
        more = f" ({len(shown)} of {len(variables)}; --all shows the others)" if len(shown) < len(variables) else ""
        cells = [(v["name"], _type(v), _unit(v), _range(v), _start(v), _told(v)) for v in shown]
        headings = ("name", "type", "unit", "range", "start", "description")
        print_table(f"{causality}{more}", headings, cells, words=(0, 1, 2, 3, 4, 5))
    for terminal in found["terminals"]:
        _show_terminal(terminal)


def _show_terminal(terminal: dict[str, Any]) -> None:
    cells = [(m["name"], m["variable"], m["kind"]) for m in terminal["members"]]
    for stream in terminal["streams"]:
        cells += [(stream[side]["name"], stream[side]["variable"], f"{side}flowing stream") for side in ("in", "out")]
    words = (f"matched by {terminal['matchingRule']}", terminal["terminalKind"], terminal["description"])
    print_table(
        f"terminal {terminal['name']}: {', '.join(filter(None, words))}", ("member", "variable", "kind"), cells,
        words=(0, 1, 2),
    )  # fmt: skip


def _type(v: dict[str, Any]) -> str:
    sizes = zip(v.get("dimensions", ()), v.get("shape", ()), strict=True)
    shape = ",".join(f"{name} = {size}" if name else str(size) for name, size in sizes)
    shape = f"[{shape}]" if shape else ""
    usual = "fixed" if v["causality"] == "parameter" else "continuous"
    named = v["variability"] not in (None, usual) and not (v["type"] not in ("Real", "Float64") and usual)
    return f"{v['type']}{shape}{', ' + v['variability'] if named else ''}"


def _unit(v: dict[str, Any]) -> str:
    shown = v.get("displayUnit")
    return f"{v['unit'] or '1'}, shown in {shown}" if shown else v["unit"] or ""


def _told(v: dict[str, Any]) -> str:
    """Its description, of which variable it is another name, and what there is to know of a clock or a binary."""
    words = [f"alias of {v['alias']}"] if "alias" in v else []
    words += [f"{key} = {value}" for key, value in v.get("further", {}).items()]
    words += [f"clocked by {', '.join(v['clocks'])}"] if "clocks" in v else []
    return "; ".join(filter(None, [" ".join((v["description"] or "").split()), *words]))


def _range(v: dict[str, Any]) -> str:
    if "items" in v:
        return ", ".join(f"{name} ({number})" for name, number in v["items"].items())
    low, high = v["min"], v["max"]
    if low is None and high is None:
        return ""
    return f"{'' if low is None else f'{low:g}'} .. {'' if high is None else f'{high:g}'}".strip()


def _start(v: dict[str, Any]) -> str:
    start = v["start"]
    text = " ".join(map(json.dumps, start)) if isinstance(start, list) else "" if start is None else str(start)
    return text if len(text) <= 40 else f"{text[:37]}..."


@app.command("map")
def map_(
    fmu: Annotated[Path, typer.Argument(metavar="FMU", help="The file whose names are looked for.")],
    component: Annotated[str, typer.Option("--as", metavar="NAME", help="The component that it is to stand for.")],
    out: Annotated[Path | None, typer.Option("--out", metavar="FILE", help="Write it there, for --map.")] = None,
) -> None:
    """Print a mapping file to begin with: the nearest names, to be checked by whoever knows the FMU."""
    from ....exchange.component_tests.skeleton import skeleton
    from ....exchange.component_tests.suites import suite_of
    from ....files import prepare_folder, write_file
    from ....fmu.fmu import Fmu

    text = skeleton(Fmu.open(fmu), suite_of(component))
    if out is None:
        print(text, end="")
        return
    prepare_folder(out.absolute().parent)
    tell(f"wrote {write_file(out, lambda path: path.write_text(text, encoding='utf-8'))}")
