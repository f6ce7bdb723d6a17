"""The packages, by their folders: components/ is rovbrush.components, orchestrator/ is rovbrush.orchestrator."""

from setuptools import find_packages, setup

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

setup(packages=PACKAGES, package_dir=FOLDERS)
