"""`make wheel`: the native FMUs and the documentation, then the wheel that carries them and the source distribution."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from . import documentation, loop
from .sources import ROOT, build_native, copy

BUILD = "import sys; from setuptools import build_meta as b; getattr(b, sys.argv[1])(sys.argv[2])"
EPOCH = "315532800"  # 1980-01-01, as in the FMUs: the same sources are the same wheel


def main(folder: Path = ROOT / "dist") -> None:
    folder.mkdir(exist_ok=True)
    for old in (*folder.glob("*.whl"), *folder.glob("*.tar.gz")):
        old.unlink()
    with tempfile.TemporaryDirectory() as temporary:
        source = Path(temporary)
        copy(source)
        build_native(source / "fmus")
        loop.build(source / "orchestrator" / "loop" / "machine" / "libraries")
        documentation.build(source / "build" / "docs")
        for kind in ("build_sdist", "build_wheel"):
            environment = {**os.environ, "SOURCE_DATE_EPOCH": EPOCH}
            command = [sys.executable, "-c", BUILD, kind, str(folder.resolve())]
            done = subprocess.run(command, cwd=source, env=environment, check=False, capture_output=True, text=True)
            if done.returncode:
                sys.exit(f"{kind} failed:\n{done.stdout}{done.stderr}")
    made = sorted(folder.glob("rovbrush-*"))
    for path in made:
        print(f"wrote {path} ({path.stat().st_size / 1e6:.1f} MB)")
    subprocess.run([sys.executable, "-m", "twine", "check", "--strict", *map(str, made)], check=True)


if __name__ == "__main__":
    main()
