"""Checks against references that nobody here wrote, and orders of convergence: computed now, or by a named test."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from ..plan.plan import make_plan
from ..results.summary.summary import summarize
from ..results.tables import require_complete
from ..run.simulation import simulate
from .lab import Case, Lab
from .theory import elastica
from .theory.beam import centrifugal_frequencies
from .theory.references import rotating_cantilever, thruster

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Table = tuple[list[str], list[list[str]]]  # heading and rows


@dataclass(frozen=True)
class SuiteCheck:
    """A check of the test suite; pytest prints the measured numbers at its end."""

    subject: str
    reference: str
    file: str
    test: str
    behaviour: str = ""  # the file of a component that defines the test, which `file` runs

    @property
    def command(self) -> str:
        component, name = self.behaviour.partition("/")[0], self.test.removeprefix("test_")
        return f"python -m pytest {self.file} -k {f'{component}-{name}' if component else self.test}"

    @property
    def definition(self) -> str:
        """The file with the test's text."""
        return f"components/{self.behaviour}" if self.behaviour else self.file


_BRUSH, _BEHAVIOUR = "tests/components/filament_brush/test_filament_brush", "tests/components/test_behaviour.py"
SUITE = (
    SuiteCheck("Rotating cantilever, brush kernel", "Wright et al. 1982", f"{_BRUSH}_modes.py",
               "test_rotating_frequencies_match_the_reference_table"),
    SuiteCheck("Bending against the elastica, brush kernel", "Mattiasson 1981", f"{_BRUSH}_modes.py",
               "test_large_deflection_stays_close_to_the_elastica"),
    SuiteCheck("Beam statics of a pressed filament", "Euler-Bernoulli", f"{_BRUSH}_modes.py",
               "test_a_pressed_filament_at_rest_obeys_beam_statics"),
    SuiteCheck("A filament pushed slowly over the hull", "exact rod, collocation", f"{_BRUSH}_exact_rod.py",
               "test_mean_force_over_the_arc_is_that_of_the_resting_rod"),
    SuiteCheck("The paper's case, filament by filament", "exact rod, Lagrange", f"{_BRUSH}_exact_rod.py",
               "test_mean_forces_and_torque_of_the_paper_s_case_are_those_of_the_moving_rod"),
    SuiteCheck("Vehicle step response, Wu 2018", "Fossen's published library", _BEHAVIOUR,
               "test_step_response_is_that_of_wu_2018", "rov_vehicle/behaviour/motion.py"),
    SuiteCheck("Vehicle step response, Benzon 2022", "Fossen's published library", _BEHAVIOUR,
               "test_step_response_is_that_of_benzon_2022", "rov_vehicle/behaviour/motion.py"),
    SuiteCheck("Allocation matrix", "published matrix", "tests/components/rov_vehicle/test_rov_vehicle.py",
               "test_allocation_matrix_equals_the_printed_one_up_to_column_signs"),
    SuiteCheck("Thrust curve, 12 and 16 V", "T200 thrust table", "tests/components/rov_vehicle/test_rov_vehicle.py",
               "test_thrust_curve_follows_the_published_table"),
    SuiteCheck("Motor step response", "matrix exponential", _BEHAVIOUR,
               "test_step_response_is_the_matrix_exponential", "dc_motor/behaviour.py"),
    SuiteCheck("Co-simulation benchmark: quarter car, several rates", "published digits",
               "tests/orchestrator/plan/algorithms/test_quarter_car.py",
               "test_several_rates_with_hold_give_the_published_error"),
    SuiteCheck("Order of the coupling", "quarter car", "tests/orchestrator/plan/algorithms/test_quarter_car.py",
               "test_linear_and_mean_are_second_order_with_and_without_feedthrough"),
    SuiteCheck("Co-simulation against one continuous solution", "monolithic integration",
               "tests/system/test_monolithic.py", "test_means_agree_within_half_a_percent"),
    SuiteCheck("Micro-steps are of fourth order", "refinement", f"{_BRUSH}_integration.py",
               "test_micro_steps_are_of_fourth_order"),
    SuiteCheck("Vehicle integration is of fourth order", "refinement", _BEHAVIOUR,
               "test_errors_fall_with_the_fourth_power_of_the_internal_step", "rov_vehicle/behaviour/motion.py"),
    SuiteCheck("Motor integration is of fourth order", "refinement", _BEHAVIOUR,
               "test_internal_steps_are_of_fourth_order", "dc_motor/behaviour.py"),
    SuiteCheck("Energy of the brush, filament by filament", "first law", _BEHAVIOUR,
               "test_energy_is_accounted_for", "filament_brush/behaviour/energy.py"),
    SuiteCheck("Energy of the motor", "first law", _BEHAVIOUR,
               "test_energy_is_accounted_for", "dc_motor/behaviour_energy.py"),
    SuiteCheck("Energy of the vehicle", "first law", _BEHAVIOUR,
               "test_energy_is_accounted_for", "rov_vehicle/behaviour/motion.py"),
    SuiteCheck("Angular momentum of the vehicle", "Newton and Euler", _BEHAVIOUR,
               "test_angular_impulses_account_for_the_angular_momentum", "rov_vehicle/behaviour/spin.py"),
    SuiteCheck("A spinning tool on a free body", "closed form", _BEHAVIOUR,
               "test_spinning_tool_makes_the_vehicle_nutate", "rov_vehicle/behaviour/spin.py"),
    SuiteCheck("Angular momentum of the whole system", "Newton and Euler", "tests/system/test_angular_momentum.py",
               "test_angular_momentum_about_three_axes_is_kept_while_the_vehicle_tumbles"),
    SuiteCheck("Energy made by the coupling", "first law", "tests/system/test_nominal.py",
               "test_coupling_makes_and_loses_hardly_any_energy"),
)  # fmt: skip


