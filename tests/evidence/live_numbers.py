"""`python -m tests.evidence.live_numbers [SECONDS [OPTION...]]`: what a page costs, and how soon it is there.

The options are those of `rovbrush live hull_pass`, for instance `--fifo 20`.

It needs chromium and chromedriver, and built native FMUs (ROVBRUSH_FMUS). The browser draws by software.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

PATIENCE = 60.0  # s
ARGUMENTS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--window-size=1200,900"]


def resident(pid: int) -> float:
    """MB of a process."""
    found = re.search(r"VmRSS:\s+(\d+)", Path(f"/proc/{pid}/status").read_text())
    return int(found[1]) / 1000 if found else 0.0


def below(pid: int) -> dict[int, str]:
    """The processes below one, with their commands."""
    found: dict[int, str] = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(stat.read_text().rpartition(")")[2].split()[1]) == pid:
                child = int(stat.parent.name)
                found[child] = (stat.parent / "cmdline").read_bytes().replace(b"\0", b" ").decode()
                found |= below(child)
        except (OSError, ValueError):
            continue
    return found


def browser() -> Any:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = str(shutil.which("chromium"))
    for argument in ARGUMENTS:
        options.add_argument(argument)
    return webdriver.Chrome(options=options, service=Service(str(shutil.which("chromedriver"))))


def counts(opened: Any) -> tuple[float, ...]:
    script = "return [rig.received, rig.drawn, rig.scenes || 0, rig.time, performance.timeOrigin]"
    return time.monotonic(), *map(float, opened.execute_script(script))


def in_page(opened: Any) -> float:
    """MB of the page's script, without what it has dropped."""
    opened.execute_cdp_cmd("HeapProfiler.collectGarbage", {})
    return float(opened.execute_script("return performance.memory.usedJSHeapSize / 1e6"))


def late(opened: Any) -> tuple[int, int]:
    """Missed deadlines and all of them, as the page says."""
    text = opened.find_element("css selector", '[data-test="how"]').text
    found = re.search(r"(\d+) of (\d+) deadlines", text)
    return (int(found[1]), int(found[2])) if found else (0, 0)


def awaited(look: Callable[[], Any], run: subprocess.Popen[bytes], said: Path) -> Any:
    """What `look` finds, as soon as it finds anything; the run must go on until then."""
    end = time.monotonic() + PATIENCE
    while not (found := look()):
        time.sleep(0.02)
        assert run.poll() is None, f"the run has ended: {said.read_text()}"
        assert time.monotonic() < end, f"nothing within {PATIENCE:g} s: {said.read_text()}"
    return found


def measure(seconds: float, options: list[str]) -> None:
    opened = browser()  # it takes a while by itself
    with tempfile.TemporaryDirectory() as folder:
        said = Path(folder) / "said"
        begun = time.monotonic()
        command = [
            sys.executable,
            "-m",
            "rovbrush.orchestrator",
            "live",
            "hull_pass",
            "--stop",
            f"{3600 + 2 * seconds:g} s",
            "--port",
            "0",
        ]
        with said.open("wb") as target:
            run = subprocess.Popen(
                [*command, "--out", f"{folder}/out", *options], stdout=target, stderr=subprocess.STDOUT
            )
        try:
            (place,) = awaited(lambda: re.findall(r"http://\S+", said.read_text()), run, said)
            opened.get(place)
            awaited(lambda: opened.execute_script("return !!(window.rig && rig.scenes)"), run, said)
            print(f"first picture after the command: {time.monotonic() - begun:.2f} s")
            opened.execute_script("rig.add(rig.signals.slice(0, 20).map((signal) => signal.name))")
            time.sleep(3.0)
            processes = {pid: text for pid, text in below(run.pid).items() if "live" in text}
            memory = {pid: resident(pid) for pid in processes}
            before, missed, heap = counts(opened), late(opened), in_page(opened)
            time.sleep(seconds)
            after, missed_then = counts(opened), late(opened)
            span = after[0] - before[0]
            posted = opened.execute_script("return rig.signals.length")
            print(f"over {span:.0f} s, {posted} signals posted, 20 in a chart:")
            if after[5] != before[5]:
                print("  the page was loaded again meanwhile: what it counts began anew")
            print(f"  updates per second that arrive: {(after[1] - before[1]) / span:.1f}")
            print(f"  charts drawn per second: {(after[2] - before[2]) / span:.1f}")
            print(f"  frames of the scene per second, by software: {(after[3] - before[3]) / span:.1f}")
            print(f"  real-time factor: {(after[4] - before[4]) / span:.3f}")
            print(f"  deadlines missed with the page: {missed_then[0] - missed[0]} of {missed_then[1] - missed[1]}")
            print(f"  memory of the page's script: {heap:.0f} MB, then {in_page(opened):.0f} MB")
            then = {pid: resident(pid) for pid in processes}
            opened.get("about:blank")
            time.sleep(1.0)
            opened.quit()
            time.sleep(seconds)
            for pid, text in processes.items():
                what = "page's server" if "live.page" in text else "run"
                print(f"  memory of the {what}: {memory[pid]:.0f} MB, then {then[pid]:.0f} MB, in the end "
                      f"{resident(pid):.0f} MB")  # fmt: skip
            run.send_signal(signal.SIGTERM)
            run.wait(60.0)
            lines = [line for line in said.read_text().splitlines() if line.startswith(("real time", "lateness"))]
            print("of the whole run, half of it without a browser:", *lines, sep="\n  ")
        finally:
            if run.poll() is None:
                run.kill()
    opened.quit()


if __name__ == "__main__":
    os.environ.pop("PYTEST_CURRENT_TEST", None)
    measure(float(sys.argv[1]) if len(sys.argv) > 1 else 60.0, sys.argv[2:])
