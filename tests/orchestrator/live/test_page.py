"""The page in a real browser: touched by whoever drives it, looked at by others, and of no weight for the run."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from helpers import build_fixture, system_text
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

CHROMIUM, DRIVER = shutil.which("chromium") or shutil.which("chromium-browser"), shutil.which("chromedriver")
pytestmark = pytest.mark.skipif(not CHROMIUM or not DRIVER, reason="no chromium and chromedriver to open the page with")
OPTIONS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync", "--window-size=1200,900"]  # fmt: skip
SCENE = """
[[live.scene]]
shape = "box"
name = "box"
at = ["i.x", "g.y", 0.0]
size = [0.2, 0.2, 0.2]
color = "#3c78b4"
"""
PATIENCE = 30.0  # s, of a machine that is busy


class Live:
    """`rovbrush live` in a folder of its own."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        (folder / "case.toml").write_text(
            system_text(
                {"g": ("gain", "10 ms", {"k": 1.0, "offset": 0.0}), "i": ("integrator", "10 ms")},
                ["g.y -> i.u"],
                "100000 s",
            )
            + SCENE,
            "utf-8",
        )
        env = {key: value for key, value in os.environ.items() if key != "PYTEST_CURRENT_TEST"}  # NiceGUI asks for it
        env["ROVBRUSH_FMUS"] = str(folder)
        self.process = subprocess.Popen(
            [sys.executable, "-m", "rovbrush.orchestrator", "live", "case.toml", "--out", "out", "--port", "0"],
            cwd=folder, env=env, stdout=(folder / "said").open("wb"),
            stderr=subprocess.STDOUT, start_new_session=True,
        )  # fmt: skip
        try:
            self.url = until(lambda: re.findall(r"http://\S+", self.said))[0]
        except BaseException:
            self.end()
            raise

    @property
    def said(self) -> str:
        return (self.folder / "said").read_text("utf-8")

    def end(self) -> None:
        """As Ctrl-C does."""
        self.process.send_signal(signal.SIGTERM)
        self.process.wait(PATIENCE)


class Browser:
    def __init__(self, url: str) -> None:
        options = webdriver.ChromeOptions()
        options.binary_location = str(CHROMIUM)
        for option in OPTIONS:
            options.add_argument(option)
        self.driver = webdriver.Chrome(options=options, service=Service(str(DRIVER)))
        try:
            self.driver.get(url)
        except BaseException:
            self.driver.quit()
            raise

    def text(self, name: str) -> str:
        found = self.driver.find_elements(By.CSS_SELECTOR, f'[data-test="{name}"]')
        return found[0].text if found else ""

    def script(self, text: str) -> Any:
        return self.driver.execute_script(text)

    def click(self, name: str) -> None:
        self.driver.find_element(By.CSS_SELECTOR, f'[data-test="{name}"]').click()

    def value(self, signal: str) -> float:
        """Of the newest rows that have arrived."""
        script = "const f = window.rig && rig.frames.at(-1); return f ? f.v[rig.number(arguments[0])] : null"
        found = self.driver.execute_script(script, signal)
        return float("nan") if found is None else float(found)

    def slider(self, name: str) -> Any:
        return self.driver.find_element(By.CSS_SELECTOR, f'[data-input="{name}"] .q-slider')


def until(found: Callable[[], Any]) -> Any:
    """What is found in the end."""
    end = time.monotonic() + PATIENCE
    while not (value := found()):
        assert time.monotonic() < end, "it never came"
        time.sleep(0.05)
    return value


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Live]:
    folder = tmp_path_factory.mktemp("live")
    for name in ("gain", "integrator"):
        build_fixture(name, folder)
    run = Live(folder)
    yield run
    run.end()


@contextmanager
def browser(url: str) -> Iterator[Browser]:
    opened = Browser(url)
    try:
        yield opened
    finally:
        opened.driver.quit()


@pytest.fixture(scope="module")
def first(live: Live) -> Iterator[Browser]:
    with browser(live.url) as opened:
        until(lambda: "you drive" in opened.text("role"))
        until(lambda: opened.value("g.y") == opened.value("g.y"))
        yield opened


def test_a_slider_moves_a_signal(first: Browser) -> None:
    assert first.value("g.y") == 0.0
    ActionChains(first.driver).move_to_element(first.slider("g.u")).click_and_hold().move_by_offset(
        40, 0
    ).release().perform()
    until(lambda: first.value("g.y") > 0.0)
    until(lambda: "g.u = " in first.text("did"))


def test_a_number_that_is_typed_is_set_and_the_slider_follows(first: Browser) -> None:
    field = first.driver.find_element(By.CSS_SELECTOR, '[data-input="g.u"] input')
    field.send_keys(Keys.CONTROL, "a")
    field.send_keys("0.5", Keys.TAB)
    until(lambda: first.value("g.y") == 0.5)
    until(lambda: float(first.slider("g.u").get_attribute("aria-valuenow")) == 0.5)