def elastica_table(bent: elastica.Bending) -> Table:
    """At which tip deflection over the length the beams leave the exact one by 1, 5 and 10 %."""
    rows = [
        ("deflection at equal load, linear and foreshortened beam", bent.deflection_error),
        ("tip position at equal deflection over the deflection, linear beam", bent.linear_tip_error),
        ("tip position at equal deflection over the deflection, foreshortened beam", bent.foreshortened_tip_error),
        ("foreshortening at equal deflection, foreshortened beam", bent.shortening_error),
    ]
    heading = ["error of", *(f"{100 * limit:g} % at" for limit in elastica.LIMITS)]
    found = [[name, *(text(elastica.leaves_at(e, bent.model_w, x)) for x in elastica.LIMITS)] for name, e in rows]
    return heading, found


def text(value: float) -> str:
    return f"{value:.3f}" if np.isfinite(value) else "not in the range"


def elastica_figure(bent: elastica.Bending, reached: float) -> Figure:
    """Errors over the deflection; `reached` is the largest deflection of the nominal run."""
    from ..results.pictures.canvas import new_figure

    figure, (axis,) = new_figure("Bending model against the exact elastica under a tip load")
    figure.set_size_inches(8.0, 4.4)
    for label, error in (
        ("deflection at equal load", bent.deflection_error),
        ("tip position, linear beam", bent.linear_tip_error),
        ("tip position, foreshortened beam", bent.foreshortened_tip_error),
    ):
        axis.plot(bent.model_w, 100.0 * np.abs(error), label=label)
    for limit in elastica.LIMITS:
        axis.axhline(100.0 * limit, color="black", linewidth=0.6, linestyle=":")
    axis.axvline(reached, color="tab:red", linestyle="--", linewidth=1.0, label="largest in the nominal run")
    axis.set_xlim(0.0, 0.6)
    axis.set_ylim(0.0, 20.0)
    axis.set_xlabel("tip deflection over the length [1]")
    axis.set_ylabel("error [%]")
    axis.legend(fontsize="small")
    return figure


def cantilever_table(lam: np.ndarray) -> Table:
    """Frequencies of a cantilever turning about its root, out of plane, from the brush FMU's eigenvalues."""
    rows = []
    for speed, *published in rotating_cantilever():
        seen = centrifugal_frequencies(lam, lam**2, speed, 0.0, in_plane=False)[:3]
        errors = [100.0 * (a / b - 1.0) for a, b in zip(seen, published, strict=True)]
        rows.append([f"{speed:g}", *(f"{a:.4f} / {b:.4f}" for a, b in zip(seen, published, strict=True)),
                     f"{max(errors, key=abs):+.3f} %"])  # fmt: skip
    return ["Omega [1]", *(f"omega_{r} [1]" for r in (1, 2, 3)), "largest difference"], rows


def thrust_table(case: Case) -> Table:
    """The vehicle FMU's thrust curve beside the table of the thruster at 12 V."""
    forward, reverse = case.parameter("vehicle.k_T_forward"), case.parameter("vehicle.k_T_reverse")
    rows = []
    for u, published in zip(*thruster(12), strict=True):
        seen = (forward if u > 0 else reverse) * u * abs(u)
        rows.append([f"{u:+.2f}", f"{published:.2f}", f"{seen:.2f}", f"{seen - published:+.2f}"])
    return ["u [1]", "table [N]", "k_T sgn(u) u^2 [N]", "difference [N]"], rows


def convergence_table(lab: Lab) -> Table:
    """Mean forces on the test stand over modes, tolerance and communication step, and what they change."""
    base = lab.stand()
    rows = []
    variations: list[tuple[str, Mapping[str, object]]] = [
        *((f"{m} mode{'s' if m > 1 else ''}", {"brush.N_m": m}) for m in (1, 2, 3, 4, 6)),
        *((f"tolerance {t:g}", {"brush.tolerance": t}) for t in (1e-4, 1e-5, 1e-7)),
    ]
    for what, values in variations:
        case = lab.stand(values) if values != {"brush.N_m": 3} else base
        rows.append(convergence_row(what, case.summary, base.summary))
    for factor in (Fraction(2), Fraction(1, 2)):
        run = require_complete(simulate(make_plan(base.run.plan.system.with_periods(factor))))
        rows.append(convergence_row(f"every period times {factor}", summarize(run), base.summary))
    return ["variation", "F_z [N]", "F_y [N]", "T_brush [N.m]", "largest change"], rows


def convergence_row(what: str, seen: object, base: object) -> list[str]:
    keys = ("F_z_mean", "F_x_mean", "T_brush_mean")
    values, usual = ([float(x[key]) for key in keys] for x in (seen, base))  # type: ignore[index]
    change = max(abs(a / b - 1.0) for a, b in zip(values, usual, strict=True))
    return [what, *(f"{value:.3f}" for value in values), f"{100 * change:.4f} %"]
