"""The nominal system as one continuous system: the same kernels, no communication steps.

Motor, filaments, vehicle and thrust lags are one state that scipy integrates to a tight tolerance; signals between
them are exchanged in every evaluation of the right-hand side. The controller takes its samples between two
integrations, at multiples of its period: a sample sees the state of its instant and acts from that instant on.

State: 0 i, 1 omega_m, 2 theta_b, 3 J_x, 4 J_z, 5 J_T (time integrals of F_x, F_z, T_brush), then eta and eta_dot of
every filament, then x (18) and thrust_state (8) of the vehicle, where x holds the velocity through the water.
"""

from __future__ import annotations

import importlib
import inspect
from collections import namedtuple
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numba import njit
from rovbrush.components.kernels import compiled
from rovbrush.components.slave import ComponentSlave
from rovbrush.orchestrator.system import Component, System
from scipy.integrate import solve_ivp

TO_CONTROLLER = ("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r")
POSE = 6  # first place behind the brush's and the motor's own six numbers


class Part:
    """A component's kernel with the values that its FMU has in a system, arguments bound by name."""

    def __init__(self, component: Component) -> None:
        module = importlib.import_module(f"rovbrush.components.{component.fmu.path.stem}.fmu")
        declared: type[ComponentSlave] = next(
            c for c in vars(module).values() if inspect.isclass(c) and c.__module__ == module.__name__
        )
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
        self.values |= {a.name: np.zeros(a.shape(parameters)) for a in declared.arrays}
        self.outputs = [name for v in declared.outputs for name in v.element_names]
        self.values["y"] = np.zeros(len(self.outputs))
        for stage in ("setup", "initialize", "outputs"):
            if hasattr(self.kernel, stage):
                self.call(stage)

    def call(self, name: str, **changes: Any) -> None:
        """Call an entry point of the kernel."""
        self.values |= changes
        arguments = inspect.signature(getattr(self.kernel, name)).parameters
        getattr(self.functions, name)(*[self.values[argument] for argument in arguments])

    def __getitem__(self, output: str) -> float:
        return float(self.values["y"][self.outputs.index(output)])

    def constants(self) -> Any:
        """All values as one named tuple, which Numba takes as constants."""
        return namedtuple("Values", self.values)(**self.values)  # type: ignore[misc]  # noqa: PYI024


def _truth(text: Any) -> bool:
    return str(text).lower() in ("true", "1")


def right_hand_side(motor: Part, brush: Part, vehicle: Part) -> Callable[..., np.ndarray]:
    """The rates of the whole state as a compiled function of t, state, thruster commands and motor voltage."""
    m, b, v = motor.constants(), brush.constants(), vehicle.constants()
    motor_rates, gear_ratio = motor.functions.rates, motor.functions.gear_ratio
    constants, free_acceleration, tip_force = (
        getattr(brush.functions, name) for name in ("constants", "free_acceleration", "tip_force")
    )
    vehicle_rates, tool_wrench, thruster_wrench, thrust_of = (
        getattr(vehicle.functions, name) for name in ("rates", "tool_wrench", "thruster_wrench", "thrust_of")
    )
    n, N_m = b.n, b.N_m
    lag = v.thruster_lag

    @njit(error_model="numpy")  # not cached: Numba would not notice a changed kernel
    def rates(t: float, state: np.ndarray, u_thruster: np.ndarray, V_in: float) -> np.ndarray:
        rate = np.zeros_like(state)
        N_g = gear_ratio(m.gear_ratio_per_stage, m.gear_stages)
        omega_b = state[1] / N_g

        # brush: every filament in turn
        K, c, work = np.zeros((7, 6)), np.zeros(17), np.zeros((15, 6))
        constants(
            omega_b, b.delta_dot, b.v_rov, b.friction_scale, b.L, b.d, b.rho, b.rho_w, b.C_a, N_m,
            b.bristles_per_filament, b.R_brush, b.alpha, b.k_c, b.c_c, b.Delta_s, b.mu_s, b.mu_c, b.v_0, b.k_v,
            b.v_eps, b.centrifugal, b.omega_r, b.modes, b.S, K, c)  # fmt: skip
        F_x, F_z, T_brush = 0.0, 0.0, 0.0
        h_plane = b.R_brush - (b.delta + b.delta_dot * t)
        for filament in range(n):
            psi = state[2] + 2.0 * np.pi * filament / n - b.alpha
            eta = 6 + filament * N_m
            eta_dot = eta + n * N_m
            for r in range(N_m):
                work[0, r], work[1, r] = state[eta + r], state[eta_dot + r]
            free_acceleration(0, 1, 4, N_m, b.modes, K, work)
            tip_force(0, 1, 4, N_m, np.sin(psi), np.cos(psi), h_plane, b.foreshortening, b.modes, b.G, c, work)
            for r in range(N_m):
                rate[eta + r], rate[eta_dot + r] = work[1, r], work[4, r]
            F_x -= work[10, 0]
            F_z -= work[10, 1]
            T_brush += work[10, 2]
        rate[2], rate[3], rate[4], rate[5] = omega_b, F_x, F_z, T_brush

        # motor
        powers = motor_rates(
            state[0], state[1], V_in, T_brush, False, N_g, m.R, m.L_a, m.K_t, m.K_e, m.B_m, m.J_m, m.J_b,
            m.gear_efficiency, m.gear_speed_eps)  # fmt: skip
        rate[0], rate[1] = powers[0], powers[1]

        # vehicle, whose housing takes T_brush
        at = 6 + 2 * n * N_m
        tau_control, tau_disturb, tau_external = np.zeros(6), np.zeros(6), np.zeros(6)
        thrust = state[at + 18 : at + 26]
        thruster_wrench(tau_control, v.B, thrust, u_thruster, v.k_T_forward, v.k_T_reverse, 1.0)
        tool_wrench(tau_disturb, v.r_tool, v.R_tool_body, F_x, v.F_y, F_z, v.M_x, T_brush, v.M_z)
        tau_external[:3], tau_external[3:] = v.F_external, v.M_external
        vehicle_rates(
            rate[at : at + 18], state[at : at + 18], np.zeros(9), np.zeros(3), np.zeros(15), tau_control, tau_disturb,
            tau_external, v.v_c, v.M, v.M_inv, v.added_mass, v.D, v.lever, v.net_buoyancy)  # fmt: skip
        for j in range(8):
            rate[at + 18 + j] = (thrust_of(u_thruster[j], v.k_T_forward, v.k_T_reverse) - thrust[j]) / lag
        return rate

    return rates


