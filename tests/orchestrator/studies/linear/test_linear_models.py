"""Linear models of running systems against what is known of them, and what cannot be linearised."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from helpers import Measured
from linear_cases import Plant, gain, loop, plant, system, turning
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.mock import mock_fmu
from rovbrush.orchestrator.studies.linear.linearise import linearise
from rovbrush.orchestrator.studies.linear.margins.margins import margins, verified
from rovbrush.orchestrator.studies.linear.options import Options
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.connection import Connection
from rovbrush.orchestrator.system.model import System
from scipy.linalg import expm

START = Options(at=["0 s"])
T = 0.01  # s
SIZES = {"V_in": 1.0, "T_brush": 1.0}  # the motor is linear


def poles(model_of: System, inputs: Sequence[str], outputs: Sequence[str], options: Options = START) -> np.ndarray:
    (model,) = linearise(model_of, inputs, outputs, options)
    return np.sort_complex(np.array([pole.z for pole in model.poles]))


STEP = 0.5e-3  # s


def motor_alone(fmus: Path) -> tuple[System, np.ndarray, np.ndarray, float]:
    """The motor at 12 V, its A of Eqs. 16 and 17 for (i, omega_m), what a torque on the brush does, and the gear."""
    system = assemble(str(fmus / "dc_motor.fmu"), {"V_in": 12.0}, "5 s", None, step=f"{STEP} s")
    fmu = system.components["dc_motor"].fmu
    p = {name: float(fmu.start(name)) for name in ("R", "L_a", "K_e", "K_t", "B_m", "J_m", "J_b", "gear_stages")}
    ratio = float(fmu.start("gear_ratio_per_stage")) ** p["gear_stages"]
    J = p["J_m"] + p["J_b"] / ratio**2
    A = np.array([[-p["R"] / p["L_a"], -p["K_e"] / p["L_a"]], [p["K_t"] / J, -p["B_m"] / J]])
    return system, A, np.array([0.0, 1.0 / (ratio * J)]), ratio


def held(A: np.ndarray, B: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The map of a step with the input held."""
    n = len(A)
    whole = expm(STEP * np.block([[A, B[:, None]], [np.zeros((1, n + 1))]]))
    return whole[:n, :n], whole[:n, n]


def test_the_motor_has_the_eigenvalues_of_its_equations(fmus: Path, measured: Measured) -> None:
    """Eqs. 16 and 17, voltage and torque held over 0.5 ms; its integration errs by 4e-7 of the electrical pole."""
    system, A, B, _ = motor_alone(fmus)
    (model,) = linearise(
        system, ["V_in", "T_brush"], ["i", "omega_b"], Options(at=["2 s"], length="0.5 s", sizes=SIZES)
    )
    wanted = np.sort_complex(np.linalg.eigvals(held(A, B)[0]))
    found = np.sort_complex(np.array([pole.z for pole in model.poles]))
    error = float(np.max(np.abs(found / wanted - 1.0)))
    measured("linear model of the motor: eigenvalues against Eqs. 16 and 17, relative", error, "1e-6")
    assert model.order == 2 and error < 1e-6


