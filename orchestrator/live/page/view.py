"""The page of one viewer: how the run stands, what it shows, what can be touched."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from typing import Any

from nicegui import Client, ui

from ..messages import Do, State
from ..viewers import Viewers
from .controls import Control, control_of
from .link import Link

REFRESH = 0.2  # s
SPEEDS = {
    **{x: f"{x:g} x" for x in (0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0)},
    0.0: "as fast as it goes",
}
WORDS = {
    "paused": "paused", "running": "running", "writing": "writing the results", "ended": "has ended",
    "failed": "has failed",
}  # fmt: skip
KINDS = {
    "loss": "is lost (0 or a value)", "hold": "stays as it is", "bias": "gets a bias", "scale": "is scaled",
    "noise": "gets noise",
}  # fmt: skip
HEAD = '<link rel="stylesheet" href="/live/live.css"><script type="module" src="/live/live.js"></script>'


class View:
    """`build` makes it in the page of the present client."""

    def __init__(self, link: Link, viewers: Viewers) -> None:
        self.link, self.viewers = link, viewers
        self.client: Client = ui.context.client
        self.controls: dict[str, Control] = {}
        self.touchable: list[Any] = []  # elements that only whoever drives may use
        self._key, self._version, self._attempt = "", -1, 0
        self._rights: tuple[bool, bool] | None = None
        self._heard = link.version

    def build(self) -> None:
        ui.add_head_html(HEAD)
        self.client.on_connect(self._arrive)
        self.client.on_disconnect(self._leave)
        self.body = ui.column().classes("w-full gap-2")
        with self.body:
            self.waiting = ui.label("The run is being prepared: its FMUs are loaded.").classes("quiet")
        self.timer = ui.timer(REFRESH, self._refresh)
        self._refresh()

    @property
    def drives(self) -> bool:
        return self.viewers.drives(self._key)

    def _arrive(self) -> None:
        key = self.client.tab_id or ""
        if self._key:
            self.viewers.leave(self._key, time.monotonic())
        self._key = key
        self.viewers.arrive(key, time.monotonic())
        self._version = -1

    def _leave(self) -> None:
        if self._key:
            self.viewers.leave(self._key, time.monotonic())
            self._key = ""

    def ask(self, do: Do) -> None:
        """Hand on what this viewer wants, if it drives."""
        if not self.drives:
            ui.notify(f"{self.viewers.driver or 'nobody'} drives; take over first", type="warning")
        elif not self.link.ask(do):
            ui.notify("the run does not answer", type="negative")

    def do(self, what: Any, **more: Any) -> None:
        self.ask(Do(what, viewer=self._key, **more))

    def _asking(self, what: Any, name: str) -> Callable[[], None]:
        return lambda: self.do(what, name=name)

    def _refresh(self) -> None:
        link = self.link
        if link.hello is None:
            if link.gone:
                self.waiting.text = "The run has ended before it began; the terminal says why."
            return
        if not self.controls and self.waiting is not None:
            self.waiting.delete()
            self.waiting = None  # type: ignore[assignment]
            with self.body:
                self._fill()
        self._show_rights()
        if link.version != self._version:
            self._version = link.version
            self._show_state()
            self._hear()

    def _fill(self) -> None:
        hello = self.link.hello
        assert hello is not None
        with ui.element("div").classes("bar"):
            ui.label(hello.system).classes("text-lg font-semibold").tooltip(hello.description)
            ui.html('<span id="clock" class="numbers">0 s</span>', sanitize=False)
            self.how = ui.label().classes("numbers").props('data-test="how"')
        with ui.element("div").classes("bar"):
            self.go = ui.button("start", on_click=self._go).props('dense data-test="go"').classes("px-3")
            step = ui.button("step", on_click=lambda: self.do("step")).props("dense outline").classes("px-3")
            speed = ui.select(SPEEDS, value=1.0, on_change=self._speed).props('dense outlined data-test="speed"')
            self.speed = speed.tooltip("speed, times real time")
            reset = ui.button("reset", on_click=lambda: self.do("reset")).props("dense outline").classes("px-3")
            end = ui.button("end", on_click=lambda: self.do("end")).props("dense outline").classes("px-3")
            end.tooltip("end the run and write its results")
            self.role = ui.label().classes("quiet").props('data-test="role"')
            self.take = ui.button("take over", on_click=self._take).props('dense flat data-test="take"')
            self.touchable += [self.go, step, speed, reset, end]
        self.note = ui.label().classes("note w-full").props('data-test="note"')
        with ui.element("div").classes("rig"):
            with ui.element("div").classes("rig-left"):
                self._fill_left()
            with ui.element("div").classes("rig-right"):
                self._fill_right()

    def _fill_left(self) -> None:
        hello = self.link.hello
        assert hello is not None
        if hello.scene:
            with ui.element("div").classes("box scene"):
                ui.scene(width=600, height=380, grid=False, background_color="#dcebf3", fps=20).classes("w-full h-full")
            ui.run_javascript('import("/live/scene.js")')
        ui.element("div").props('id="charts"').classes("flex flex-col gap-3")
        with ui.element("div").classes("bar"):
            names = [signal.name for signal in hello.signals]
            chosen = ui.select(names, multiple=True, with_input=True, label="signals").props("dense outlined use-chips")
            chosen.classes("min-w-48 grow")

            def add() -> None:
                ui.run_javascript(f"rig.add({json.dumps(list(chosen.value))})")
                chosen.value = []

            ui.button("add a chart", on_click=add).props("dense outline").classes("px-3")
            seconds = {5: "5 s", 20: "20 s", 50: "50 s"}
            ui.select(seconds, value=20, on_change=lambda e: ui.run_javascript(f"rig.window = {e.value}")).props(
                "dense outlined"
            ).tooltip("how much of the time the charts show")
        if hello.diagram:
            with ui.expansion("block diagram").classes("w-full box"), ui.element("div").classes("diagram"):
                ui.html(hello.diagram, sanitize=False)

    def _fill_right(self) -> None:
        hello = self.link.hello
        assert hello is not None
        first = [entry for entry in hello.inputs if entry.first]
        others = [entry for entry in hello.inputs if not entry.first]
        if hello.inputs:
            with ui.element("div").classes("box"):
                ui.html("<h2>Inputs</h2>", sanitize=False)
                for entry in first or others[:12]:
                    self._control(entry)
                rest = others if first else others[12:]
                if rest:
                    with ui.expansion(f"{len(rest)} more").classes("w-full"):
                        for entry in rest:
                            self._control(entry)
        if hello.breakable or hello.happenings:
            with ui.element("div").classes("box"):
                ui.html("<h2>Faults and events</h2>", sanitize=False)
                self._fill_faults()
        with ui.element("div").classes("box"):
            ui.html("<h2>What was done</h2>", sanitize=False)
            self.did = ui.html("", sanitize=False).classes("did").props('data-test="did"')
            save = ui.button("save as a scenario", on_click=self._save).props("dense outline").classes("px-3")
            save.tooltip("rovbrush run SYSTEM --scenario FILE does it again, bit for bit")

    def _control(self, entry: Any) -> None:
        control = control_of(entry, lambda value: self.do("set", name=entry.name, value=value))
        self.controls[entry.name] = control
        self.touchable += control.elements

    def _fill_faults(self) -> None:
        hello = self.link.hello
        assert hello is not None
        for name in hello.happenings:
            button = ui.button(name, on_click=self._asking("happen", name))
            self.touchable.append(button.props("dense outline").classes("px-3"))
        if hello.breakable:
            which = ui.select(hello.breakable, with_input=True, label="signal").props(
                'dense outlined data-test="broken"'
            )
            with ui.element("div").classes("bar"):
                kind = ui.select(KINDS, value="loss").props("dense outlined").classes("grow")
                value = ui.number(value=0.0).props("dense outlined").classes("w-20")

                def give() -> None:
                    if not which.value:
                        ui.notify("which signal?", type="warning")
                        return
                    self.do("break", name=which.value, kind=kind.value, value=value.value)

                give_it = ui.button("break", on_click=give).props('dense outline data-test="break"').classes("px-3")
            which.classes("w-full")
            self.broken = ui.element("div").classes("w-full").props('data-test="faults"')
            self._faults: dict[str, str] = {}
            self.touchable += [which, kind, value, give_it]

    def _go(self) -> None:
        state = self.link.state
        self.do("pause" if state and state.what == "running" else "start")

    def _speed(self, event: Any) -> None:
        if self.link.state and event.value != self.link.state.speed:
            self.do("speed", value=float(event.value))

    def _take(self) -> None:
        if self.drives:
            self.viewers.release(self._key)
        elif why := self.viewers.take(self._key, time.monotonic()):
            ui.notify(why, type="warning")

    def _save(self) -> None:
        hello = self.link.hello
        assert hello is not None
        ui.download.content(self.link.done.scenario, f"{hello.system}_scenario.toml")

    def _show_rights(self) -> None:
        viewers = self.viewers
        driver, drives = viewers.driver, self.drives
        others = f"{viewers.here} look on" if viewers.here > 1 else ""
        who = "you drive" if drives else f"{driver} drives, you look on" if driver else "nobody drives"
        self.role.text = ", ".join(filter(None, [who, others]))
        self.take.text = "let go" if drives else "take over"
        self.take.set_visibility(drives or not driver)
        if self._rights != (drives, bool(driver)):
            self._rights = (drives, bool(driver))
            for element in self.touchable:
                element.set_enabled(drives)

    def _show_state(self) -> None:
        state, done = self.link.state, self.link.done
        if state is None:
            return
        what = "is gone" if self.link.gone and state.what in ("paused", "running") else WORDS[state.what]
        self.how.text = what + (f", {state.factor:.2f} x real time" if state.what == "running" else "") + _late(state)
        self.go.text = "pause" if state.what == "running" else "start"
        self.speed.value = state.speed if state.speed in SPEEDS else self.speed.value
        note = state.why
        if state.what in ("ended", "failed") and state.folder:
            note += f"\nthe results are in {state.folder}; reset begins again"
        if self.link.gone:
            note = "\n".join(filter(None, [note, "the run's process has ended; this page hears of nothing any more"]))
        self.note.text = note
        self.note.set_visibility(bool(note))
        again, self._attempt = state.attempt != self._attempt, state.attempt
        for name, control in self.controls.items():
            if not self.drives or again:
                control.show(state.values.get(name, control.start))
        if hasattr(self, "broken") and self._faults != state.faults:
            self._faults = dict(state.faults)
            self.broken.clear()
            with self.broken:
                for name, how in state.faults.items():
                    with ui.element("div").classes("bar"):
                        ui.label(f"{name}: {how}").classes("quiet grow")
                        mend = ui.button("mend", on_click=self._asking("mend", name))
                        mend.props("dense flat").set_enabled(self.drives)
        lines = "".join(f"<div>{_safe(line)}</div>" for line in done.lines[-200:])
        self.did.set_content(lines or '<div class="quiet">nothing yet</div>')

    def _hear(self) -> None:
        for version, said in self.link.said:
            if version > self._heard and said.viewer in ("", self._key):
                ui.notify(said.text, type="warning", multi_line=True, timeout=8000)
        self._heard = self.link.version


def _late(state: State) -> str:
    return f", {state.missed} of {state.deadlines} deadlines missed" if state.deadlines else ""


def _safe(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