def test_a_fault_appears_and_can_be_mended(first: Browser) -> None:
    box = first.driver.find_element(By.CSS_SELECTOR, 'input[data-test="broken"]')
    box.click()
    box.send_keys("g.y")
    until(lambda: first.driver.find_elements(By.CSS_SELECTOR, ".q-menu .q-item"))[0].click()
    first.click("break")
    until(lambda: "g.y: loss" in first.text("faults"))
    before = first.value("i.x")
    until(lambda: first.value("i.held") == 0.0)
    assert first.value("i.x") >= before
    first.driver.find_element(By.CSS_SELECTOR, '[data-test="faults"] button').click()
    until(lambda: first.text("faults") == "" and first.value("i.held") == 0.5)


def test_a_reload_keeps_the_run_and_who_drives(first: Browser) -> None:
    reached = first.script("return rig.time")
    first.driver.refresh()
    until(lambda: "you drive" in first.text("role"))
    until(lambda: (first.script("return window.rig ? rig.time : 0") or 0.0) > reached)
    until(lambda: "g.u = 0.5" in first.text("did"))
    assert first.script("return rig.frames[0].t") < reached, "the charts have what was before"


def test_a_second_viewer_is_read_only_until_the_first_lets_go(live: Live, first: Browser) -> None:
    with browser(live.url) as second:
        until(lambda: "viewer 1 drives, you look on" in second.text("role"))
        until(lambda: second.value("g.y") == 0.5)
        until(
            lambda: (
                second.slider("g.u").get_attribute("aria-disabled") == "true" or not second.slider("g.u").is_enabled()
            )
        )
        assert not second.driver.find_element(By.CSS_SELECTOR, '[data-test="go"]').is_enabled()
        first.click("take")  # lets go
        until(lambda: "nobody drives" in second.text("role"))
        second.click("take")
        until(lambda: "you drive" in second.text("role"))
        until(lambda: "viewer 2 drives, you look on" in first.text("role"))
        second.click("go")
        until(lambda: second.text("how").startswith("paused") and first.text("how").startswith("paused"))
        second.click("go")
        until(lambda: first.text("how").startswith("running"))
        second.click("take")
    until(lambda: "nobody drives" in first.text("role"))
    first.click("take")
    until(lambda: "you drive" in first.text("role"))


def test_the_scene_is_drawn_and_moves_with_its_signals(first: Browser) -> None:
    until(lambda: first.script("return window.rig && rig.scenes > 1"))
    where = "const p = rig.scene.groups.box.position; return [p.x, p.y, p.z]"
    until(lambda: first.script(where)[1] == first.value("g.y"))
    script = f"const [x] = (() => {{ {where} }})(), k = rig.number('i.x'); return rig.frames.some((f) => f.v[k] === x)"
    until(lambda: first.script(script))
    first.click("go")
    until(lambda: "paused" in first.text("how"))
    until(lambda: first.script(where)[0] == first.value("i.x"))
    time.sleep(0.3)
    drawn = first.script("return rig.scenes")
    time.sleep(0.5)
    assert first.script("return rig.scenes") == drawn, "a scene that stands still is not drawn again"
    first.click("go")
    until(lambda: first.script("return rig.scenes") > drawn)


def test_the_page_fits_a_phone(live: Live, first: Browser) -> None:
    with browser(live.url) as phone:
        size = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True}
        phone.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        until(lambda: phone.value("g.y") == 0.5)
        assert phone.script("return document.documentElement.scrollWidth") == 390


def test_a_server_that_dies_is_started_again_and_a_killed_browser_leaves_the_run_going(live: Live) -> None:
    opened = Browser(live.url)
    until(lambda: opened.value("g.y") == 0.5)
    reached = opened.script("return rig.time")
    driver = opened.driver.service.process.pid
    for killed in [driver, *children(driver)]:  # without the others below it they stay for ever
        os.kill(killed, signal.SIGKILL)
    pid = next(pid for pid in children(live.process.pid) if "live.page" in command(pid))
    os.kill(pid, signal.SIGKILL)
    with browser("about:blank") as later:

        def again() -> bool:
            try:
                later.driver.get(live.url)
            except Exception:
                return False
            return bool(later.script("return !!document.querySelector('[data-test]') || !!window.rig"))

        until(again)
        until(lambda: (later.script("return window.rig ? rig.time : 0") or 0.0) > reached)
        until(lambda: "g.u = 0.5" in later.text("did"))


def test_ctrl_c_ends_the_run_with_its_results_and_the_scenario_of_what_was_done(live: Live) -> None:
    """The last test of this run."""
    live.end()
    assert live.process.returncode == 1 and "ended from outside (SIGTERM)" in live.said
    done = tomllib.loads((live.folder / "out" / "scenario.toml").read_text("utf-8"))["events"]
    assert any(event.get("set") == {"g.u": 0.5} for event in done)
    assert any(event.get("fault") == "loss" and "until" in event for event in done)
    assert not [pid for pid in children(live.process.pid) if "live" in command(pid)]


def command(pid: int) -> str:
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode()
    except OSError:
        return ""


def children(pid: int) -> list[int]:
    """All processes below one."""
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(path.read_text().rpartition(")")[2].split()[1]) == pid:
                found.append(int(path.parent.name))
        except (OSError, ValueError):
            continue
    return found + [grand for child in found for grand in children(child)]
