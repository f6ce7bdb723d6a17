"""Servo channels and what they mean for a vehicle, as data: pulses [us] along which a value goes straight.

| what | value | source |
| --- | --- | --- |
| channels 1 to 8 | motors 1 to 8 | SERVO1_FUNCTION = 33 to SERVO8_FUNCTION = 40 (bluerov2-heavy-4_0_0.params) |
| pulses | 1100, 1500, 1900 us: full reverse, stop, full forward | MOT_PWM_MIN, MOT_PWM_MAX there; AP_Motors6DOF.cpp |
| order and sense of the motors | `MOTOR_FACTORS` | AP_Motors6DOF.cpp, SUB_FRAME_VECTORED_6DOF (FRAME_CONFIG = 2) |
| no pulse (0) | stop | before the autopilot has set up its outputs |
"""

from __future__ import annotations

from dataclasses import dataclass

# Of motors 1 to 8: how much of roll, pitch, yaw, throttle (up), forward and lateral (starboard) each takes.
MOTOR_FACTORS: tuple[tuple[float, ...], ...] = (
    (0.0, 0.0, 1.0, 0.0, -1.0, 1.0),
    (0.0, 0.0, -1.0, 0.0, -1.0, -1.0),
    (0.0, 0.0, -1.0, 0.0, 1.0, 1.0),
    (0.0, 0.0, 1.0, 0.0, 1.0, -1.0),
    (1.0, -1.0, 0.0, -1.0, 0.0, 0.0),
    (-1.0, -1.0, 0.0, -1.0, 0.0, 0.0),
    (1.0, 1.0, 0.0, -1.0, 0.0, 0.0),
    (-1.0, 1.0, 0.0, -1.0, 0.0, 0.0),
)


@dataclass(frozen=True)
class Servo:
    """An output of the autopilot: channels (from 1), the pulses [us], rising, and the values at these."""

    output: str
    channels: tuple[int, ...]
    pulses: tuple[float, ...]
    values: tuple[float, ...]
    idle: float  # the value without a pulse
    unit: str = "1"
    description: str = ""

    def value(self, pulse: float) -> float:
        """The value at a pulse [us]: straight between the points, that of the last point beyond it."""
        if pulse == 0:
            return self.idle
        if pulse <= self.pulses[0]:
            return self.values[0]
        for k in range(1, len(self.pulses)):
            if pulse <= self.pulses[k]:
                share = (pulse - self.pulses[k - 1]) / (self.pulses[k] - self.pulses[k - 1])
                return self.values[k - 1] + share * (self.values[k] - self.values[k - 1])
        return self.values[-1]

    def read(self, pwm: tuple[int, ...]) -> list[float]:
        """The values of its channels in a packet; without a pulse where the packet has no such channel."""
        return [self.value(pwm[channel - 1] if channel <= len(pwm) else 0) for channel in self.channels]


HEAVY = Servo(
    "u_thruster",
    tuple(range(1, 9)),
    (1100.0, 1500.0, 1900.0),
    (-1.0, 0.0, 1.0),
    0.0,
    "1",
    "thruster commands of the heavy frame (ArduSub's motors 1 to 8), -1 to 1",
)
