"""FMUs for Model Exchange for tests: the models under fixtures/exchange, each with a closed form."""

from __future__ import annotations

from pathlib import Path

from rovbrush.orchestrator.studies.bench.fmus import exchange as build
from rovbrush.orchestrator.studies.bench.fmus.exchange import Model, Var

MODELS = Path(__file__).parent / "fixtures" / "exchange"


def parameter(name: str, reference: int, start: str, variability: str = "tunable", kind: str = "Real") -> Var:
    return Var(name, reference, "parameter", start=start, variability=variability, kind=kind)


BALL = Model(
    MODELS / "ball.c",
    [Var("h", 0, start="1", needs=["h"]), Var("v", 1, start="0", needs=["v"]),
     Var("der(h)", 2, "local", state="h", needs=["v"]), Var("der(v)", 3, "local", state="v", needs=["u"]),
     parameter("g", 4, "9.81"), parameter("e", 5, "0.7"), parameter("v_rest", 6, "0"), Var("u", 7, "input", start="0"),
     Var("hits", 0, kind="Integer", needs=[])],
    indicators=1,
)  # fmt: skip
PUCK = [
    Var("x", 0, start="0", needs=["x"]), Var("v", 1, start="0", needs=["v"]),
    Var("der(x)", 2, "local", state="x", needs=["v"]), Var("der(v)", 3, "local", state="v", needs=[]),
    parameter("m", 4, "1"), parameter("m2", 5, "1"), parameter("e", 6, "1"), parameter("wall", 7, "1e9"),
    parameter("side", 11, "1"),
]  # fmt: skip
STRIKER = Model(
    MODELS / "puck.c",
    [*PUCK, Var("x2", 8, "input", start="1"), Var("v2", 9, "input", start="0"),
     Var("J", 10, variability="discrete", needs=[]), Var("n", 0, kind="Integer", needs=[])],
    indicators=2,
)  # fmt: skip
STRUCK = Model(
    MODELS / "puck.c",
    [*PUCK, Var("J", 10, "input", start="0", variability="discrete"), Var("n", 0, "input", kind="Integer", start="0")],
    indicators=2,
)  # fmt: skip
STICK_SLIP = Model(
    MODELS / "stick_slip.c",
    [Var("x", 0, start="0", needs=["x"]), Var("v", 1, start="0.2", needs=["v"]),
     Var("der(x)", 2, "local", state="x", needs=["v"]), Var("der(v)", 3, "local", state="v", needs=["x"]),
     parameter("m", 4, "1"), parameter("k", 5, "1"), parameter("v_b", 6, "0.2"), parameter("F_s", 7, "1"),
     parameter("F_k", 8, "0.6"), Var("F", 9, needs=["x"]), Var("slips", 0, kind="Boolean", needs=[]),
     Var("switches", 1, kind="Integer", needs=[]), Var("t_switch", 10, variability="discrete", needs=[])],
    indicators=1,
)  # fmt: skip
RELAY = Model(
    MODELS / "relay.c",
    [Var("y", 0, "input", start="0"), parameter("low", 1, "-1"), parameter("high", 2, "1"),
     Var("on", 0, kind="Boolean", needs=[]), Var("switches", 1, kind="Integer", needs=[]),
     Var("t_switch", 3, variability="discrete", needs=[])],
    indicators=2,
)  # fmt: skip
LAG = Model(
    MODELS / "lag.c",
    [Var("x", 0, start="0", needs=["x"]), Var("der(x)", 1, "local", state="x", needs=["x", "push"]),
     parameter("tau", 2, "1"), parameter("gain", 3, "1"), Var("push", 4, "input", start="0"),
     Var("y", 5, needs=["x", "push"]), parameter("d", 6, "0"), Var("on", 0, "input", kind="Boolean", start="false")],
)  # fmt: skip
MOODY = Model(
    MODELS / "moody.c",
    [Var("x", 0, start="0", needs=["x"]), Var("der(x)", 1, "local", state="x", needs=["x"]), parameter("at", 2, "0.55"),
     parameter("period", 3, "1e9"), parameter("fault", 0, "0", kind="Integer"), Var("n", 1, kind="Integer", needs=[]),
     Var("stepped", 2, kind="Integer", needs=[]), Var("rounds", 3, kind="Integer", needs=[])],
    indicators=1, completed=True,
)  # fmt: skip
REFUSES = Model(MODELS / "refuses.c", LAG.variables)
PLAIN = Model(MODELS / "lag.c", LAG.variables, directional=False)
FORCED = Model(
    MODELS / "forced.c",
    [Var("x", 0, start="0", needs=["x"]), Var("der(x)", 1, "local", state="x", needs=["x"]),
     parameter("rate", 2, "1"), parameter("w", 3, "1")],
)  # fmt: skip
DRAIN = Model(
    MODELS / "drain.c",
    [Var("x", 0, start="1", needs=["x"]), Var("der(x)", 1, "local", state="x", needs=["x"]), parameter("floor", 2, "0"),
     Var("touched", 3, variability="discrete", needs=[]), parameter("falls", 0, "false", kind="Boolean"),
     parameter("refuses", 1, "false", kind="Boolean")],
    indicators=1, directional=False,
)  # fmt: skip
STEPS = Model(
    MODELS / "steps.c",
    [Var("x", 0, start="0", needs=["x"]), Var("der(x)", 1, "local", state="x", needs=[]),
     Var("last", 2, variability="discrete", needs=[]), parameter("size", 3, "1"),
     parameter("every", 0, "0", kind="Integer"), parameter("end", 1, "0", kind="Integer"),
     parameter("fatal", 2, "false", kind="Boolean"), Var("n", 3, kind="Integer", needs=[]),
     Var("met", 4, kind="Integer", needs=[])],
    completed=True,
)  # fmt: skip
PENDULUM = Model(
    MODELS / "pendulum.c",
    [Var("q", 0, "local", start="0"), Var("w", 1, "local", start="0"),
     Var("der(q)", 2, "local", state="q", needs=["w"]), Var("der(w)", 3, "local", state="w", needs=["q", "w"]),
     parameter("start", 4, "2.5"), Var("x", 5, needs=["q"]), Var("y", 6, needs=["q"]), parameter("g", 9, "9.81"),
     Var("changes", 1, kind="Integer", needs=[])],
    completed=True, directional=False,
)  # fmt: skip
MODELS_BY_NAME = {
    "ball": BALL, "striker": STRIKER, "struck": STRUCK, "stick_slip": STICK_SLIP, "relay": RELAY, "lag": LAG,
    "moody": MOODY, "forced": FORCED, "drain": DRAIN, "steps": STEPS, "pendulum": PENDULUM, "refuses": REFUSES,
    "plain_lag": PLAIN, "oscillator": build.oscillator(),
}  # fmt: skip


def exchange(folder: Path, name: str, version: int = 2, both: bool = False) -> Path:
    """One of the models as an FMU `name.fmu`."""
    target = folder / f"{name}.fmu"
    if not target.exists():
        defines = {"STRIKER": 1} if name == "striker" else {}
        build.exchange_fmu(target, MODELS_BY_NAME[name], version, defines, both)
    return target


def chain(folder: Path, cells: int = 1000, both: bool = False) -> Path:
    """A rod of so many cells."""
    target = folder / f"chain{cells}.fmu"
    return build.exchange_fmu(target, build.chain(cells), 2, {"N": cells}, both)