def test_the_motor_under_a_plant_has_the_eigenvalues_of_both(fmus: Path, measured: Measured) -> None:
    """A brake that follows the speed with a lag of 50 ms, T' = -20 T - 30 omega_b: what the speed of this step says is
    in its own step (Gauss-Seidel)."""
    alone, A, B, ratio = motor_alone(fmus)
    both = system({"p": (plant([[-20.0]], [-30.0], [1.0]), f"{STEP}")}, [], "5")
    motor = replace(alone.components["dc_motor"], name="motor")
    wires = (Connection(("motor", "omega_b"), ("p", "u")), Connection(("p", "y"), ("motor", "T_brush")))
    both = replace(both, components={"motor": motor, **both.components}, order=("motor", "p"), connections=wires)
    options = Options(at=["2 s"], length="0.5 s", sizes={"motor.V_in": 1.0})
    (model,) = linearise(both, ["motor.V_in"], ["motor.i", "motor.omega_b", "p.y"], options)
    Ad, Bd = held(A, B)
    ap, bp = held(np.array([[-20.0]]), np.array([-30.0]))
    speed = np.array([0.0, 1.0 / ratio])
    whole = np.block([[Ad, Bd[:, None]], [bp[0] * speed @ Ad, ap + bp[0] * speed @ Bd]])
    wanted, found = (np.sort_complex(z) for z in (np.linalg.eigvals(whole), np.array([pole.z for pole in model.poles])))
    error = float(np.max(np.abs(found / wanted - 1.0)))
    measured("linear model of motor and analytic plant: eigenvalues, relative", error, "1e-6")
    assert model.order == 3 and error < 1e-6


def test_sampled_double_integrator_has_a_double_pole_at_one() -> None:
    alone = system({"p": (plant([[0.0, 1.0], [0.0, 0.0]], [0.0, 1.0], [1.0, 0.0]), "0.01")})
    found = poles(alone, ["u"], ["y"], replace(START, length="5 s"))
    assert np.allclose(found, 1.0, atol=1e-6)  # the root of what rounding leaves of a double pole


def test_loop_of_integrator_and_gain_has_its_closed_pole() -> None:
    assert np.allclose(poles(loop(3.0), ["g.w"], ["p.y"]), 1.0 - 3.0 * T, atol=1e-9)


def test_two_rates_are_one_map_over_the_slower() -> None:
    """The fast one is a lag exp(-10 t) that is held over 10 ms of the slow gain: the same as one of 10 ms."""
    lag = plant([[-10.0]], [10.0], [1.0])
    both = system({"p": (lag, "0.002"), "g": (gain(-3.0), "0.01")}, ["p.y -> g.u", "g.y -> p.u"])
    both = replace(both, connections=tuple(replace(c, transfer="hold") for c in both.connections))
    a = np.exp(-10.0 * T)
    assert np.allclose(poles(both, ["g.w"], ["p.y"]), a - 3.0 * (1.0 - a), atol=1e-9)


def test_a_periodic_point_is_averaged_over_its_turns() -> None:
    """What a turn does to the response is as often more as less: the mean is that of the plant that does not turn."""
    alone = system({"p": (turning(), "0.01")}, stop="60")
    options = replace(START, period_of="p.theta", starts=40, length="2 s")
    (model,) = linearise(alone, ["u"], ["y"], options)
    left = np.exp(-T)
    assert model.notes["starts"] == 40 and np.isclose(model.notes["period"], 40 * T)
    assert model.order == 1 and np.allclose([pole.z for pole in model.poles], left, atol=1e-9)
    assert np.allclose(model.C @ model.B, 1.0 - left, atol=1e-9)
    (once,) = linearise(alone, ["u"], ["y"], replace(options, period_of="", starts=1))
    assert once.order > 1  # from one instant the turning is in the response


def test_a_loop_that_is_faster_than_the_samples_is_told() -> None:
    """A fast loop beside a slow component: the schedule repeats, and is sampled, every 10 ms."""
    parts = {"p": (plant([[-10.0]], [10.0], [1.0]), "0.002"), "g": (gain(-3.0), "0.002"), "s": (gain(1.0), "0.01")}
    both = system(parts, ["p.y -> g.u", "g.y -> p.u", "p.y -> s.u"])
    (model,) = linearise(both, ["p.y -> g.u", "p.y -> s.u"], ["s.y"], replace(START, length="1 s"))
    assert model.dt == T and model.notes["faster"] == {"p.y -> g.u": 0.002}


