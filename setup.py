"""The packages, by their folders: components/ is rovbrush.components, orchestrator/ is rovbrush.orchestrator.

A wheel takes along what is in fmus/ when it is built: the native FMUs (`rovbrush build --native`; without them it is as
good, and its first run says `rovbrush build`), their recordings, verify.c and README. They are data, which an FMI
importer chooses a library from, so that the wheel fits every platform; an editable install has them where they are.
So it is with the documentation that is in build/docs then.
"""

import re
import shutil
import sys
import zipfile
from pathlib import Path

from setuptools import find_packages, setup
from setuptools.command.build_py import build_py

FOLDERS = {
    "rovbrush": "orchestrator/public",
    "rovbrush.components": "components",
    "rovbrush.orchestrator": "orchestrator",
}
PACKAGES = [
    "rovbrush",
    *(
        f"{name}.{found}" if found else name
        for name, folder in FOLDERS.items()
        if name != "rovbrush"
        for found in ("", *find_packages(folder, exclude=["public"]))
    ),
]
HERE = Path(__file__).parent
FMUS = HERE / "fmus"
DOCS = HERE / "build" / "docs"
ALWAYS = ("README.md", "verify.c", "recordings/*.csv", "recordings/*.opt")
BUILT = ("native/fmi2/*.fmu", "native/fmi3/*.fmu")


class WithFmus(build_py):
    """The packages, and beside them in rovbrush/fmus what is in fmus/, in rovbrush/docs the built pages."""

    def run(self) -> None:
        super().run()
        if not self.editable_mode:
            for source, target in self._beside():
                Path(target).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, target)

    def get_outputs(self, include_bytecode: bool = True) -> list[str]:
        return [*super().get_outputs(include_bytecode), *([] if self.editable_mode else [t for _, t in self._beside()])]

    def _beside(self) -> list[tuple[Path, str]]:
        """Every file with where it goes; no FMU and no documentation that another version built."""
        found = [path for pattern in ALWAYS for path in sorted(FMUS.glob(pattern))]
        built = [path for pattern in BUILT for path in sorted(FMUS.glob(pattern))]
        for path in built:
            if (by := made_by(path)) != (own := self.distribution.get_version()):
                print(f"left out: {path} was built by rovbrush {by}, this is {own}", file=sys.stderr)
            else:
                found.append(path)
        target = Path(self.build_lib, "rovbrush")
        pages = self._pages()
        return [(path, str(target / "fmus" / path.relative_to(FMUS))) for path in found] + [
            (path, str(target / "docs" / path.relative_to(DOCS))) for path in pages
        ]

    def _pages(self) -> list[Path]:
        """The files of the documentation, without what only its builder needs."""
        options = DOCS / "_static" / "documentation_options.js"
        if not options.is_file():
            return []
        if f"VERSION: '{self.distribution.get_version()}'" not in options.read_text(encoding="utf-8"):
            print(f"left out: {DOCS} is the documentation of another version; `make docs`", file=sys.stderr)
            return []
        files = (path for path in sorted(DOCS.rglob("*")) if path.is_file() and path.suffix != ".map")
        return [path for path in files if not any(part.startswith(".") for part in path.relative_to(DOCS).parts)]


def made_by(fmu: Path) -> str:
    """The version of rovbrush that built an FMU."""
    with zipfile.ZipFile(fmu) as archive:
        text = archive.read("modelDescription.xml").decode("utf-8")
    found = re.search(r'generationTool="rovbrush ([^" ]+)', text)
    return found[1] if found else "of another kind"


setup(packages=PACKAGES, package_dir=FOLDERS, cmdclass={"build_py": WithFmus})
