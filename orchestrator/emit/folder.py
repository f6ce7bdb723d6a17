"""`rovbrush export SYSTEM --c DIR`: a system as a C library and a program, with no FMI around it."""

from __future__ import annotations

from pathlib import Path

from ..errors import InputError, listed
from ..files import prepare_folder
from ..system.model import System
from .carried import resources_of
from .compiling import OPTIONS
from .prepared import Prepared, is_text, prepared
from .units import headers, write_files


def write_c(system: System, folder: Path) -> list[str]:
    """Write the files of a system into a folder that is empty, or holds such files; notes for the user.

    Raises InputError for what is not written as C, and for a component without C sources.
    """
    with prepared(system, carries=False) as found:
        files = files_of(found)
        _require_own(folder, found.code.name)
        prepare_folder(folder, "--c")
        program = {found.code.main: found.code.files[found.code.main]}
        write_files(folder, files | program | {"Makefile": _makefile(found), "README.md": _readme(found)})
        for unit in found.code.units:
            write_files(folder / "resources", resources_of(unit))
        step, whole = found.code.cycle.step, found.code.cycle.whole
        texts = [name for name in system.record if is_text(system, name)]
        return [
            *([f"not among the rows, which are numbers: {listed(texts)}"] if texts else []),
            f"a step costs at most {step.arithmetic} floating-point operations and {step.calls} calls of components, a "
            f"hyperperiod {whole.arithmetic} and {whole.calls}, beside what the components do themselves",
            f"`make -C {folder}` makes the program {found.code.name}_run, which writes its rows as CSV",
        ]


def files_of(found: Prepared) -> dict[str, bytes]:
    """All C files of a system, by path; without its program."""
    files = {path: text for path, text in found.code.files.items() if path != found.code.main}
    for unit in found.code.units:
        files |= unit.texts
    return files | headers(unit.version for unit in found.code.units)


def _require_own(folder: Path, name: str) -> None:
    """Raise InputError for a folder that holds what was not exported there."""
    if folder.is_dir() and any(folder.iterdir()) and not (folder / f"{name}_inside.h").is_file():
        raise InputError(f"--c {folder}: the folder is not empty, and holds no exported {name}; name another one")
    if folder.exists() and not folder.is_dir():
        raise InputError(f"--c {folder} is a file; name a folder")


def _readme(found: Prepared) -> bytes:
    """What the folder holds, how it is built and used, and what a step costs."""
    name, cycle, plan = found.code.name, found.code.cycle, found.plan
    rows = "\n".join(
        f"| {what} | {cost.arithmetic} | {cost.calls} | {cost.moves} |"
        for what, cost in (("a step, from an instant to the next", cycle.step), ("a hyperperiod", cycle.whole))
    )
    more = ""
    if plan.system.events:
        more += " An event costs a part of a step of each component that is brought to it, and values passed on there."
    if plan.algorithm.saves_states:
        more += " Steps are repeated: the states of components are kept and restored, which may allocate memory."
    if plan.adaptive:
        more += " The counts are those of one try of a macro step, whose length it chooses itself."
    text = f"""# {plan.system.name} in C

{plan.system.description}

`make` builds the library `lib{name}.a` and the program `{name}_run`, which runs the system from its start to its stop
and writes the rows of every rate as CSV: `./{name}_run [FOLDER] [NAME=VALUE]...`; with `--speed` it writes none and
says how many times real time it is. `{name}.h` says how the library is used; `{name}.c` is the plan, with a function
for what begins and one for what ends at an instant; `components/` holds the sources of the components under names of
their own.

Worst case, counted from the plan; what components do inside of their functions comes on top:

| | floating-point operations | calls of FMI functions | values moved |
| --- | --- | --- | --- |
{rows}
{more}
A system is one variable, with {len(plan.system.components)} components and {plan.layout.size} cells. The library
itself allocates nothing behind `{name}_start` but where texts are set. Compile without fused multiply-add
(`-ffp-contract=off`, as the Makefile does) where bits matter.
"""
    return text.encode()


def _makefile(found: Prepared) -> bytes:
    name = found.code.name
    options = {file: own for unit in found.code.units for file, own in unit.options.items()}
    sources = [*found.code.compiled, *options]
    lines = [
        f"# {name}_run: the program; lib{name}.a: all but its main function.",
        "CC ?= gcc",
        f"CFLAGS = {' '.join(OPTIONS)} -I.",
        f"OBJECTS = {' '.join(source[:-2] + '.o' for source in sources)}",
        "",
        f"{name}_run: {found.code.main[:-2]}.o lib{name}.a",
        f"\t$(CC) -o $@ {found.code.main[:-2]}.o lib{name}.a -lm",
        "",
        f"lib{name}.a: $(OBJECTS)",
        "\t$(AR) rcs $@ $(OBJECTS)",
        "",
        "%.o: %.c",
        "\t$(CC) $(CFLAGS) $(OWN) -c $< -o $@",
        "",
        *(f"{file[:-2]}.o: OWN = {' '.join(own)}" for file, own in options.items()),
        "",
        "clean:",
        f"\trm -f {name}_run lib{name}.a {found.code.main[:-2]}.o $(OBJECTS)",
        "",
    ]
    return "\n".join(lines).encode()
