"""An FMU from a script of pythonfmu's, as anybody writes one: the same bytes from the same text."""

from __future__ import annotations

import re
import tempfile
import zipfile
from pathlib import Path

from ...declare.model_description import GUID_PLACEHOLDER
from ...errors import BuildError
from .archive import repack

# pythonfmu 0.7.0 executes the script for every instance and then drops a reference to its namespace that it does not
# own: without this the second instance fails and the process crashes at its end.
KEPT = "\n\nimport ctypes as _ctypes\n\n_ctypes.pythonapi.Py_IncRef(_ctypes.py_object(globals()))\n"
CHANGING = (  # what pythonfmu makes anew in each build
    (rb'generationDateAndTime="[^"]*"', b'generationDateAndTime="1980-01-01T00:00:00Z"'),
    (rb'guid="[^"]*"', b'guid="' + GUID_PLACEHOLDER.encode() + b'"'),
)


def build_script(script: Path, folder: Path) -> Path:
    """Build `folder`/NAME.fmu from NAME.py in this process. Raises BuildError with what the script has raised."""
    from pythonfmu.builder import FmuBuilder

    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        copy = work / script.name
        try:
            copy.write_text(script.read_text(encoding="utf-8") + KEPT, encoding="utf-8")
            raw = Path(FmuBuilder.build_FMU(copy, work / "raw.fmu"))
        except SyntaxError as error:
            raise BuildError(f"{script}:{error.lineno}: {error.msg}") from error
        except Exception as error:  # the script's own
            raise BuildError(f"{script}: {type(error).__name__}: {error}") from error
        return repack(_without_date(raw), folder / f"{script.stem}.fmu")


def _without_date(raw: Path) -> Path:
    """The archive, once more, with a date and an identity that are always the same."""
    again = raw.with_name("again.fmu")
    with zipfile.ZipFile(raw) as archive, zipfile.ZipFile(again, "w") as written:
        for name in archive.namelist():
            content = archive.read(name)
            if name == "modelDescription.xml":
                for pattern, fixed in CHANGING:
                    content = re.sub(pattern, fixed, content, count=1)
            written.writestr(name, content)
    return again
