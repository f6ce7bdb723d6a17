"""Small native FMUs in C, for benchmarks and tests: compiled by gcc against the FMI headers that fmpy ships."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import fmpy

from ....errors import RunError

HEADERS = Path(fmpy.__file__).parent / "c-code"
SOURCES = Path(__file__).parent / "sources"
DATE = (2000, 1, 1, 0, 0, 0)  # of every entry: the same content is the same file


def compiler() -> str | None:
    """The C compiler, if there is one."""
    return shutil.which("gcc") or shutil.which("cc")


def native_fmu(
    target: Path, sources: Iterable[Path], xml: str, version: int, defines: Mapping[str, object] | None = None
) -> Path:
    """Compile `sources` and pack them with their model description; the model identifier is the name of `target`.

    Raises RunError if there is no compiler or it refuses.
    """
    gcc = compiler()
    if gcc is None:
        raise RunError("no C compiler found; install gcc")
    platform = fmpy.platform_tuple if version == 3 else fmpy.platform
    options = [f"-D{key}={value}" for key, value in (defines or {}).items()]
    command = [gcc, "-O2", "-fPIC", "-shared", "-s", f"-I{HEADERS}", f"-I{SOURCES}", *options]
    try:
        library = compiled(command, list(sources))
    except subprocess.CalledProcessError as error:
        raise RunError(f"{target.name} cannot be compiled: {error.stderr.strip()}") from None
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in (
            ("modelDescription.xml", xml.encode()),
            (f"binaries/{platform}/{target.stem}{fmpy.sharedLibraryExtension}", library),
        ):
            archive.writestr(zipfile.ZipInfo(name, DATE), content, zipfile.ZIP_DEFLATED)
    return target


def compiled(command: Sequence[str], sources: Sequence[Path]) -> bytes:
    """The library that a compiler with its options makes of C sources; raises CalledProcessError if it refuses."""
    with tempfile.TemporaryDirectory() as folder:
        library = Path(folder) / "library"
        whole = [*command, *map(str, sources), "-lm", "-o", str(library)]
        subprocess.run(whole, capture_output=True, text=True, check=True)
        return library.read_bytes()


def description2(name: str, variables: Iterable[str], outputs: Iterable[int], flags: str = "") -> str:
    """A model description of FMI 2.0: `variables` are ScalarVariable elements, `outputs` their indices from 1."""
    indices = list(outputs)
    unknowns = "".join(f'<Unknown index="{k}"/>' for k in indices)
    structure = f"<Outputs>{unknowns}</Outputs><InitialUnknowns>{unknowns}</InitialUnknowns>" if indices else ""
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="2.0" modelName="{name}" '
        f'guid="{name}">\n<CoSimulation modelIdentifier="{name}" canHandleVariableCommunicationStepSize="true" '
        f'canGetAndSetFMUstate="true" canSerializeFMUstate="true" {flags}/>\n'
        f"<ModelVariables>\n{chr(10).join(variables)}\n</ModelVariables>\n"
        f"<ModelStructure>{structure}</ModelStructure>\n</fmiModelDescription>\n"
    )


def feedthrough(target: Path, signals: int = 1) -> Path:
    """An FMI 2.0 FMU with inputs u[1].. and outputs y[1].. (u and y for one signal): y = u after every step."""
    names = [f"[{k + 1}]" for k in range(signals)] if signals > 1 else [""]
    variables = [
        f'<ScalarVariable name="u{n}" valueReference="{k}" causality="input" variability="continuous">'
        f'<Real start="0"/></ScalarVariable>'
        for k, n in enumerate(names)
    ] + [
        f'<ScalarVariable name="y{n}" valueReference="{signals + k}" causality="output" variability="continuous" '
        f'initial="calculated"><Real/></ScalarVariable>'
        for k, n in enumerate(names)
    ]
    xml = description2(target.stem, variables, range(signals + 1, 2 * signals + 1))
    return native_fmu(target, [SOURCES / "feedthrough.c"], xml, 2, {"SIGNALS": signals})


def ring(
    folder: Path, components: int, signals: int = 1, stop: str = "10 s", period: str = "1 ms", closed: bool = True
) -> Path:
    """A system file: `components` feedthrough FMUs in a ring, every one driven by the one before it; if it is not
    `closed`, nothing drives the first.

    It states no format, so that older versions, which this one is compared with, read it too.
    """
    feedthrough(folder / f"feedthrough{signals}.fmu", signals)
    path = folder / f"ring_{components}_{signals}.toml"
    sources = range(components if closed else components - 1)
    wires = "".join(f'  "c{k}.y -> c{(k + 1) % components}.u",\n' for k in sources)
    tables = "".join(
        f'[components.c{k}]\nfmu = "feedthrough{signals}.fmu"\nperiod = "{period}"\n' for k in range(components)
    )
    path.write_text(
        f'description = "{components} native feedthrough FMUs of {signals} signals in a ring"\n'
        f'stop_time = "{stop}"\n'
        f"connections = [\n{wires}]\n{tables}",
        encoding="utf-8",
    )
    return path
