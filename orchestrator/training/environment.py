"""A system as an environment of Gymnasium."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np

from ..api import Model, load
from ..clock import duration
from ..errors import InputError, RovbrushError, RunError
from ..plan.plan import Plan
from ..results.result import Result
from ..run.stepping.snapshot import Snapshot, unkept
from ..run.stepping.stepping import Stepping
from .expression import Expression
from .ranges import Drawn, applies_later
from .signals import Named, Signal, actions_of, observations_of
from .wires import Wires, observed_names

Values = dict[str, float]
Reward = str | Callable[[Values, Values], float]


class Environment(gymnasium.Env[np.ndarray, np.ndarray]):
    """An agent sets inputs that nothing drives and sees signals, every `period`, for an `episode`.

        env = Environment("plant.toml", {"drive.u": (0.0, 12.0)}, {"drive.w": (0.0, 100.0)},
                          "-abs(drive.w - 30)", period="10 ms", episode="5 s")

    `system`: what `rovbrush.load` takes, or a Model. `actions`, `observations`: names with (low, high) in the unit of
    the FMU, or None (or a list of names) where the FMU declares min and max. Both are vectors of float64, in the order
    of the names. `reward`, after each step: an expression of signals, `time` [s] among them, or a callable of the
    observations and the actions by name. `period` [s]: a multiple of the time in which the schedule repeats, which is
    the default. `episode` [s]: a multiple of that, at which it is truncated. `terminated`, `truncated`: expressions
    that end it before. `randomise`: ranges by name (`"0.05:0.2"`, `"1:10:log"`, a list), drawn anew at every reset by
    the environment's generator: inputs and tunable parameters are set in the restored state, others have the system
    initialized anew. `values`: as of `rovbrush.load`. `record`: whether the rows of an episode are kept for `result`,
    as the system file says, or names and patterns of what is (`["motor.*"]`); a step takes longer then.

    A reset restores the states of the FMUs at the start; where one cannot save its state, or fixed parameters are
    drawn, it initializes the system anew, which takes longer and is said in `info["reset"]`. Raises InputError for
    what is wrong in all that; RunError if an FMU fails within an episode, behind which a reset begins anew.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 1}  # noqa: RUF012 (as Gymnasium has it)

    def __init__(
        self,
        system: str | Path | Model,
        actions: Named,
        observations: Named,
        reward: Reward,
        *,
        episode: str | float,
        period: str | float = "",
        terminated: str = "",
        truncated: str = "",
        randomise: Mapping[str, object] | None = None,
        render_mode: str | None = None,
        values: Mapping[str, object] | None = None,
        fmus: str | Path | None = None,
        record: bool | Sequence[str] = False,
    ) -> None:
        model = system if isinstance(system, Model) else load(system, values=values, fmus=fmus)
        start = model.system.start
        model = model.over("", float(start + duration(episode, "episode")))
        self.recorded = bool(record)
        kept = model.system.record if record is True else _patterns(record)
        self.model = Model(replace(model.system, record=kept))
        plan = self.model.plan
        self._by, self._steps = _times(self.model, period, episode)
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise InputError(f"render_mode = {render_mode!r}: there is 'rgb_array', or None")
        self.render_mode = render_mode
        self.actions, self.observations = actions_of(plan, actions), observations_of(plan, observations)
        self.action_space = _box(self.actions)
        self.observation_space = _box(self.observations)
        self._reward, self._texts = reward, {"terminated": terminated, "truncated": truncated}
        seen = [*(signal.name for signal in self.observations), *self._checked_expressions(plan)]
        self.model = Model(replace(self.model.system, observed=observed_names(plan, seen)))
        self.plan = plan = self.model.plan
        self._drawn = Drawn(self.model.system, randomise or {})
        self._later = [name for name in self._drawn.names if applies_later(self.model.system, name)]
        self._slow = unkept(plan)
        if self._slow:
            warnings.warn(f"every reset initializes the system anew: {self._slow}", stacklevel=2)
        self._session: Stepping | None = None
        self._wires: Wires | None = None
        self._start: Snapshot | None = None
        self._fixed: dict[str, object] = {}
        self._trace: list[tuple[float, list[float]]] = []
        self._done = 0

    def _checked_expressions(self, plan: Plan) -> list[str]:
        """Names and syntax, before anything is loaded; the signals that they name."""
        found: list[str] = []

        def reader(name: str) -> Callable[[], float]:
            if name != "time":
                found.append(observations_of(plan, {name: (0.0, 1.0)})[0].name)
            return lambda: 0.0

        for what, text in {"reward": self._reward, **self._texts}.items():
            if isinstance(text, str) and (text or what == "reward"):
                Expression(text, what, reader)
        return found

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Back to the start; `info`: the time, what was drawn, and how it came there."""
        super().reset(seed=seed)
        drawn = self._drawn.by(self.np_random) if self._drawn.names else {}
        fixed = {name: value for name, value in drawn.items() if name not in self._later}
        how = "saved states"
        session = self._session
        if session is None or self._start is None or fixed != self._fixed:
            session, how = self._begin(fixed), "initialized"
            if self._slow:
                how += f" anew: {self._slow}"
            elif fixed:
                how += f" anew: {', '.join(fixed)} cannot be changed in a saved state"
        else:
            try:
                session.restore(self._start)
            except RovbrushError as error:
                session, how = self._begin(fixed), f"initialized anew: {error}"
        for name in self._later:
            session.set(name, drawn[name])
        self._done, self._trace = 0, []
        assert self._wires is not None
        observed = self._wires.observe()
        if self.render_mode:
            self._trace.append((session.time, observed.tolist()))
        return observed, {"time": session.time, "drawn": drawn, "reset": how}

    def _begin(self, fixed: dict[str, object]) -> Stepping:
        """Load and initialize the system, and keep where it is."""
        self.close()
        model = self.model.set(fixed) if fixed else self.model
        session = model.start()
        session.__enter__()
        self._session, self._fixed = session, fixed
        self._start = None if self._slow else session.snapshot()
        self._wires = wires = Wires(session, self.actions, self.observations)
        reader, reward = wires.reader, self._reward
        self._rewarded = Expression(reward, "reward", reader) if isinstance(reward, str) else None
        self._ends = {what: Expression(text, what, reader) for what, text in self._texts.items() if text}
        return session

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Set the actions and go on by one period."""
        session, wires = self._session, self._wires
        if session is None or wires is None:
            raise RunError("the environment has not begun: call reset() first")
        values = wires.set(action)
        session.step(self._by)
        self._done += 1
        observed = wires.observe()
        reward = self._rewarded() if self._rewarded is not None else self._called(observed, values)
        terminated, truncated = False, self._done >= self._steps or session.over
        if self._ends:
            terminated, truncated = self._over("terminated"), truncated or self._over("truncated")
        time = session.at.time
        if self.render_mode:
            self._trace.append((time, observed.tolist()))
        return observed, reward, terminated, truncated, {"time": time}

    def _called(self, observed: np.ndarray, values: list[float]) -> float:
        """The reward that a callable gives."""
        seen = dict(zip([signal.name for signal in self.observations], observed.tolist(), strict=True))
        given = dict(zip([signal.name for signal in self.actions], values, strict=True))
        return float(self._reward(seen, given))  # type: ignore[operator]

    def _over(self, what: str) -> bool:
        return what in self._ends and bool(self._ends[what]())

    def render(self) -> Any:
        """The observations of the episode over time as a picture, (height, width, 3) of uint8; None without a mode."""
        if self.render_mode is None:
            return None
        from .picture import picture

        return picture(self.observations, self._trace)

    def result(self) -> Result:
        """The rows of the episode until now, as those of a run; what was taken stays as it is when the next one begins.

        Raises InputError where nothing is recorded, RunError before the first reset.
        """
        if not self.recorded:
            raise InputError("nothing of an episode is recorded; make the environment with record=True")
        if self._session is None:
            raise RunError("the environment has not begun: call reset() first")
        return self._session.result()

    def close(self) -> None:
        """Give the FMUs back."""
        session, self._session, self._start, self._wires = self._session, None, None, None
        if session is not None:
            session.__exit__(None, None, None)


