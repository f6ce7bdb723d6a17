"""A component -> native FMUs: C from its kernel, the generic FMI layer of `sources/`, compiled for every platform."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element, indent, tostring

import fmpy

from ..declare.model_description import GUID_PLACEHOLDER, model_description
from ..errors import BuildError
from ..python.building.archive import digest, documentation, write_archive
from ..python.building.build import carried, in_source
from .compile import OPTIONS, PLATFORMS, Platform, compile_library, compile_objects
from .description3 import build_description, model_description3
from .tables import Tables
from .translate import kernel_in_c

SOURCES = Path(__file__).parent / "sources"
HEADERS = Path(fmpy.__file__).parent / "c-code"  # the standard's own, with their licence in each
SHARED = ("instance.c", "state.c")
LAYERS = {"fmi2": ("fmi2.c",), "fmi3": ("fmi3.c", "fmi3_unsupported.c")}
STANDARD = {
    "fmi2": ("fmi2FunctionTypes.h", "fmi2Functions.h", "fmi2TypesPlatform.h"),
    "fmi3": ("fmi3FunctionTypes.h", "fmi3Functions.h", "fmi3PlatformTypes.h"),
}


def build_one_native(component: Path, folder: Path, rows: int, platforms: tuple[str, ...]) -> list[Path]:
    """Build `native/fmi2/<component>.fmu` and `native/fmi3/<component>.fmu` in `folder`; returns their paths.

    Raises BuildError where Pyccel or a compiler is missing, or refuses.
    """
    for name in platforms:
        if name not in PLATFORMS:
            raise BuildError(f"no platform '{name}'; there are {', '.join(PLATFORMS)}")
        PLATFORMS[name].compiler()
    with tempfile.TemporaryDirectory() as temporary:
        package, declared = carried(component, Path(temporary), rows)
        try:
            source = Tables(declared).source(kernel_in_c(declared.kernel))
        except BuildError as error:
            raise BuildError(in_source(str(error), Path(temporary) / package, component)) from None
        entries = {version: _entries(component, declared, source, version) for version in LAYERS}
        _sign(entries, component.name)
        for key in platforms:
            _compile(entries, component.name, PLATFORMS[key])
    return [
        write_archive(entries[version], folder / "native" / version / f"{component.name}.fmu") for version in LAYERS
    ]


def _entries(component: Path, declared: type[Any], source: str, version: str) -> dict[str, bytes]:
    """What is in the FMU beside its libraries."""
    name = component.name
    units = (f"{name}.c", *SHARED, *LAYERS[version])
    files = {unit: (SOURCES / unit).read_bytes() for unit in (*SHARED, *LAYERS[version], "component.h", "instance.h")}
    files |= {header: (HEADERS / header).read_bytes() for header in STANDARD[version]}
    files[f"{name}.c"] = source.encode()
    if version == "fmi3":
        files["buildDescription.xml"] = _text(build_description(name, units, OPTIONS))
        description = _text(model_description3(declared))
    else:
        description = _text(model_description(declared, units))
    entries = {f"sources/{key}": content for key, content in files.items()}
    return entries | {"modelDescription.xml": description, "documentation/index.html": documentation(component)}


def _sign(entries: dict[str, dict[str, bytes]], name: str) -> None:
    """The hash of all that both FMUs are made of, where they bear it: one, so that their kernels are one."""
    parts = {f"{version}/{key}": content for version, own in entries.items() for key, content in own.items()}
    token = f"{{{digest(parts | {'options': OPTIONS.encode()})}}}".encode()
    for own in entries.values():
        for key in ("modelDescription.xml", f"sources/{name}.c"):
            own[key] = own[key].replace(GUID_PLACEHOLDER.encode(), token)


def _compile(entries: dict[str, dict[str, bytes]], name: str, platform: Platform) -> None:
    """A library for a platform in each FMU; what they share, which takes the time, is compiled once."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for own in entries.values():
            for path, content in own.items():
                if path.startswith("sources/"):
                    (folder / Path(path).name).write_bytes(content)
        shared = compile_objects(folder, (f"{name}.c", *SHARED), platform)
        for version, own in entries.items():
            library = compile_library(folder, (*shared, *LAYERS[version]), platform)
            place = platform.fmi2 if version == "fmi2" else platform.fmi3
            own[f"binaries/{place}/{name}{platform.ending}"] = library


def _text(element: Element) -> bytes:
    indent(element)
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(element) + b"\n"
