"""The nominal system as one continuous system: the same kernels, no communication steps.

Motor, filaments, vehicle and thrust lags are one state that scipy integrates to a tight tolerance; signals between
them are exchanged in every evaluation of the right-hand side. The controller takes its samples between two
integrations, at multiples of its period: a sample sees the state of its instant and acts from that instant on.

State: 0 i, 1 omega_m, 2 theta_b, 3 J_x, 4 J_z, 5 J_T (time integrals of F_x, F_z, T_brush), then eta and eta_dot of
every filament, then x (24) and thrust_state (8) of the vehicle. The water is at rest: x holds nu and nu_r alike.
"""

from __future__ import annotations

import inspect
from collections import namedtuple
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numba import njit
from rovbrush.components.declare.layout import cell_count, cells_of
from rovbrush.components.filament_brush.records import Constants, Stage
from rovbrush.components.python.component import component_class
from rovbrush.components.python.kernels import argument_names, compiled
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.model import System
from scipy.integrate import solve_ivp

TO_CONTROLLER = ("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r")
ETA = 6  # first place of eta in the state
MOTION = 24  # numbers of the vehicle's motion
ROWS_PER_SAMPLE = 20  # of the solution, per period of the controller


class Part:
    """A component's kernel with the values that its FMU has in a system, arguments bound by name."""

    def __init__(self, component: Component) -> None:
        declared = component_class(component.fmu.path.stem)
        self.functions = compiled(declared.kernel)
        self.kernel = declared.kernel
        numbers = {name: v.start for name, v in component.fmu.variables.items()}
        numbers |= component.parameters | component.inputs
        self.values: dict[str, Any] = {"t": 0.0, "h": 0.0}
        kinds: dict[str, Callable[[Any], Any]] = {"Real": float, "Integer": int, "Boolean": _truth}
        for v in declared.variables():
            if v.causality in ("parameter", "input"):
                elements = [kinds[v.kind](numbers[name] or 0) for name in v.element_names]
                self.values[v.name] = np.array(elements) if v.size else elements[0]
        parameters = declared.parameters(**{
            name: self.values[name] for name in declared.parameters.__dataclass_fields__
        })  # fmt: skip
        self.values |= {a.name: np.zeros(a.shape_for(parameters)) for a in declared.arrays}
        self.outputs = [name for v in declared.outputs for name in v.element_names]
        self.values["y"] = np.zeros(len(self.outputs))
        for stage in ("setup", "initialize", "outputs"):
            if hasattr(self.kernel, stage):
                self.call(stage)

    def call(self, name: str, **changes: Any) -> None:
        """Call an entry point of the kernel."""
        self.values |= changes
        getattr(self.functions, name)(*self.given(name))

    def given(self, name: str, behind: int = 0) -> tuple[Any, ...]:
        """The arguments of a function of the kernel, behind the first few."""
        return tuple(self.values[argument] for argument in argument_names(self.kernel, name)[behind:])

    def bound(self, name: str, *free: str, **arrays: str) -> Any:
        """A function of the kernel, lowered and compiled, of these arguments; all others have the values of the part.

        `arrays`: what arguments that are arrays of another name are called in the part. Constants come as `c`.
        """
        function = getattr(self.functions, name)
        places = cells_of(Constants)
        known: dict[str, Any] = {"function": function}
        given = []
        for argument in inspect.signature(function.py_func).parameters:
            kind, _, key = argument.partition("_")
            if argument in free:
                given.append(argument)
            elif kind == "c" and key:
                given.append(f"c[{places[key]}]")
            else:
                known[f"_{argument}"] = self.values[arrays.get(argument, key if kind in ("p", "u") else argument)]
                given.append(f"_{argument}")
        exec(f"def bound({', '.join(free)}):\n    return function({', '.join(given)})", known)
        return njit(error_model="numpy")(known["bound"])

    def __getitem__(self, output: str) -> float:
        return float(self.values["y"][self.outputs.index(output)])

    def constants(self) -> Any:
        """All values as one named tuple, which Numba takes as constants."""
        return namedtuple("Values", self.values)(**self.values)  # type: ignore[misc]


def _truth(text: Any) -> bool:
    return str(text).lower() in ("true", "1")


