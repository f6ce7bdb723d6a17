"""What a participant in the autopilot's place is given and gives, by the names and units of `rov_controller`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from ..clock import seconds_text
from ..errors import InputError
from .axes import Triple, along_world, from_home
from .packet import ServoPacket
from .servos import HEAVY, Servo
from .state_line import DISTANCES, VehicleState

FASTEST = 2**16 - 1  # Hz, the largest frame_rate of a packet
SLOWEST = 11  # Hz: the firmware's clock does not follow steps of 0.1 s and longer (SIM_JSON.cpp)


@dataclass(frozen=True)
class Signal:
    """A variable; `size` values, 0 for a number by itself."""

    name: str
    unit: str
    description: str
    size: int = 0

    @property
    def scalars(self) -> list[str]:
        """Its name, or those of its values one by one."""
        return [f"{self.name}[{k}]" for k in range(1, self.size + 1)] or [self.name]


@dataclass(frozen=True)
class Options:
    """What is chosen for an autopilot."""

    rate: int = 400  # Hz, of the frames
    port: int = 9002
    host: str = "127.0.0.1"
    peer: str = ""  # the one address that is listened to beyond loopback
    timeout: float = 30.0  # s of wall time
    origin: Triple = (0.0, 0.0, 0.0)  # m: the world's origin from the autopilot's home, north, east, down
    rangefinders: int = 0
    battery: bool = False
    servos: tuple[Servo, ...] = (HEAVY,)

    def __post_init__(self) -> None:
        if not 0 <= self.rangefinders <= DISTANCES:
            raise InputError(f"rangefinders = {self.rangefinders}; the protocol has 0 to {DISTANCES}")


MOTION = (
    Signal("x_n", "m", "position north"),
    Signal("y_n", "m", "position east"),
    Signal("z_n", "m", "position down"),
    Signal("phi", "rad", "roll angle"),
    Signal("theta", "rad", "pitch angle"),
    Signal("psi", "rad", "yaw angle"),
    Signal("u", "m/s", "surge velocity over ground, body frame"),
    Signal("v", "m/s", "sway velocity over ground, body frame"),
    Signal("w", "m/s", "heave velocity over ground, body frame"),
    Signal("p", "rad/s", "roll rate, body frame"),
    Signal("q", "rad/s", "pitch rate, body frame"),
    Signal("r", "rad/s", "yaw rate, body frame"),
    Signal("f", "m/s2", "specific force, body frame: (0, 0, -g) at rest and level", 3),
)
SUPPLY = (Signal("V_battery", "V", "voltage of the battery"), Signal("i_battery", "A", "current that it delivers"))
FRAME = Signal("frame", "1", "number of the frame that the outputs are of")


def inputs_of(options: Options) -> tuple[Signal, ...]:
    """What it is given: motion, specific force, and what else was chosen."""
    distances = tuple(
        Signal(f"rng_{k + 1}", "m", f"distance of rangefinder {k + 1}") for k in range(options.rangefinders)
    )
    return (*MOTION, *distances, *(SUPPLY if options.battery else ()))


def outputs_of(options: Options) -> tuple[Signal, ...]:
    """What it gives: the values of its servos, and the number of their frame."""
    servos = (
        Signal(s.output, s.unit, s.description, len(s.channels) if len(s.channels) > 1 else 0) for s in options.servos
    )
    return (*servos, FRAME)


def state_of(time: float, values: Sequence[float], options: Options) -> VehicleState:
    """The state at a time [s] from the values of all inputs, in the order of `inputs_of`, arrays one by one."""
    x_n, y_n, z_n, phi, theta, psi, u, v, w, p, q, r, a_x, a_y, a_z, *more = values
    attitude = phi, theta, psi
    distances, supply = tuple(more[: options.rangefinders]), more[options.rangefinders :]
    return VehicleState(
        time,
        (p, q, r),
        (a_x, a_y, a_z),
        from_home(options.origin, (x_n, y_n, z_n)),
        attitude,
        along_world(attitude, (u, v, w)),
        distances,
        (supply[0], supply[1]) if options.battery else None,
    )


def values_of(packet: ServoPacket, options: Options) -> list[float]:
    """The values of all outputs from a packet, in the order of `outputs_of`, arrays one by one."""
    return [value for servo in options.servos for value in servo.read(packet.pwm)] + [float(packet.frame_count)]


def rate_of(period: Fraction, what: str) -> int:
    """The rate of frames [Hz] of a period [s]. Raises InputError where no autopilot can have it."""
    rate = 1 / period
    if rate.denominator != 1 or not SLOWEST <= rate <= FASTEST:
        near = min(max(round(rate), SLOWEST), FASTEST)
        raise InputError(
            f"{what}: its period of {seconds_text(period)} is {float(rate):.6g} Hz, but an autopilot's frames come at "
            f"a whole number of Hz from {SLOWEST} to {FASTEST}; take 1/{near} s (2.5 ms is ArduSub's own loop)"
        )
    return int(rate)


def rate_of_step(length: float) -> int:
    """The rate of frames [Hz] of a step [s], which is a period but for rounding."""
    return max(round(1.0 / length), 1)
