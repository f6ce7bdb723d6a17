"""The pictures of the gallery and of the README, made anew by the commands that they show: `make pictures`."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image

HERE = Path(__file__).parent
COLOURS = 64  # a picture of a few lines has no more, and is then a third as large
PICTURES = {  # by system: figures that its run draws, and what they are called here
    "nominal": {"fig2_mode_shapes": "modes", "fig3_normal_force": "force", "fig4_brush_torque": "torque"},
    "hull_pass": {"pass": "pass", "brush": "pass_brush"},
    "counter_rotating": {"pass": "two_rollers"},
    "cleaning_map": {"cleaning_map": "cleaning_map"},
    "jam": {"jam": "jam"},
    "open_water": {"reaction": "reaction"},
}


def rovbrush(*arguments: object) -> None:
    """The command; its errors end this one."""
    subprocess.run([sys.executable, "-m", "rovbrush.orchestrator", *map(str, arguments)], check=True)


def main() -> None:
    """All pictures, from runs in a folder of their own."""
    rovbrush("plan", "nominal", "--svg", HERE / "nominal.svg")
    rovbrush("plan", "hull_pass", "--svg", HERE / "hull_pass.svg")
    with TemporaryDirectory() as folder:
        for system, figures in PICTURES.items():
            rovbrush("run", system, "--out", Path(folder) / system)
            for figure, name in figures.items():
                shrunk(Path(folder) / system / f"{figure}.png", HERE / f"{name}.png")


def shrunk(source: Path, target: Path) -> None:
    """A picture with few colours."""
    with Image.open(source) as image:
        image.convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE).save(target, optimize=True)


if __name__ == "__main__":
    main()
