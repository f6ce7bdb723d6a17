"""What notebooks show: models, results and sessions as HTML in which names are text, a bar, completions."""

from __future__ import annotations

import html.parser
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from helpers import Part, system_text
from rovbrush.orchestrator import Model, Result, RunError, load, notebook
from rovbrush.orchestrator.markup import element, safe, table
from rovbrush.orchestrator.results.spark import HEIGHT, WIDTH, spark

LOOP: dict[str, Part] = {"g": ("gain", "1 ms", {"k": -1.0, "offset": 0.0}), "i": ("integrator", "5 ms", {"x_start": 1})}
WIRES = ["i.x -> g.u", "g.y -> i.u"]
VOID = {"br", "hr", "img", "meta"}
Make = Callable[..., Model]


@pytest.fixture
def make(tmp_path: Path, fmus: Path) -> Make:
    def model(*args: Any, **keys: Any) -> Model:
        path = tmp_path / "case.toml"
        path.write_text(system_text(*args, **keys), encoding="utf-8")
        return load(path, fmus=fmus)

    return model


class Reader(html.parser.HTMLParser):
    """Tags that are opened and closed, and the words between them."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[str] = []
        self.words: list[str] = []
        self.feed(text)
        assert not self.open, self.open

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self.tags.append(tag)
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.words.append(data)


def test_a_result_shows_figures_of_merit_with_units_and_signals_in_small(make: Make, tmp_path: Path) -> None:
    summary = {"x_end": "last i.x", "f": "frequency g.y"}
    result = make(LOOP, WIRES, stop="100 ms", summary=summary).run()
    seen = Reader(result._repr_html_())
    assert {"case", "complete", "x_end", "Hz", "i.x", "g.y"} <= set(seen.words)
    assert seen.tags.count("polygon") >= 2 and any("not saved" in words for words in seen.words)
    assert f"{result.summary['x_end']:.5g}" in seen.words
    result.save(tmp_path / "out")
    assert f"saved in {tmp_path / 'out'}" in " ".join(Reader(result._repr_html_()).words)
    again = Result.open(tmp_path / "out")
    assert again.units == result.units == {"x_end": "1", "f": "Hz"} and again.title == "out"
    assert "x_end" in Reader(again._repr_html_()).words


def test_a_result_that_is_not_complete_says_why(make: Make) -> None:
    with pytest.raises(RunError) as error:
        make({"bad": ("faulty", "5 ms", {"raise_at": 0.02})}, stop="100 ms").run()
    words = " ".join(Reader(error.value.result._repr_html_()).words)
    assert "incomplete" in words and error.value.result.run.failure in words


def test_a_session_shows_time_state_and_values(make: Make) -> None:
    with make(LOOP, WIRES, stop="10 ms").start() as session:
        session.step()
        seen = Reader(session._repr_html_())
        words = " ".join(seen.words)
        assert "0.005 s of 0.01 s" in words and "can be stepped" in words and "progress" in seen.tags
        assert f"{session.get('i.x'):.6g}" in seen.words
        session.step()
        assert "at the stop" in " ".join(Reader(session._repr_html_()).words)
    assert "its FMUs are given back" in " ".join(Reader(session._repr_html_()).words)


def test_a_session_that_has_failed_is_not_asked_for_values(make: Make) -> None:
    with make({"bad": ("faulty", "5 ms", {"raise_at": 0.02})}, stop="100 ms").start() as session:
        with pytest.raises(RunError):
            session.step("50 ms")
        seen = Reader(session._repr_html_())
        assert session.failure in " ".join(seen.words) and "table" not in seen.tags


def test_a_model_that_cannot_be_planned_says_why(make: Make) -> None:
    model = make(LOOP, WIRES, stop="10 ms", algorithm="ecco")
    assert "so they need one period" in " ".join(Reader(model._repr_html_()).words)


def test_tab_finds_signals_and_the_documented_names(make: Make) -> None:
    model = make(LOOP, WIRES, stop="10 ms")
    result = model.run()
    assert {"i.x", "g.y"} <= set(result._ipython_key_completions_())
    assert all(str(result[name].name) == name for name in result._ipython_key_completions_())
    for one in (model, result):
        names = dir(one)
        assert not any(name.startswith("_") for name in names) and len(names) < 15
        assert all(hasattr(one, name) for name in names)
        assert all(getattr(type(one), name).__doc__ for name in names if callable(getattr(type(one), name, None)))


# --- what strangers have named ---


def test_names_and_attributes_are_escaped_and_control_characters_go() -> None:
    hostile = "<img src=x onerror=alert(1)>\"'&\x00"
    assert safe(hostile) == "&lt;img src=x onerror=alert(1)&gt;&quot;&#x27;&amp;\ufffd"
    assert element("p", safe(hostile), title=hostile).count("<") == 2
    assert Reader(table(("a",), [[safe(hostile)]])).tags.count("img") == 0


def test_texts_in_a_result_are_text(make: Make) -> None:
    result = make(LOOP, WIRES, stop="10 ms", summary={'"<script>x</script>"': "last i.x"}).run()
    seen = Reader(result._repr_html_())
    assert "script" not in seen.tags and "<script>x</script>" in seen.words


# --- signals in small ---


def points(svg: str) -> np.ndarray:
    text = svg.partition('points="')[2].partition('"')[0]
    return np.array([[float(x) for x in pair.split(",")] for pair in text.split()])


def test_a_ripple_is_a_band_between_its_extremes() -> None:
    time = np.linspace(0.0, 1.0, 100_001)
    drawn = points(spark(time, np.sin(2e3 * np.pi * time)))
    assert len(drawn) == 2 * WIDTH and drawn[: WIDTH - 1, 1].max() < 2.0 and drawn[WIDTH + 1 :, 1].min() > HEIGHT - 2.0


@pytest.mark.parametrize(
    "values",
    [[1.0, 1.0, 1.0], [0.0, np.nan, 1.0], [-1e308, 1e308, 0.0], [0, 5, 2], [True, False, True], [np.inf, 0, 1]],
)
def test_whatever_the_numbers_the_line_stays_in_its_picture(values: list[Any]) -> None:
    drawn = points(spark(np.array([0.0, 1.0, 2.0]), np.array(values)))
    assert np.isfinite(drawn).all() and (drawn >= 0).all() and (drawn[:, 1] <= HEIGHT).all()


@pytest.mark.parametrize("values", [[], [1.0], ["a", "b"], [np.nan, np.nan]])
def test_what_has_no_line_is_left_out(values: list[Any]) -> None:
    kind = object if values and isinstance(values[0], str) else float
    assert spark(np.arange(float(len(values))), np.array(values, dtype=kind)) == ""


# --- the bar ---


class Display:
    """What a front end would show."""

    def __init__(self) -> None:
        self.shown: list[str] = []

    def __call__(self, content: dict[str, str], **_: Any) -> Display:
        self.shown.append(content["text/html"])
        return self

    def update(self, content: dict[str, str], **_: Any) -> None:
        self.shown.append(content["text/html"])


@pytest.fixture
def kernel(monkeypatch: pytest.MonkeyPatch) -> Display:
    display = Display()
    shell = type("ZMQInteractiveShell", (), {})()
    fake = SimpleNamespace(get_ipython=lambda: shell, __path__=[])
    monkeypatch.setitem(sys.modules, "IPython", fake)  # type: ignore[arg-type]
    monkeypatch.setitem(sys.modules, "IPython.display", SimpleNamespace(display=display))  # type: ignore[arg-type]
    monkeypatch.setattr(notebook, "INTERVAL", 0.0)
    return display


def test_a_long_run_shows_a_bar_that_goes_at_its_end(
    make: Make, kernel: Display, monkeypatch: pytest.MonkeyPatch
) -> None:
    model = make(LOOP, WIRES, stop="2 s")
    model.run()
    assert kernel.shown == [], "a short run shows none"
    monkeypatch.setattr(notebook, "LONG", 0.0)
    result = model.run()
    assert len(kernel.shown) >= 2 and kernel.shown[-1] == "" and "2 s" in Reader(kernel.shown[0]).words[-1]
    assert [t.tobytes() for t in result.run.tables] == [t.tobytes() for t in model.run(progress=False).run.tables]


def test_a_bar_goes_when_the_run_fails_and_false_shows_none(
    make: Make, kernel: Display, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(notebook, "LONG", 0.0)
    model = make({"bad": ("faulty", "5 ms", {"raise_at": 1.5})}, stop="2 s")
    with pytest.raises(RunError):
        model.run(progress=False)
    assert kernel.shown == []
    with pytest.raises(RunError):
        model.run()
    assert kernel.shown == [] or kernel.shown[-1] == ""


def test_outside_of_a_notebook_nothing_is_shown_and_a_callback_is_called(make: Make) -> None:
    assert not notebook.in_notebook()
    seen: list[float] = []
    make(LOOP, WIRES, stop="100 ms").run(progress=seen.append)
    assert seen and seen[-1] <= 0.1


def test_the_words_of_a_bar_are_escaped() -> None:
    words = Reader(notebook.Bar("<b>x</b>", 0.0, 2.0).html(0.5, 1.0)).words
    assert words[0].strip() == "<b>x</b>" and words[-1] == " 0.5 of 2 s, 3 s left"
