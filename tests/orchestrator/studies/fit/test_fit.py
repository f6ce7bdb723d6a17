"""Fits of the motor to logs that its own runs made: estimates, their intervals, and what is said of bad data."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rovbrush.orchestrator import InputError, RunError, load
from rovbrush.orchestrator.studies.fit.experiment import Recipe
from rovbrush.orchestrator.studies.fit.file import fit_file, is_fit_file
from rovbrush.orchestrator.studies.fit.fit import Fitted, Options, fit

SYSTEM = """
format = 2
stop_time = "1 s"
[components.motor]
fmu = "dc_motor"
period = "10 ms"
inputs = { V_in = 9.0, T_brush = { time = [0.0, 0.6, 0.6, 1.0], values = [0.0, 0.0, 8.0, 8.0] } }
"""
TRUE = {"motor.R": 0.09, "motor.B_m": 8e-4}
VARY = ("motor.R=0.04:0.2", "motor.B_m=2e-4:3e-3:log")
MATCH = ("motor.i,motor.omega_b",)
Write = Callable[..., Path]


@pytest.fixture(scope="module")
def bench(native: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path, dict[str, np.ndarray]]:
    """The system, the FMUs, and a run with the true values."""
    path = tmp_path_factory.mktemp("fit") / "motor.toml"
    path.write_text(SYSTEM, encoding="utf-8")
    result = load(path, fmus=native / "fmi2", values=TRUE, record=["motor.i", "motor.omega_b"]).run()
    columns = {"time": result["motor.i"].time.values}
    columns |= {name: result[name].values for name in ("motor.i", "motor.omega_b")}
    return path, native / "fmi2", columns


@pytest.fixture
def log(bench: tuple[Path, Path, dict[str, np.ndarray]], tmp_path: Path) -> Write:
    """A log: the run with noise of 0.5 A and 0.02 rad/s, changed by `of`."""

    def write(of: Callable[[dict[str, Any]], dict[str, Any]] = dict, name: str = "log.csv", noise: float = 1.0) -> Path:
        random = np.random.default_rng(4)
        columns: dict[str, Any] = dict(bench[2])
        for signal, sigma in (("motor.i", 0.5), ("motor.omega_b", 0.02)):
            columns[signal] = columns[signal] + noise * sigma * random.normal(size=len(columns[signal]))
        columns = of(columns)
        rows = zip(*([v if isinstance(v, str) else repr(float(v)) for v in c] for c in columns.values()), strict=True)
        path = tmp_path / name
        path.write_text("\n".join([",".join(columns), *map(",".join, rows)]) + "\n", encoding="utf-8")
        return path

    return write


@pytest.fixture
def fitted(bench: tuple[Path, Path, dict[str, np.ndarray]]) -> Callable[..., Fitted]:
    """Fit the motor to logs."""

    def run(*logs: Path, vary: tuple[str, ...] = VARY, match: tuple[str, ...] = MATCH, out: Path | None = None,
            tell: Callable[[str], None] = lambda _line: None, **of: Any) -> Fitted:  # fmt: skip
        recipe = {key: of.pop(key) for key in ("start", "stop") if key in of}
        recipes = [path if isinstance(path, Recipe) else Recipe(path, **recipe) for path in logs]
        return fit(str(bench[0]), recipes, Options(vary, match, fmus=bench[1], **of), out, tell)

    return run


def test_without_noise_the_values_are_found(log: Write, fitted: Callable[..., Fitted]) -> None:
    found = fitted(log(noise=0.0))
    for one in found.estimates:
        assert one.value == pytest.approx(TRUE[one.name], rel=1e-6)


def test_intervals_hold_the_values_and_files_say_the_same(
    log: Write, fitted: Callable[..., Fitted], bench: tuple[Path, Path, dict[str, np.ndarray]], tmp_path: Path
) -> None:
    found = fitted(log(), out=tmp_path / "out").require_identified()
    for one in found.estimates:
        assert one.low < TRUE[one.name] < one.high
        assert one.low < one.value < one.high and one.error > 0.0 and not one.at_bound
    assert [one.rms for one in found.signals] == pytest.approx([0.5, 0.02], rel=0.2)
    assert np.allclose(np.diag(found.correlations), 1.0)
    content = json.loads((tmp_path / "out/fit.json").read_text(encoding="utf-8"))
    assert {name: entry["value"] for name, entry in content["parameters"].items()} == found.values
    chosen = tomllib.loads((tmp_path / "out/fitted.toml").read_text(encoding="utf-8"))
    assert {f"motor.{name}": value for name, value in chosen["motor"].items()} == found.values
    model = load(bench[0], fmus=bench[1], parameters=tmp_path / "out/fitted.toml")
    assert model.system.components["motor"].parameters["R"] == found.values["motor.R"]
    assert (tmp_path / "out/fit.png").read_bytes().startswith(b"\x89PNG")
    assert len((tmp_path / "out/fit.csv").read_text(encoding="utf-8").splitlines()) == 1 + 2 * 101


def test_the_standard_error_is_that_of_repeated_measurements(log: Write, fitted: Callable[..., Fitted]) -> None:
    """Four times the noise, four times the error; four times the rows by two logs of twice as many, half of it."""
    one = fitted(log()).estimates[0].error
    assert fitted(log(noise=4.0)).estimates[0].error == pytest.approx(4.0 * one, rel=0.05)
    assert fitted(*[log(name=f"{k}.csv") for k in range(4)]).estimates[0].error == pytest.approx(0.5 * one, rel=0.05)


def test_units_other_times_gaps_and_further_columns(log: Write, fitted: Callable[..., Fitted]) -> None:
    """The same data in mA and ms, every third cell of one column missing, and a column that nobody knows."""

    def other(columns: dict[str, Any]) -> dict[str, Any]:
        speed = [repr(float(v)) if k % 3 else ("nan" if k % 2 else "") for k, v in enumerate(columns["motor.omega_b"])]
        return {"time [ms]": 1e3 * columns["time"], "current [mA]": 1e3 * columns["motor.i"], "motor.omega_b": speed,
                "room": 20.0 + columns["time"]}  # fmt: skip

    said: list[str] = []
    plain, found = fitted(log()), fitted(log(other), match=("motor.i=current", "motor.omega_b"), tell=said.append)
    assert found.signals[0].rows == 101 and found.signals[1].rows == 67
    assert found.values["motor.R"] == pytest.approx(plain.values["motor.R"], rel=0.01)
    assert any("gaps" in line for line in said) and any("column 'room' is not used" in line for line in said)


def test_columns_of_free_inputs_drive_them(log: Write, fitted: Callable[..., Fitted]) -> None:
    """A log made at 9 V that says 12 V is not explained by the true values."""

    def driven(columns: dict[str, Any], volts: float) -> dict[str, Any]:
        return {**columns, "motor.V_in": np.full(len(columns["time"]), volts)}

    right = fitted(log(lambda c: driven(c, 9.0)))
    wrong = fitted(log(lambda c: driven(c, 12.0)))
    assert right.values == pytest.approx(TRUE, rel=0.05)
    assert wrong.signals[0].rms > 10.0 * right.signals[0].rms
    assert any("follows itself" in note for note in wrong.notes)


def test_outliers_do_not_move_a_robust_fit(log: Write, fitted: Callable[..., Fitted]) -> None:
    def spoiled(columns: dict[str, Any]) -> dict[str, Any]:
        changed = dict(columns)
        for name, by in (("motor.i", 60.0), ("motor.omega_b", -4.0)):
            changed[name] = columns[name].copy()
            changed[name][::10] += by
        return changed

    path = log(spoiled)
    off = [abs(fitted(path, loss=loss).values["motor.R"] / TRUE["motor.R"] - 1.0) for loss in ("linear", "cauchy")]
    assert off[1] < 0.02 and off[1] < 0.3 * off[0]


def test_parameters_that_cannot_be_told_apart_are_named(
    log: Write, fitted: Callable[..., Fitted], tmp_path: Path
) -> None:
    """Of the start of the speed and what follows it: R and its part in V_in alone decide a stall, K_t and gears one."""
    found = fitted(log(), vary=("motor.J_b=0.3:1.2", "motor.J_m=1e-5:1e-3", "motor.R=0.04:0.2"), out=tmp_path / "out")
    with pytest.raises(RunError, match=r"motor\.J_b and motor\.J_m cannot be told apart"):
        found.require_identified()
    assert (tmp_path / "out/fit.json").exists()


def test_what_the_data_do_not_decide_is_said(log: Write, fitted: Callable[..., Fitted]) -> None:
    """The inductance has died out after a millisecond."""
    with pytest.raises(RunError, match=r"motor\.L_a is not decided by the data"):
        fitted(log(), vary=("motor.L_a=4e-5:6e-5", "motor.R=0.04:0.2")).require_identified()


def test_a_parameter_on_a_bound_is_told(log: Write, fitted: Callable[..., Fitted]) -> None:
    said: list[str] = []
    found = fitted(log(), vary=("motor.R=0.1:0.2", "motor.B_m=2e-4:3e-3"), tell=said.append)
    assert found.estimates[0].at_bound and any("lies on a bound" in note for note in found.notes)
    assert any("outside of 0.1 to 0.2; the fit begins at 0.15" in line for line in said)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"vary": ()}, "--vary says what is fitted"),
        ({"vary": ("motor.R=0.1",)}, "write motor.R=low:high"),
        ({"vary": ("motor.R=0.2:0.1",)}, "an empty range"),
        ({"vary": ("motor.RR=0.1:0.2",)}, "RR"),
        ({"vary": ("motor.gear_stages=1:3",)}, "one real number is fitted"),
        ({"match": ()}, "--match says which signals were measured"),
        ({"match": ("motor.current",)}, "no column 'motor.current'"),
        ({"match": ("motor.i,motor.i",)}, "it stands there twice"),
        ({"match": ("motor.speed=motor.i",)}, "motor has no variable 'speed'"),
        ({"match": ("pump.i=motor.i",)}, "no component 'pump'"),
        ({"loss": "squared"}, "take one of linear"),
        ({"sigma": {"motor.T": 1.0}}, "not among the signals of --match"),
        ({"sigma": {"motor.i": 0.0}}, "is above 0"),
        ({"stop": "15 ms"}, "2 rows of column 'motor.i' within the run"),
        ({"values": {"motor.R": 0.1, "motor.Q": 1.0}}, "Q"),
    ],
)  # fmt: skip
def test_bad_requests_are_one_clear_error(
    options: dict[str, Any], message: str, log: Write, fitted: Callable[..., Fitted], tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=message):
        fitted(log(), out=tmp_path / "out", **options)
    assert not (tmp_path / "out/fit.json").exists()


def test_a_parameter_without_effect_is_named(log: Write, fitted: Callable[..., Fitted]) -> None:
    with pytest.raises(InputError, match=r"motor.gear_speed_eps: it has no effect on what is matched"):
        fitted(log(), vary=("motor.gear_speed_eps=0.5:2", "motor.R=0.04:0.2"))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda c: {**c, "motor.i": ["x"] * len(c["time"])}, "line 2: motor.i = 'x' is not a number"),
        (lambda c: {**c, "motor.i": ["inf"] * len(c["time"])}, "is not finite"),
        (lambda c: {**c, "motor.i": ["nan"] * len(c["time"])}, "0 rows of column 'motor.i'"),
        (lambda c: {"t": c["time"], "motor.i": c["motor.i"]}, "there is no column 'time'"),
        (lambda c: {**c, "time": [*np.roll(c["time"][:-1], 3).tolist(), 1.0]}, "do not rise"),
        (lambda c: {**c, "time": c["time"][::-1]}, "do not rise"),
        (lambda c: {**c, "time": c["time"] - 5.0}, "the data end at -4 s, where the run begins"),
        (lambda c: {"time": c["time"], "motor.i [kg]": c["motor.i"], "motor.omega_b": c["motor.omega_b"]}, "kg"),
        (lambda c: {**c, "motor.V_in": ["?"] * len(c["time"])}, "V_in = '\\?' is not a number"),
        (lambda c: {**c, "motor.T_brush [m]": c["time"]}, "motor.T_brush"),
    ],
)  # fmt: skip
def test_bad_data_are_one_clear_error(
    change: Callable[[dict[str, Any]], dict[str, Any]], message: str, log: Write, fitted: Callable[..., Fitted]
) -> None:
    with pytest.raises(InputError, match=message):
        fitted(log(change))


def test_a_missing_file_is_named(fitted: Callable[..., Fitted], tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no such file"):
        fitted(tmp_path / "none.csv")


FILE = """
system = "{system}"
match = ["motor.i", "motor.omega_b"]
[vary]
"motor.R" = "0.04:0.2"
"motor.B_m" = "2e-4:3e-3:log"
[[experiments]]
data = "log.csv"
[[experiments]]
data = "half.csv"
stop_time = "0.5 s"
set = {{ "motor.J_b" = 0.6 }}
"""


def test_several_experiments_stand_in_a_file(
    log: Write, bench: tuple[Path, Path, dict[str, np.ndarray]], tmp_path: Path
) -> None:
    log(), log(name="half.csv")
    path = tmp_path / "motor_fit.toml"
    path.write_text(FILE.format(system=bench[0].as_posix()), encoding="utf-8")
    assert is_fit_file(str(path)) and not is_fit_file(str(bench[0]))
    name, recipes, options = fit_file(path, Options(fmus=bench[1]))
    found = fit(name, recipes, options)
    assert [one.rows for one in found.signals] == [101 + 51] * 2
    assert found.values == pytest.approx(TRUE, rel=0.05)


def test_an_experiment_does_not_set_what_is_fitted(log: Write, fitted: Callable[..., Fitted]) -> None:
    with pytest.raises(InputError, match="sets it; leave one out"):
        fitted(Recipe(log(), {"motor.R": 0.1}))
