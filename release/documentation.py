"""The built documentation as a wheel carries it: pages, and the licences of what makes them look as they do."""

from __future__ import annotations

import shutil
import subprocess
import sys
from importlib.metadata import files
from pathlib import Path

from .sources import ROOT

LEFT_OUT = shutil.ignore_patterns("*.map", ".*")  # for those who mend the theme's scripts; Sphinx's own notes
# Their scripts and styles are in the pages; those of Bootstrap and Font Awesome bring their licences along, and the
# font STIX Two states its own (SIL OFL) within the file, as that licence allows.
IN_THE_PAGES = ("pydata-sphinx-theme", "Sphinx", "sphinx-copybutton", "sphinx-design", "myst-nb", "Pygments")


def build(folder: Path) -> None:
    """The site into `folder`, with warnings as errors."""
    made = folder.with_name(f"{folder.name}-made")
    command = [sys.executable, "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q", "-d", str(made / ".trees")]
    done = subprocess.run([*command, str(ROOT / "docs"), str(made)], check=False, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"the documentation failed:\n{done.stdout}{done.stderr}")
    shutil.copytree(made, folder, ignore=LEFT_OUT)
    shutil.rmtree(made)
    for name, text in licences().items():
        (folder / "_static" / f"LICENCE_{name}.txt").write_bytes(text)
    print("built the documentation", flush=True)


def licences() -> dict[str, bytes]:
    """The texts of the licences, by package."""
    found = {}
    for package in IN_THE_PAGES:
        path = next(path for path in files(package) or () if path.name.upper().startswith("LICEN"))
        found[package] = Path(str(path.locate())).read_bytes()
    return found
