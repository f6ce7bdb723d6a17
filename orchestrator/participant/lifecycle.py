"""The life of an FMU for co-simulation: which calls are allowed when, and where each leads.

One table for each version, as the standards have it: FMI 1.0 for Co-Simulation, section 2.9; FMI 2.0.4, section 4.2.4;
FMI 3.0.2, sections 2.3, 4.2.1 and 5.2.1 (scheduled execution), without what no master here does (intermediate update).
What a standard leaves to the importer is decided here. FMI 1.0 has no initialization mode: it is the time between the
last start value and `fmiInitializeSlave`, and ends with the first get. The order that follows for a run:

    instantiate -> set up (tolerance, start, stop) -> set parameters and start values -> enter initialization
    -> set inputs, get outputs until they are consistent -> exit initialization -> get the outputs again
    -> [set, get, step]* -> terminate, unless there was an error -> free, unless it was fatal

With event mode [clocks, set, get, update]* comes before the first step and wherever something happens; what is
scheduled takes [set, activate, get]* instead of steps.
"""

from __future__ import annotations

from enum import Enum

from fmpy.model_description import ModelVariable

from ..fmu.reading.structure import STRUCTURAL

OK, WARNING, DISCARD, ERROR, FATAL, PENDING = range(6)
STATUS = {OK: "OK", WARNING: "Warning", DISCARD: "Discard", ERROR: "Error", FATAL: "Fatal", PENDING: "Pending"}


class State(Enum):
    """Where in its life an instance is; the values are words for messages."""

    INSTANTIATED = "instantiated"
    CONFIGURING = "in configuration mode"
    INITIALIZING = "in initialization mode"
    STEPPING = "between two steps"
    EVENTS = "in event mode"
    ACTIVATING = "between two activations"
    CLOCKS_TOLD = "in clock update mode"
    INPUTS_SET = "between two steps, with inputs set"
    STEP_FAILED = "behind a step that it discarded"
    STEP_PENDING = "in a step that goes on"
    STEP_CANCELED = "behind a step that was canceled"
    TERMINATED = "terminated"
    FAILED = "behind an error"
    DEAD = "behind a fatal error"
    FREED = "freed"


_I, _G, _M, _S, _U, _F, _P, _C, _T, _E = (
    State.INSTANTIATED, State.CONFIGURING, State.INITIALIZING, State.STEPPING, State.INPUTS_SET,
    State.STEP_FAILED, State.STEP_PENDING, State.STEP_CANCELED, State.TERMINATED, State.FAILED,
)  # fmt: skip
_V, _A, _K = State.EVENTS, State.ACTIVATING, State.CLOCKS_TOLD
_BETWEEN = frozenset({_S, _U})
_ANY = frozenset({_I, _G, _M, _S, _U, _F, _C, _T, _E, _V, _A})  # but in a step, and behind a fatal error

# The one deviation from a standard. FMI 1.0 and 2.0 (4.2.4) allow no get after a set before the next step. A coupling
# by Gauss-Seidel or by bonds reads outputs that inputs act on at once; other masters do so too, and FMI 3.0 allows it.
GET_AFTER_SET = frozenset({_U})