def right_hand_side(motor: Part, brush: Part, vehicle: Part) -> Callable[..., np.ndarray]:
    """The rates of the whole state as a compiled function of t, state, thruster commands and motor voltage."""
    b, v = brush.constants(), vehicle.constants()
    motor_rates, motor_parameters = motor.functions.rates, motor.given("rates", behind=6)
    N_g = motor.functions.gear_ratio(*motor.given("gear_ratio"))
    constants = brush.bound("constants", "c", "k_K", "k_load", "k_shapes", "u_omega_b", m="modes")
    evaluate = brush.bound("evaluate", "f", "at_sin_psi", "at_cos_psi", "at_h_plane", "u_omega_b", "c", "k_K", "k_load",
                           "k_shapes", m="modes")  # fmt: skip
    size, shape = cell_count(Constants), b.now.shape
    (F_f, F_n, moment), columns = (cells_of(Stage)[name] for name in ("F_f", "F_n", "moment")), shape[1]
    vehicle_rates, tool_wrench, thruster_wrench, thrust_of = (
        getattr(vehicle.functions, name) for name in ("rates", "tool_wrench", "thruster_wrench", "thrust_of")
    )
    of_thrust = vehicle.given("thrust_of", behind=2)
    n, N_m = b.n, b.N_m

    @njit(error_model="numpy")  # not cached: Numba would not notice that a kernel changed
    def rates(
        t: float,
        state: np.ndarray,
        u_thruster: np.ndarray,
        V_in: float,
        of_thrusters: Any,
        of_tool: Any,
        of_vehicle: Any,
    ) -> np.ndarray:
        rate = np.zeros_like(state)
        omega_b = state[1] / N_g

        # brush: every filament in turn
        K, load, shapes, c, stage = np.zeros((6, 6)), np.zeros(6), np.zeros((6, 6)), np.zeros(size), np.zeros(shape)
        constants(c, K, load, shapes, omega_b)
        F_x, F_z, T_brush = 0.0, 0.0, 0.0
        h_plane = b.R_brush - (b.delta + b.delta_dot * t)
        for filament in range(n):
            psi = state[2] + 2.0 * np.pi * filament / n - b.alpha
            eta = ETA + filament * N_m
            eta_dot = eta + n * N_m
            for r in range(N_m):
                stage[0, r], stage[1, r] = state[eta + r], state[eta_dot + r]
            evaluate(stage, np.sin(psi), np.cos(psi), h_plane, omega_b, c, K, load, shapes)
            for r in range(N_m):
                rate[eta + r], rate[eta_dot + r] = stage[1, r], stage[2, r]
            F_x -= stage[F_f // columns, F_f % columns]
            F_z -= stage[F_n // columns, F_n % columns]
            T_brush += stage[moment // columns, moment % columns]
        rate[2], rate[3], rate[4], rate[5] = omega_b, F_x, F_z, T_brush

        # motor
        motor_rate = motor_rates(state[0], state[1], False, N_g, V_in, T_brush, *motor_parameters)
        rate[0], rate[1] = motor_rate[0], motor_rate[1]

        # vehicle, of which the nominal system says as the paper does that its housing takes T_brush
        x = ETA + 2 * n * N_m
        thrust_state = state[x + MOTION :]
        thruster_wrench(1.0, thrust_state, *of_thrusters)
        tool = (F_x, v.F_y, F_z, v.M_x, T_brush, v.M_z)
        tool_wrench(*tool, *of_tool)
        vehicle_rates(rate[x : x + MOTION], state[x : x + MOTION], *tool, *of_vehicle)
        for j in range(8):
            steady = thrust_of(u_thruster[j], v.V_thruster, *of_thrust)
            rate[x + MOTION + j] = (steady - thrust_state[j]) / v.thruster_lag
        return rate

    # Arrays that the kernel writes to are arguments: Numba would take them for constants.
    arrays = vehicle.given("thruster_wrench", 2), vehicle.given("tool_wrench", 6), vehicle.given("rates", 8)

    def right_hand_side(t: float, state: np.ndarray, u_thruster: np.ndarray, V_in: float) -> np.ndarray:
        return np.asarray(rates(t, state, u_thruster, V_in, *arrays))

    return right_hand_side


@dataclass(frozen=True)
class Solution:
    """The state at every row of `time` [s]; `x` is the place of the vehicle's state in it."""

    time: np.ndarray  # (rows,)
    state: np.ndarray  # (rows, size of the state)
    x: int
    evaluations: int

    @property
    def position(self) -> np.ndarray:
        """Position of the vehicle [m], (rows, 3)."""
        return self.state[:, self.x : self.x + 3]

    @property
    def quat(self) -> np.ndarray:
        """Attitude of the vehicle as a unit quaternion, (rows, 4)."""
        quat = self.state[:, self.x + 3 : self.x + 7]
        return quat / np.linalg.norm(quat, axis=1, keepdims=True)

    def means(self, turns: int) -> dict[str, float]:
        """Time averages of F_z, F_x, T_brush and omega_b over the last whole turns of the brush."""
        theta_b, impulses = self.state[:, 2], self.state[:, 3:6]
        begin = float(np.interp(theta_b[-1] - 2.0 * np.pi * turns, theta_b, self.time))
        span = float(self.time[-1]) - begin
        F_x, F_z, T_brush = (float(J[-1] - np.interp(begin, self.time, J)) / span for J in impulses.T)
        return {"F_z": F_z, "F_x": F_x, "T_brush": T_brush, "omega_b": 2.0 * np.pi * turns / span}


class Monolithic:
    """The whole of a system with components motor, brush, vehicle and controller, connected as in nominal.toml."""

    def __init__(self, system: System) -> None:
        self.parts = {name: Part(component) for name, component in system.components.items()}
        motor, brush, vehicle = (self.parts[name] for name in ("motor", "brush", "vehicle"))
        assert motor.values["current_limit"] == 0.0, "the current limit has a state of its own, which is not modelled"
        assert not np.any(vehicle.values["v_c"]), "x holds nu and nu_r alike"
        self.rates = right_hand_side(motor, brush, vehicle)
        assert brush.values["eta"].shape[0] == brush.values["n"], "each filament is one rod here"
        assert brush.values["friction_law"] < 2, "LuGre has states of its own, which are not modelled"
        eta, eta_dot = (brush.values[name].ravel() for name in ("eta", "eta_dot"))
        self.x = ETA + eta.size + eta_dot.size
        self.state = np.concatenate([
            motor.values["state"][:2], brush.values["state"][:4], eta, eta_dot, vehicle.values["motion"],
            vehicle.values["thrust"],
        ])  # fmt: skip
        self.scale = np.ones(self.state.size)
        self.scale[ETA : ETA + eta.size] = 1e-3  # a bent filament: some mm at some m/s

    def solve(self, stop: float, rtol: float = 1e-8, method: str = "DOP853") -> Solution:
        """Integrate to `stop` [s], a multiple of the controller's period."""
        self.parts["controller"].call("initialize")
        T_s = self.parts["controller"].values["T_s"]
        state, step, tables, evaluations = self.state, 1e-6, [np.append(0.0, self.state)[None]], 0
        for sample in range(round(stop / T_s)):
            command, V_in = self.control(state, sample, T_s)
            grid = np.linspace(sample * T_s, (sample + 1) * T_s, ROWS_PER_SAMPLE + 1)
            part = solve_ivp(
                self.rates, (grid[0], grid[-1]), state, method, grid[1:], args=(command, V_in), rtol=rtol,
                atol=rtol * self.scale, first_step=step)  # fmt: skip
            assert part.success, part.message
            tables.append(np.column_stack([part.t, part.y.T]))
            state, step, evaluations = part.y[:, -1].copy(), 1e-5, evaluations + part.nfev
        table = np.concatenate(tables)
        return Solution(table[:, 0], table[:, 1:], self.x, evaluations)

    def control(self, state: np.ndarray, sample: int, T_s: float) -> tuple[np.ndarray, float]:
        """What the controller decides at a sample from the state at that instant: thruster commands and voltage."""
        vehicle, controller = self.parts["vehicle"], self.parts["controller"]
        vehicle.values["motion"][:], vehicle.values["thrust"][:] = (
            state[self.x : self.x + MOTION],
            state[self.x + MOTION :],
        )
        vehicle.call("outputs")
        measured = {name: vehicle[name] for name in TO_CONTROLLER}
        controller.call("step", t=sample * T_s, h=T_s, **measured)
        return np.array([controller[f"u_thruster[{j}]"] for j in range(1, 9)]), controller["V_in"]
