"""The packages, by their folders: components/ is rovbrush.components, orchestrator/ is rovbrush.orchestrator.

A wheel takes along what is in fmus/ when it is built: the native FMUs (`rovbrush build --native`; without them it is as
good, and its first run says `rovbrush build`), their recordings, verify.c and README. They are data, which an FMI
importer chooses a library from, so that the wheel fits every platform; an editable install has them where they are.
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
ALWAYS = ("README.md", "verify.c", "recordings/*.csv", "recordings/*.opt")
BUILT = ("native/fmi2/*.fmu", "native/fmi3/*.fmu")


class WithFmus(build_py):
    """The packages, and beside them in rovbrush/fmus what is in fmus/."""

    def run(self) -> None:
        super().run()
        if not self.editable_mode:
            for source, target in self._fmus():
                Path(target).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, target)

    def get_outputs(self, include_bytecode: bool = True) -> list[str]:
        return [*super().get_outputs(include_bytecode), *([] if self.editable_mode else [t for _, t in self._fmus()])]

    def _fmus(self) -> list[tuple[Path, str]]:
        """Every file with where it goes; no FMU that another version built."""
        found = [path for pattern in ALWAYS for path in sorted(FMUS.glob(pattern))]
        built = [path for pattern in BUILT for path in sorted(FMUS.glob(pattern))]
        for path in built:
            if (by := made_by(path)) != (own := self.distribution.get_version()):
                print(f"left out: {path} was built by rovbrush {by}, this is {own}", file=sys.stderr)
            else:
                found.append(path)
        return [(path, str(Path(self.build_lib, "rovbrush", "fmus", path.relative_to(FMUS)))) for path in found]


def made_by(fmu: Path) -> str:
    """The version of rovbrush that built an FMU."""
    with zipfile.ZipFile(fmu) as archive:
        text = archive.read("modelDescription.xml").decode("utf-8")
    found = re.search(r'generationTool="rovbrush ([^" ]+)', text)
    return found[1] if found else "of another kind"


setup(packages=PACKAGES, package_dir=FOLDERS, cmdclass={"build_py": WithFmus})
