"""Systems, runs and results from Python, as short as on the command line.

from rovbrush.orchestrator import load

system = load("nominal", stop="2 s")
result = system.set("motor.R", 0.1).run()
result["motor.i"].plot()
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import Any

from .clock import seconds_text
from .errors import InputError, RovbrushError
from .markup import element, safe
from .notebook import bar_unless
from .observers.sink import Sink
from .observers.watched import Watching, watched
from .plan.diagram.draw import block_diagram, diagram_html
from .plan.diagram.file import write_diagram
from .plan.explain import explain
from .plan.plan import Plan
from .results.result import Result
from .run.pacing.pace import Pace
from .run.planned import planned
from .run.recording.observers import Every
from .run.stepping.length import Time
from .run.stepping.stepping import Stepping
from .system.assemble import assemble, over
from .system.file.events.added import Given, set_by_hand, with_added
from .system.inputs.series_file import with_files, with_inputs
from .system.model import System
from .system.request import Changes, set_name

Inputs = Mapping[str, Any] | str | Path
PUBLIC = (
    "by_hand", "diagram", "explain", "over", "plan", "run", "set", "start", "stopping", "system", "with_events",
    "with_inputs",
)  # fmt: skip
DRAWN = 30  # components, in a notebook
Observer = Callable[[float, dict[str, Any]], object]
Observers = str | Sequence[str | Sink]


def load(
    name: str | Path,
    *,
    stop: Time = "",
    fmus: str | Path | None = None,
    replacements: Mapping[str, str | Path] | None = None,
    mappings: Mapping[str, str | Path] | None = None,
    periods: Mapping[str, str] | None = None,
    record: Sequence[str] = (),
    step: str = "",
    allow_outside: Sequence[str | Path] = (),
    start: Time = "",
    values: Mapping[str, object] | None = None,
    parameters: str | Path = "",
    scenario: str | Path | Sequence[str | Path] = (),
    events: Sequence[Given] = (),
) -> Model:
    """A system, by the name of a shipped one or the path of a .toml, .ssp, .ssd, .fmu or OSP file; FMUs stay unpacked.

    `start`, `stop`: other times; `fmus`: the folder of built FMUs; `replacements`, `mappings`, `periods`, by component:
    an FMU in its place, the mapping file for that, and another period; `record`: patterns such as `motor.*` of what is
    recorded instead of what the system says; `step`: the period where an SSP states none; `allow_outside`: folders
    elsewhere from which an SSP may take files; `values`: as of `Model.set`, and structural parameters, which decide the
    sizes of arrays; `parameters`: another parameter set, by its name or its file; `scenario`: files of events that
    happen too; `events`: single ones, see `Model.with_events`.
    Raises InputError or FmuError, as the command line does.
    """
    changes = Changes(
        _paths(replacements),
        _paths(mappings),
        tuple((key, str(value)) for key, value in (periods or {}).items()),
        tuple(str(Path(folder).absolute()) for folder in allow_outside),
        set_name(str(parameters)),
        tuple(str(Path(file).absolute()) for file in ([scenario] if isinstance(scenario, str | Path) else scenario)),
    )
    folder = Path(fmus) if fmus else None
    system = assemble(str(name), values, str(stop), folder, changes, step=step, record=record, start=str(start))
    return Model(with_added(system, events, "events"))


def _paths(files: Mapping[str, str | Path] | None) -> tuple[tuple[str, str], ...]:
    return tuple((name, str(Path(path).absolute())) for name, path in (files or {}).items())


class Model:
    """A system that can be run, again and again. It never changes: `set` and `with_inputs` give another one."""

    system: System  #: what is to be run, checked

    def __init__(self, system: System, planned: Plan | None = None) -> None:
        self.system = system
        self._planned = planned

    @cached_property
    def plan(self) -> Plan:
        """What a run does, checked. Raises InputError."""
        if self._planned is not None:
            return replace(self._planned, system=self.system)
        return planned(self.system)

    def __repr__(self) -> str:
        begin = f"{seconds_text(self.system.start)} " if self.system.start else ""
        end = seconds_text(self.system.stop)
        return f"<Model {self.system.name}: {', '.join(self.system.components)}, {begin}to {end}>"

    def __dir__(self) -> list[str]:
        """What is meant to be used."""
        return sorted(PUBLIC)

    def _repr_html_(self) -> str:
        """In a notebook: the block diagram, or why there can be none."""
        try:
            if len(self.system.components) > DRAWN:
                return element("p", safe(repr(self)))
            return diagram_html(self.plan)
        except RovbrushError as error:
            return element("p", safe(f"{self!r}: {error}"))

    def diagram(self, path: str | Path = "") -> str:
        """The block diagram as SVG: components with their periods, arrows with signals and transfers.

        `path`: a file to write it to as well. Raises InputError for one that does not end with .svg.
        """
        if path:
            write_diagram(self.plan, Path(path))
        return block_diagram(self.plan)

    def set(self, name: str | Mapping[str, object], value: object = None) -> Model:
        """With a parameter, or an input that nothing drives: `set("motor.R", 0.1)`, `set({"motor.R": 0.1, ...})`.

        The plan stays as it is. Raises InputError for an unknown name, a wrong type or a value out of range.
        """
        values = {name: value} if isinstance(name, str) else name
        plain = {key: v.tolist() if hasattr(v, "tolist") else v for key, v in values.items()}
        return Model(self.system.with_values(plain, "set"), self.__dict__.get("plan", self._planned))

    def with_inputs(self, inputs: Inputs) -> Model:
        """With inputs that follow tables: a CSV file, or by name (times [s], values), or one value; see `series`."""
        if isinstance(inputs, (str, Path)):
            return Model(with_files(self.system, [Path(inputs)], "inputs"))
        return Model(with_inputs(self.system, inputs))

    def with_events(self, *events: Given) -> Model:
        """With more events, each in a line, `"2 s: motor.V_in = 0"`, or as the table that a file would hold,
        `{"name": "jam", "by_hand": True, "fault": "hold", "on": "motor.T_load"}`. Raises InputError."""
        return Model(with_added(self.system, events, "with_events"))

    def by_hand(self, *names: str) -> Model:
        """With inputs and tunable parameters that `Stepping.set` sets as events, so that `Stepping.scenario` tells of
        them and a run with that scenario is the same bit by bit. Raises InputError for what no event can set."""
        return Model(with_added(self.system, [set_by_hand(self.system, name) for name in names], "by_hand"))

    def stopping(self, stop: Time) -> Model:
        """With another stop time, "2 s" or 2.0; the same model for an empty one."""
        return self.over("", stop)

    def over(self, start: Time = "", stop: Time = "") -> Model:
        """From another start to another stop, "2 s" or 2.0; an empty one stays as it is. Raises InputError."""
        return self if start == "" == stop else Model(over(self.system, start, stop, ("start", "stop")))

    def run(
        self,
        *,
        start: Time = "",
        stop: Time = "",
        inputs: Inputs | None = None,
        observe: Observer | Observers | None = None,
        every: Time | None = None,
        signals: Iterable[str] = ("*",),
        progress: Callable[[float], None] | bool = True,
        pace: Pace | None = None,
    ) -> Result:
        """Run from start to stop. Raises RunError if it ends before; its `result` is what was computed until then.

        `start`, `stop`, `inputs`: see `over` and `with_inputs`. `observe` is called with the time [s] and the values of
        `signals` (names of outputs, or patterns such as `motor.*`) by name, at the start and then `every` so often (a
        multiple of the time in which the schedule repeats, which is the default); what it raises ends the run. Or it
        is a text such as "mcap=run.mcap", or several, as of `rovbrush run --observe`: rows of `signals` that are
        recorded go there, `every` so often or all, and what happens there does not reach the run.
        `progress` is called now and then with the time reached [s]; in a notebook a run that takes long shows a bar,
        unless it is False. `pace`: in real time, see `Pace`; `result.summary()["real_time"]` tells how late it was.
        """
        model = self.over(start, stop)
        model = model.with_inputs(inputs) if inputs is not None else model
        if observe is None and every is not None:
            raise InputError("every = ... says how often to call an observer; give one with observe = ...")
        begin, end = float(model.system.start), float(model.system.stop)
        with (
            Stepping(model._in_time(pace), pace=pace) as session,
            bar_unless(progress, model.system.name, begin, end) as report,
        ):
            if observe is None:
                session.finish(report)
            elif not callable(observe):
                with watched(session, _watching(observe, signals, every)):
                    session.finish(report)
            else:
                _observed(session, observe, every, session.names(signals), report)
            result = session.result()
        return result.require_good()

    def start(self, *, start: Time = "", stop: Time = "", pace: Pace | None = None) -> Stepping:
        """Load and initialize the FMUs, to be stepped by hand; use it in a `with` block. `pace`: in real time."""
        model = self.over(start, stop)
        return Stepping(model._in_time(pace), pace=pace)

    def _in_time(self, pace: Pace | None) -> Plan:
        """The plan, with deadlines where it is to keep pace."""
        return self.plan if pace is None else planned(self.system, deadlines=pace.every)

    def explain(self) -> str:
        """What `rovbrush plan` prints."""
        return explain(self.plan)


def _watching(observe: Observers, signals: Iterable[str], every: Time | None) -> Watching:
    given = (observe,) if isinstance(observe, str) else tuple(observe)
    return Watching(given, tuple(signals), "" if every is None else str(every))


def _observed(
    session: Stepping, observe: Observer, every: Time | None, names: list[str], progress: Callable[[float], None] | None
) -> None:
    """Go to the stop, or a failure, and call the observer on the way."""
    stop = session.plan.clock.stop
    ticks = session.plan.clock.hyperperiod * (1 if every is None else session.cycles(every, "every"))

    def call(time: float) -> None:
        observe(time, {name: session.get(name) for name in names})

    call(session.time)
    session.observers.append(Every(call, chain(range(ticks, stop, ticks), [stop])))
    session.finish(progress)
