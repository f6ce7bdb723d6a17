"""The keys of a system file.

The tables of settings of algorithms stand beside them and are kept as they are: what they may hold is known, and
checked before time 0, by `plan/algorithms`.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct, field

from ....fmu.kinds import Kind
from .ardusub import ArduSubTable
from .bonds import BondTable, RequirementTable
from .event import EventTable
from .live import LiveTable
from .message import MessageTable
from .outside import DeclareTable, SharedMemoryTable, UdpTable
from .report import Balance, Comparison, Figure, Window
from .solving import Loops, Solver
from .values import FigureOfMerit, Instant, Number, Positive, Time, Value, Values

TRANSFERS = ("hold", "linear", "quadratic", "interpolate", "mean")
CONNECTION = r"^\s*\w+\..+->\s*\w+\..+$"


class Table(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A table that follows the rows of a list or of a CSV file."""

    csv: Annotated[str | None, Meta(description="a CSV file beside the system file, with a column `time`")] = None
    column: Annotated[str | None, Meta(description="its column; `component.input` where nothing is stated")] = None
    time: Annotated[list[Number] | None, Meta(description="the times [s], rising, in place of a file")] = None
    values: Annotated[list[Any] | None, Meta(description="a value for each time; of an array a list for each")] = None
    unit: Annotated[str | None, Meta(description="of `values`; the input's own where nothing is stated")] = None


class ComponentTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One FMU, or what takes part as one, how often it communicates, and the values that it starts with."""

    fmu: Annotated[
        str | None,
        Meta(
            description="the name of a built FMU, or the path of a .fmu from the system file's folder; or one of "
            "`python`, `udp`, `shared_memory` and `ardusub` in its place"
        ),
    ] = None
    python: Annotated[
        str | None,
        Meta(
            description="a function, or a class with `step`, in a Python file in the system file's folder: "
            "`file.py:name`",
            examples=["controller.py:step", "controller.py:Controller"],
        ),
    ] = None
    udp: Annotated[UdpTable | None, Meta(description="signals to and from another program as UDP packets")] = None
    shared_memory: Annotated[
        SharedMemoryTable | None, Meta(description="signals to and from another process through shared memory")
    ] = None
    ardusub: Annotated[
        ArduSubTable | None, Meta(description="ArduPilot's autopilot for submarines (SITL), in lock-step with the run")
    ] = None
    declare: Annotated[DeclareTable, Meta(description="the variables of what is no FMU")] = DeclareTable()
    period: Annotated[Time, Meta(description="the communication step")]
    kind: Annotated[
        Kind | None, Meta(description="how an FMU of several kinds is run; else as co-simulation where it can be")
    ] = None
    parameters: Annotated[
        Values,
        Meta(
            description="start values of parameters; a list for an array; structural parameters give arrays their "
            'sizes; a Binary value is hexadecimal, `"base64:..."` or `"file:PATH"`'
        ),
    ] = {}
    inputs: Annotated[
        dict[str, Value | list[Value] | Table],
        Meta(
            description="inputs that no connection drives: a value held over the run, a list for an array, or a table"
        ),
    ] = {}
    isolation: Annotated[
        Annotated[
            str,
            Meta(
                extra_json_schema={"anyOf": [{"enum": ["none", "process"]}, {"pattern": r"^tcp://\S+:\d+$"}]},
                extra={"must": '"none", "process" or "tcp://HOST:PORT"'},
            ),
        ],
        Meta(
            description='"process": the FMU runs in a process of its own; "tcp://HOST:PORT": in one of '
            "`rovbrush serve` there"
        ),
    ] = "none"
    logging: Annotated[
        Literal["warnings", "all"],
        Meta(description='"all": the FMU logs all that it can, which may cost many times its own time'),
    ] = "warnings"
    tolerance: Annotated[
        Positive | None,
        Meta(description="relative tolerance of its solver; else that of its default experiment, if it states one"),
    ] = None
    token_file: Annotated[
        str, Meta(description="the file that holds the token of that server; else the environment's ROVBRUSH_TOKEN")
    ] = ""
    timeout: Annotated[Time, Meta(description="of one call to an FMU in a process of its own, in wall time")] = "60 s"
    direct: Annotated[
        Literal["stated", "all", "off"],
        Meta(
            description='outputs that answer to inputs at once: those that the FMU states, "all", or "off", where it '
            "must not be read again at an instant"
        ),
    ] = "stated"
    event_mode: Annotated[
        Literal["offered", "off"],
        Meta(
            description='"off": the event mode of an FMI 3.0 FMU is not used, also where it offers one; of Model '
            "Exchange: events of the group are handled inside its steps"
        ),
    ] = "offered"
    parallel: Annotated[
        Literal["allowed", "off"],
        Meta(description='"off": it is not stepped on a thread of its own, see `workers`'),
    ] = "allowed"
    clocks: Annotated[
        dict[str, Time], Meta(description="intervals of clocks that are to be set, by the name of the clock")
    ] = {}
    compile: Annotated[
        bool, Meta(description="true: its C or C++ sources are compiled where it brings no library for this machine")
    ] = False
    units: Annotated[
        dict[str, str] | str,
        Meta(
            description="units of variables for which the FMU states none, or a TOML file with such lines",
            extra={"must": "a table, or the name of a file"},
        ),
    ] = {}


class SystemTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A system: components, connections, how they are coupled, and what is reported of a run."""

    stop_time: Annotated[
        Instant,
        Meta(description="where a run ends; a whole number of periods behind its start, where an FMU has fixed steps"),
    ]
    components: Annotated[
        dict[str, ComponentTable], Meta(description="the FMUs, by the names that the system gives them")
    ]
    start_time: Annotated[
        Instant, Meta(description="where a run begins: the time that FMUs and tables see first; may be negative")
    ] = 0
    format: Annotated[
        Literal[1, 2],
        Meta(
            description="of the file; new ones have 2. Without it `run` says which inputs it holds that were "
            "extrapolated before, and names under `record` that nothing has are warnings"
        ),
    ] = 1
    description: Annotated[str, Meta(description="what the system is, in a line")] = ""
    algorithm: Annotated[
        str, Meta(description="how the components are coupled", extra={"says": "unknown algorithm {value}"})
    ] = "gauss-seidel"
    order: Annotated[
        list[str], Meta(description="of the components in a Gauss-Seidel step, each once; else the plan finds one")
    ] = []
    parameters: Annotated[
        str | None,
        Meta(
            description="a set of parameters: a TOML file with a table of values for each component, or the name of "
            "one beside this file or of a shipped one; values of this file come over them",
            extra={"must": "the name of a parameter set or of its file"},
        ),
    ] = None
    workers: Annotated[
        Annotated[int, Meta(ge=1, le=256)] | Literal["auto"],
        Meta(
            description='threads that step FMUs which need nothing of each other at an instant: a number, or "auto": '
            "as many as pay, by what the first steps take; the results are the same bits",
            extra={"must": 'a number from 1 to 256, or "auto"'},
        ),
    ] = 1
    connections: Annotated[
        list[Any],
        Meta(
            description='`"a.output -> b.input"`, or `"a.output -> b.input (mean)"` with a transfer of your choice: '
            "hold, linear, quadratic, interpolate, mean; `(mean of a.counter)` takes the mean exactly, from an output "
            "that counts the time integral; `(round)` allows what the input's type does not hold; "
            '`"a.port -> b.port"` connects all that two terminals have in common',
            extra_json_schema={"items": {"type": "string", "pattern": CONNECTION}},
        ),
    ] = []
    loops: Annotated[Loops, Meta(description="loops of direct dependence")] = Loops()
    solver: Annotated[Solver, Meta(description="integration of FMUs for Model Exchange")] = Solver()
    bonds: Annotated[list[BondTable], Meta(description="power bonds, of which the energy is counted")] = []
    events: Annotated[
        list[EventTable], Meta(description="what happens in a run: inputs that change, signals that break")
    ] = []
    require: Annotated[list[RequirementTable], Meta(description="what must hold at the start of a run")] = []
    record: Annotated[
        list[str],
        Meta(
            description="names of what is recorded, `component.variable`, locals and parameters too; `*` and `?` stand "
            "for inputs and outputs"
        ),
    ] = field(default_factory=lambda: ["*"])
    summary: Annotated[
        dict[str, FigureOfMerit | Window],
        Meta(description="figures of merit, an operation and its signals; `window` is the steady window they are of"),
    ] = {}
    balance: Annotated[Balance, Meta(description="energies that components count, over the whole run")] = Balance()
    compare: Annotated[list[Comparison], Meta(description="figures of merit beside reference values")] = []
    figures: Annotated[list[Figure], Meta(description="what is drawn")] = []
    live: Annotated[LiveTable, Meta(description="the page of `rovbrush live`")] = LiveTable()
    messages: Annotated[
        list[MessageTable], Meta(description="poses, wrenches and twists that signals make together, for observers")
    ] = []


KEYS = tuple(SystemTable.__struct_encode_fields__)