_COMMON: dict[str, frozenset[State]] = {
    "set up": frozenset({_I}), "enter": frozenset({_I}), "exit": frozenset({_M}), "step": _BETWEEN,
    "set": frozenset({_I, _M}) | _BETWEEN, "reset": _ANY, "free": _ANY,
    "save": _ANY, "restore": _ANY, "forget": _ANY, "serialize": _ANY, "deserialize": _ANY,
}  # fmt: skip
ALLOWED: dict[int, dict[str, frozenset[State]]] = {
    1: _COMMON | dict.fromkeys(("save", "restore", "forget", "serialize", "deserialize"), frozenset[State]()) | {
        "get": frozenset({_S, _F, _C, _E}) | GET_AFTER_SET,
        "terminate": _BETWEEN | {_F},
        "ask": frozenset({_S, _U, _P, _F}),
        "cancel": frozenset({_P}),
    },
    2: _COMMON | {
        "get": frozenset({_M, _S, _F, _C, _T, _E}) | GET_AFTER_SET,
        "terminate": _BETWEEN | {_F},
        "ask": frozenset({_S, _U, _P, _F, _T}),
        "cancel": frozenset({_P}),
    },
    3: _COMMON | {
        "get": frozenset({_M, _S, _U, _F, _T, _V, _A}),
        "set": frozenset({_I, _G, _M, _V, _A}) | _BETWEEN,
        "configure": frozenset({_I}), "configured": frozenset({_G}),
        "terminate": _BETWEEN | {_F, _V, _A},
        "exit to events": frozenset({_M}), "enter events": _BETWEEN, "leave events": frozenset({_V}),
        "update": frozenset({_V}), "get clocks": frozenset({_V, _K}), "set clocks": frozenset({_V}),
        "get intervals": frozenset({_M, _V, _A, _K}), "set intervals": frozenset({_M, _V, _A}),
        "exit to activations": frozenset({_M}), "activate": frozenset({_A}),
        "ask": frozenset(),
        "cancel": frozenset(),
    },
}  # fmt: skip
PREFIX = {1: "fmi", 2: "fmi2", 3: "fmi3"}  # of functions and statuses
STATE_FUNCTIONS = {  # that save, restore and forget a state
    1: ("", "", ""),
    2: ("fmi2GetFMUstate", "fmi2SetFMUstate", "fmi2FreeFMUstate"),
    3: ("fmi3GetFMUState", "fmi3SetFMUState", "fmi3FreeFMUState"),
}
SECTION = {1: "FMI 1.0 for Co-Simulation, section 2.9", 2: "FMI 2.0, section 4.2.4", 3: "FMI 3.0, section 4.2.1"}

# Where a call leads that succeeds; the others change nothing.
_NEXT = {
    "configure": _G, "configured": _I, "enter": _M, "exit": _S, "step": _S, "terminate": _T, "reset": _I,
    "free": State.FREED, "cancel": _C,
    "exit to events": _V, "enter events": _V, "leave events": _S, "exit to activations": _A,
}  # fmt: skip


def allowed(version: int, action: str, state: State) -> bool:
    """Whether a standard allows an action in a state."""
    return state in ALLOWED[version][action]


def after(action: str, state: State, status: int) -> State:
    """The state behind an action that was answered with a status; one that FMI does not know is an error."""
    if status in (OK, WARNING):
        return _U if action == "set" and state is _S else _NEXT.get(action, state)
    if status == DISCARD and action != "activate":  # there it is an error
        return _F if action == "step" else state
    if status == PENDING and action == "step":
        return _P
    return State.DEAD if status == FATAL else _E


def good(status: int) -> bool:
    """Whether a call did what was asked."""
    return status in (OK, WARNING)


def status_text(prefix: str, status: int) -> str:
    """A status by its name, `fmi2Error`; one that FMI does not know by its number."""
    return f"{prefix}{STATUS[status]}" if status in STATUS else f"status {status}, which FMI does not know"


def why_not_settable(state: State, variable: ModelVariable) -> str:
    """Why a variable cannot be set in a state that allows setting; empty where it can."""
    if variable.variability == "constant":
        return "it is a constant"
    structural = variable.causality == STRUCTURAL
    if structural or state is State.CONFIGURING:
        alone = structural and state is State.CONFIGURING
        return "" if alone else "structural parameters, and they alone, are set in configuration mode"
    if state not in (*_BETWEEN, _V, _A) or variable.causality == "input" or variable.variability == "tunable":
        return ""
    kind = f"{variable.variability or ''} {variable.causality}".strip()
    return f"it is a {kind}; after initialization only inputs and tunable parameters can be set"