def test_unstable_and_lightly_damped_plants_have_their_poles() -> None:
    for A, length in (([[2.0, 0.0], [1.0, -1.0]], "3 s"), ([[0.0, 1.0], [-400.0, -0.04]], "5 s")):
        alone = system({"p": (plant(A, [1.0, 0.5], [1.0, 1.0]), "0.01")})
        wanted = np.sort_complex(np.linalg.eigvals(expm(np.array(A) * T)))
        assert np.allclose(poles(alone, ["u"], ["y"], replace(START, length=length)), wanted, atol=1e-7)


def test_feedthrough_answers_at_once_also_through_connections() -> None:
    (model,) = linearise(system({"g": (gain(2.0), "0.01")}), ["u", "w"], ["y"], START)
    assert model.order == 0 and np.allclose(model.D, [[2.0, 1.0]])
    chain = system({"a": (gain(2.0), "0.01"), "b": (gain(5.0), "0.01")}, ["a.y -> b.u"])
    (model,) = linearise(chain, ["a.u", "a.y -> b.u"], ["b.y"], START)
    assert np.allclose(model.D, [[10.0, 5.0]])


@pytest.mark.parametrize("late", [0, 4])
def test_margins_of_an_integrator_are_the_known_ones_wherever_its_loop_is_broken(late: int) -> None:
    """k T/(z - 1) and `late - 1` samples of delay: a late part takes what its source has at the end of the step."""
    places = ["p.y -> d.u", "d.y -> g.u", "g.y -> p.u"] if late else ["p.y -> g.u", "g.y -> p.u"]
    for place in places:
        (found,) = margins(loop(3.0, late), [place], START)
        (locus,) = found.loops
        z = np.exp(1j * locus.omega * T)
        assert np.allclose(locus.L, 3.0 * T / (z - 1.0) * z ** -max(late - 1, 0), rtol=1e-6)
        omega = 2.0 / T * np.arcsin(3.0 * T / 2.0)  # where |L| is 1
        margin = np.pi / 2.0 - omega * T / 2.0 - omega * T * max(late - 1, 0)
        assert locus.phase_margin == pytest.approx(margin, abs=1e-4)
        assert locus.delay_margin == pytest.approx(margin / omega, rel=1e-4)


@pytest.mark.parametrize("place", ["p.y -> g.u", "g.y -> p.u"])
def test_delay_margin_of_an_integrator_is_the_one_at_which_runs_begin_to_grow(place: str, measured: Measured) -> None:
    """Trials end 2 % apart; a delay between two samples is a straight line between them, 0.3 % of a gain."""
    k = 15.0
    (each,) = verified(loop(k), margins(loop(k), [place], START))
    assert each.in_time is not None
    omega = 2.0 / T * np.arcsin(k * T / 2.0)
    known = (np.pi / 2.0 - omega * T / 2.0) / omega
    measured(f"delay margin on runs, integrator broken at {place}", each.in_time.delay / known - 1, "0.02")
    assert each.in_time.dies_out < each.in_time.delay < each.in_time.grows
    assert abs(each.in_time.delay / known - 1.0) < 0.02 and abs(each.in_time.difference) < 0.02


class Rounded(Plant):
    """An integrator whose output is told in steps."""

    A, STEP = ((-2.0,),), 0.005

    def get(self, names: Iterable[str]) -> list[float]:
        found = super().get(names)
        return [self.STEP * np.floor(v / self.STEP + 0.5) if n == "y" else v for n, v in zip(names, found, strict=True)]


def test_pulses_that_a_rounded_reading_hides_are_made_larger_or_are_an_error() -> None:
    alone = system({"p": (mock_fmu("rounded", Rounded, ["u"], ["y"]), "0.01")}).with_values({"p.u": 0.049}, "test")
    options = Options(at=["5 s"], length="2 s", residual=9.0, order=1)
    (model,) = linearise(alone, ["u"], ["y"], options)
    assert model.notes["sizes"][0] > 5.0 and model.notes["even"] < 0.5
    with pytest.raises(InputError, match=r"are hidden: .* add more by --size"):
        linearise(alone, ["u"], ["y"], replace(options, sizes={"u": 0.25}))


