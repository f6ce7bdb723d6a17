"""The FMUs for Model Exchange of a system as one participant: their states are one vector, integrated together.

    group = Group([ball, wall], [LinkBlock((Link((0, "h"), (1, "h")),))], SolverSettings())
    ...                                      # the members are initialized
    group.begin()                            # their first event
    group.step(0.0, 0.01)

`loop.run` steps it by address, as any FMU: the address of its table is the instance, `step` has the signature of
fmi3DoStep.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from ...errors import FmuError
from ...integration import cells
from ...integration.choice import choose
from ...integration.compiled import address_of
from ...integration.events.rounds import NEVER
from ...integration.memory import call, number, put, put_whole, whole
from ...integration.settings import TOLERANCE, SolverSettings
from ...integration.stiff.libraries import is_there, why_missing
from ...integration.stiff.offered import why_differences
from ...integration.stiff.sundials import Cvode
from ...loop.calls import STEP_FLAGS, do_step3
from ..here.loaded import LoadedInstance
from .links import Crossed, LinkBlock
from .memory import LOGGED, GroupMemory
from .pattern import bands_of
from .tables import needs_completed
from .words import forgotten, notes, why

CELL = cells.CELL
METHODS = {"dormand-prince": cells.DORMAND_PRINCE, "rk4": cells.RUNGE_KUTTA, "cvode": cells.CVODES}
CODES = {code: name for name, code in METHODS.items()}


class Event(NamedTuple):
    """An event inside a step: when [s], whose, and its indicator, or one of cells.TIME_EVENT..."""

    time: float
    member: str
    indicator: int


class Group(GroupMemory):
    """`blocks`: the links between the members, each behind those that it needs. `watched`: addresses of the inputs from
    outside; where one is not what it was, the solver begins anew. `ends_early`: a step ends at an event, which others
    handle, see `GroupEvents`; `crossings` are such events too. Raises FmuError if that cannot be."""

    def __init__(
        self, members: Sequence[LoadedInstance], blocks: Sequence[LinkBlock] = (),
        settings: SolverSettings | None = None, rests_in_events: bool = False, watched: Sequence[int] = (),
        ends_early: bool = False, crossings: Sequence[Crossed] = (),
    ) -> None:  # fmt: skip
        self.settings = settings or SolverSettings()
        self.begun, self.goes_back = False, False  # `goes_back`: its state is saved at every step, and may be restored
        self.ends_early = ends_early
        self._flags = np.zeros(STEP_FLAGS, dtype=np.uint8)
        self._cvode: Cvode | None = None
        super().__init__(members, blocks, watched, crossings)
        for cell, value in (
            (cells.RESTS_IN_EVENTS, rests_in_events),
            (cells.ENDS_EARLY, ends_early),
            (cells.CHANGED, 1),
        ):
            put_whole(self.pointer + cell, int(value))

    @property
    def tolerance(self) -> float:
        """Relative: stated, or the smallest of the members', or the usual one."""
        stated = [member.tolerance for member in self.members if member.tolerance is not None]
        return self.settings.tolerance or min(stated, default=TOLERANCE)

    def begin(self, time: float = 0.0) -> None:
        """Behind initialization mode: the first event of all members. Raises FmuError if that fails."""
        g, settings = self.pointer, self.settings
        put(g + cells.TIME, time)
        put(g + cells.WINDOW, time)
        put(g + cells.NEXT_EVENT, NEVER)
        put(g + cells.RELATIVE, self.tolerance)
        put(g + cells.LONGEST, settings.max_step or NEVER)
        put(g + cells.STEP, (settings.step or NEVER) if settings.method == "rk4" else 0.0)
        self.chosen = choose(settings, self.tables.states)
        put_whole(g + cells.METHOD, METHODS[self.chosen.method])
        put_whole(g + cells.RESTARTS, int(settings.restart))
        put_whole(g + cells.CV_ONE_STEP, int(any(map(needs_completed, self.members))))
        status = call(address_of("begin"), g)
        if status == 2:
            who = self.members[whole(g + cells.FAULT_MEMBER)]
            raise FmuError(f"component {who.name} asks to end the simulation at its start{who.log_text()}")
        self.require_good(status)
        self.begun = True
        if self.chosen.method == "cvode":
            self.make_cvode()
        elif self.chosen.method == "dormand-prince" and self.tables.states:
            self.make_cvode(needed=False)

    def make_cvode(self, needed: bool = True) -> None:
        """An integrator, to be used at once or should the group prove stiff. Raises FmuError if there is none."""
        if not is_there():
            if needed:
                raise FmuError(f'{why_missing()}, or take method = "dormand-prince" under [solver]')
            return
        links = [link for block in self.blocks for link in block.links if self.tables.solved(link)]
        sources, fmus = {link.target: link.source for link in links}, [member.fmu for member in self.members]
        self.bands = bands_of(fmus, sources)
        self.exact = why_differences(fmus, sources.values()) is None
        put_whole(self.pointer + cells.RESTART, 1)
        self._cvode = Cvode(self.pointer, self.settings, self.bands, self.exact)

    def replace_cvode(self, exact: bool) -> None:
        """Another integrator, whose Jacobian is made of directional derivatives or of differences."""
        self.free()
        self.exact = exact
        put_whole(self.pointer + cells.RESTART, 1)
        self._cvode = Cvode(self.pointer, self.settings, self.bands, exact)

    @property
    def time(self) -> float:
        """Where it is [s]."""
        return number(self.pointer + cells.TIME)

    @property
    def method(self) -> str:
        """Of integration, now."""
        return CODES[whole(self.pointer + cells.METHOD)]

    @property
    def asks_to_end(self) -> bool:
        """Whether a member asked to end in the last step."""
        return whole(self.pointer + cells.ENDED) != 0

    @property
    def failed(self) -> bool:
        """Whether the last step failed."""
        return whole(self.pointer + cells.FAULT) != cells.NOTHING

    @property
    def failed_name(self) -> str:
        """The member whose call failed."""
        return self.at_fault.name

    @property
    def at_fault(self) -> LoadedInstance:
        """The member whose call failed, or who asks to end."""
        return self.members[whole(self.pointer + cells.FAULT_MEMBER)]

    @property
    def answered(self) -> int:
        """The status of the call that failed."""
        return whole(self.pointer + cells.FAULT_STATUS)

    def why(self) -> str:
        """What went wrong in the last step, in words."""
        return why(self.pointer, [member.fmu.own for member in self.members])

    def notes(self) -> list[str]:
        """What the run must tell of it."""
        chosen = self.chosen if self.begun else None
        return notes(self.pointer, [member.name for member in self.members], chosen, self.goes_back)

    def forgets(self) -> str:
        """What a run that is taken up here does not go on with, in words; empty where it is as if never stopped."""
        return "" if self.goes_back else forgotten(self.pointer, [member.name for member in self.members])

    def counts(self) -> Mapping[str, int]:
        """Steps of the solver, those that were rejected, evaluations of all right-hand sides, events."""
        names = {"steps": cells.STEPS, "rejected": cells.REJECTED, "evaluations": cells.EVALUATIONS,
                 "events": cells.EVENTS, "directional derivatives": cells.DIRECTIONALS}  # fmt: skip
        return {name: whole(self.pointer + cell) for name, cell in names.items()}

    def events(self, most: int = LOGGED) -> list[Event]:
        """The last events inside steps, in their order."""
        count, log = whole(self.pointer + cells.LOG_COUNT), self._arrays[cells.LOG]
        found = []
        for k in range(max(count - most, 0), count):
            time, member, indicator = log[3 * (k % LOGGED) : 3 * (k % LOGGED) + 3]
            bits = np.array([member, indicator]).view(np.int64)
            found.append(Event(float(time), self.members[int(bits[0])].name, int(bits[1])))
        return found

    def changed(self) -> None:
        """Something was set: the solver begins anew."""
        put_whole(self.pointer + cells.CHANGED, 1)

    def enter_events(self) -> None:
        """Put all members into event mode, where anything may be set; the next step begins with the event."""
        if not whole(self.pointer + cells.IN_EVENTS):
            self.require_good(call(address_of("enter"), self.pointer))

    def require_good(self, status: int) -> None:
        """Raise FmuError, with its cause, where a function of the group has failed."""
        if status:
            raise FmuError(f"component {self.failed_name}: {self.why()}{self.at_fault.reasons()}")

    @property
    def pending(self) -> bool:
        """Whether its last step ended at an event, which is to be handled."""
        return whole(self.pointer + cells.PENDING) != 0

    def why_stopped(self) -> str:
        """Why its last step ended at an event, in words."""
        last = next(iter(self.events(1)), None)
        if last is None or last.time != self.time:
            return f"{self.members[0].name} is in event mode, as something was set"
        if last.indicator <= cells.CROSSES:
            return self.crossings[cells.CROSSES - last.indicator].text
        return f"{last.member} has {'a time event' if last.indicator == cells.TIME_EVENT else 'an event'}"

    def step(self, time: float, length: float, final: bool = False) -> bool:
        """Go from `time` over `length` [s]; whether a member asks to end. `failed` and `why` tell what went wrong."""
        flags = int(self._flags.ctypes.data)
        do_step3(address_of("step"), self.pointer, time, length, int(final), flags)
        return bool(self._flags[1])

    def size_of_state(self) -> int:
        """Bytes of what the group keeps beside its members."""
        return CELL * cells.KEPT + whole(self.pointer + cells.ARRAYS_SIZE)

    def free(self) -> None:
        """Give the solver back."""
        if self._cvode is not None:
            self._cvode.free()
            self._cvode = None
            put_whole(self.pointer + cells.CVODE, 0)