@dataclass(frozen=True)
class Solution:
    """What is compared: rows of `time` [s], pose [m] and attitude quaternion, brush angle [rad] and impulses."""

    time: np.ndarray  # (rows,)
    theta_b: np.ndarray  # (rows,)
    impulses: np.ndarray  # (rows, 3): time integrals of F_x, F_z, T_brush
    position: np.ndarray  # (rows, 3)
    quat: np.ndarray  # (rows, 4)
    evaluations: int

    def means(self, turns: int) -> dict[str, float]:
        """Time averages of F_x, F_z, T_brush and omega_b over the last whole turns of the brush."""
        begin = float(np.interp(self.theta_b[-1] - 2.0 * np.pi * turns, self.theta_b, self.time))
        span = self.time[-1] - begin
        before = [np.interp(begin, self.time, self.impulses[:, k]) for k in range(3)]
        F_x, F_z, T_brush = (self.impulses[-1] - before) / span
        return {"F_z": F_z, "F_x": F_x, "T_brush": T_brush, "omega_b": 2.0 * np.pi * turns / span}


def solve(system: System, stop: float, rtol: float = 1e-8, method: str = "DOP853") -> Solution:
    """Integrate `system` (components motor, brush, vehicle, controller, connected as in nominal.toml) to `stop` [s]."""
    parts = {name: Part(component) for name, component in system.components.items()}
    motor, brush, vehicle, controller = (parts[name] for name in ("motor", "brush", "vehicle", "controller"))
    rates = right_hand_side(motor, brush, vehicle)
    eta, eta_dot = (brush.values[name].ravel() for name in ("eta", "eta_dot"))
    at = 6 + 2 * eta.size
    state = np.concatenate([
        motor.values["x"][:2], brush.values["total"][:4], eta, eta_dot, vehicle.values["x"],
        vehicle.values["thrust_state"],
    ])  # fmt: skip
    # What is small in each part: A, rad/s; modal displacements of a bent filament are some mm, at some m/s.
    scale = np.ones(state.size)
    scale[6 : 6 + eta.size] = 1e-3
    atol = rtol * scale
    T_s = controller.values["T_s"]
    rows, evaluations, step = [np.concatenate([[0.0], state])], 0, 1e-6
    for sample in range(round(stop / T_s)):
        vehicle.values["x"][:] = state[at : at + 18]
        vehicle.values["thrust_state"][:] = state[at + 18 :]
        vehicle.call("outputs")
        seen = {name: vehicle[name] for name in TO_CONTROLLER}
        controller.call("step", t=sample * T_s, h=T_s, **seen)
        command = np.array([controller[f"u_thruster[{j}]"] for j in range(1, 9)])
        grid = np.linspace(sample * T_s, (sample + 1) * T_s, 21)
        part = solve_ivp(
            rates, (grid[0], grid[-1]), state, method, grid[1:], args=(command, controller["V_in"]), rtol=rtol,
            atol=atol, first_step=step)  # fmt: skip
        assert part.success, part.message
        state, evaluations = part.y[:, -1].copy(), evaluations + part.nfev
        rows += [np.concatenate([[t], y]) for t, y in zip(part.t, part.y.T, strict=True)]
    table = np.array(rows)
    pose = table[:, 1 + at :]
    return Solution(table[:, 0], table[:, 3], table[:, 4:7], pose[:, :3], pose[:, 3:7], evaluations)