BAD = {
    "no point": (
        ["p.y -> g.u"],
        ["p.y"],
        {"at": ["11 s"]},
        "outside of the run, which goes from 0 s to 10 s",
    ),
    "between": (["g.w"], ["p.y"], {"at": ["0.015 s"]}, "take 10 ms or 20 ms"),
    "driven": (["g.u"], ["p.y"], {}, 'g.u is driven by the connection p.y -> g.u; write "p.y -> g.u"'),
    "unknown input": (["g.v"], ["p.y"], {}, "g has no variable 'v'"),
    "unknown component": (["q.v"], ["p.y"], {}, "no component 'q'"),
    "unknown output": (["g.w"], ["p.z"], {}, "--outputs p.z: no variable is called so"),
    "output as input": (["p.y"], ["p.y"], {}, "it is of causality output"),
    "no connection": (["g.y -> g.u"], ["p.y"], {}, "there is no such connection; there is p.y -> g.u"),
    "size": (["g.w"], ["p.y"], {"sizes": {"g.x": 1.0}}, "--size g.x: it is no input of the linear model"),
    "method": (["g.w"], ["p.y"], {"method": "state"}, "did you mean 'states'"),
    "sample": (["g.w"], ["p.y"], {"sample": "15 ms"}, "it must be a multiple of 10 ms"),
    "period": (["g.w"], ["p.y"], {"period_of": "p.y"}, "it does not turn by 2 pi"),
    "states": (["g.w"], ["p.y"], {"method": "states"}, "does not list its states"),
    "nothing": ([], ["p.y"], {}, "--inputs: name free inputs, or connections"),
}


@pytest.mark.parametrize("case", BAD)
def test_what_cannot_be_linearised_is_one_clear_error(case: str) -> None:
    inputs, outputs, options, words = BAD[case]
    with pytest.raises(InputError) as error:
        linearise(loop(3.0), inputs, outputs, replace(START, **options))  # type: ignore[arg-type]
    assert words in str(error.value)


def test_an_operating_point_that_is_none_shows_its_residuals() -> None:
    lag = plant([[-1.0]], [1.0], [1.0])
    moving = system({"p": (lag, "0.01")})
    moving = moving.with_values({"p.u": 1.0}, "test")
    with pytest.raises(InputError, match=r"t = 0\.5 s is no operating point: .* residuals: p\.y 0\.\d+ \("):
        linearise(moving, ["u"], ["y"], Options(at=["0.5 s"], length="2 s"))
    assert np.allclose(poles(moving, ["u"], ["y"], Options(at=["0.5 s"], length="2 s", residual=9.0)), np.exp(-T))
    late = poles(moving, ["u"], ["y"], Options(at=["9 s"], length="2 s"))
    assert np.allclose(late, np.exp(-T))


def test_fmus_that_cannot_save_their_states_are_named() -> None:
    fmu = mock_fmu("stiff", inputs=["u"], outputs=["y"])
    assert fmu.description.coSimulation is not None
    fmu.description.coSimulation.canGetAndSetFMUstate = False
    with pytest.raises(InputError, match=r"and s \(stiff\.mock\) cannot save its state"):
        linearise(system({"s": (fmu, "0.01"), "g": (gain(1.0), "0.01")}), ["g.w"], ["g.y"], START)


def test_a_loop_that_is_broken_where_there_is_none_is_an_error() -> None:
    chain = system({"a": (gain(2.0), "0.01"), "b": (gain(5.0), "0.01")}, ["a.y -> b.u"])
    for place, words in (
        ("a.y -> b.u", "no loop goes through it"), ("a.y -> b.w", "there is no such connection"),
        ("a.y", "write a connection"), ("a.z -> b.u", "has no variable 'z'"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=words):
            margins(chain, [place], START)
