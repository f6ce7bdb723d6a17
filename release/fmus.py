"""`make release`: one zip with every FMU, native and Python, and what its receiver needs to trust and run them."""

from __future__ import annotations

import hashlib
import tempfile
import zipfile
from pathlib import Path

from rovbrush.components.build import build_all
from rovbrush.components.declare.model_description import VERSION

from .licences import licences
from .sources import ROOT, build_native

DATE = (1980, 1, 1, 0, 0, 0)  # the same FMUs are the same zip
SUMS = "SHA256SUMS"


def main(folder: Path = ROOT / "dist") -> Path:
    """Build all FMUs into a folder that does not stay, and pack them. Raises BuildError without a compiler."""
    folder.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        built = Path(temporary)
        build_native(built)
        build_all(built)
        return pack(built, folder / f"rovbrush-fmus-{VERSION}.zip")


def pack(built: Path, target: Path) -> Path:
    """The FMUs of a folder with README, verify.c, recordings, licences and checksums, as one zip."""
    files = {path.relative_to(built).as_posix(): path.read_bytes() for path in sorted(built.rglob("*.fmu"))}
    beside = ROOT / "fmus"
    for path in (beside / "README.md", beside / "verify.c", *sorted((beside / "recordings").iterdir())):
        files[path.relative_to(beside).as_posix()] = path.read_bytes()
    files |= licences()
    files[SUMS] = "".join(f"{hashlib.sha256(c).hexdigest()}  {name}\n" for name, c in files.items()).encode()
    top = target.stem
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(f"{top}/{name}", DATE)
            entry.compress_type = zipfile.ZIP_STORED if name.endswith(".fmu") else zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content)
    print(f"wrote {target} ({target.stat().st_size / 1e6:.1f} MB); in it: sha256sum --check {SUMS}")
    return target


if __name__ == "__main__":
    main()