def _patterns(record: bool | Sequence[str]) -> tuple[str, ...]:
    """Of what is recorded where the caller says it. Raises InputError."""
    if record is False:
        return ()
    if isinstance(record, (str, bool)) or not all(isinstance(name, str) for name in record):
        raise InputError(f'record = {record!r}: True, or a list of names and patterns such as ["motor.*"]')
    return tuple(record)


def _box(signals: list[Signal]) -> gymnasium.spaces.Box:
    low, high = (np.array([getattr(signal, end) for signal in signals]) for end in ("low", "high"))
    return gymnasium.spaces.Box(low, high, dtype=np.float64)


def _times(model: Model, period: str | float, episode: str | float) -> tuple[str | float | None, int]:
    """The length of a period as `Stepping.step` takes it, and periods of an episode. Raises InputError."""
    clock = model.plan.clock
    cycle = clock.seconds(clock.hyperperiod)
    each = cycle if period == "" else duration(period, "period")
    count, steps = each / cycle, duration(episode, "episode") / each
    if count.denominator != 1 or count < 1:
        raise InputError(
            f"period = {float(each):g} s is no multiple of {float(cycle):g} s, in which the schedule repeats"
        )
    if steps.denominator != 1 or steps < 1:
        raise InputError(f"episode = {episode} is no multiple of the period {float(each):g} s")
    by = None if count == 1 and not model.plan.adaptive else float(each) if isinstance(period, float) else period
    return by or None, int(steps)
