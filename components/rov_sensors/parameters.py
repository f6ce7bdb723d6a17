"""Parameters of the sensors, each with unit and source. The defaults pass the truth through unchanged."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ..declare.interface import parameter

OFF = "off"
STANDARD = "standard gravity"


def rate_of(sensor: str) -> Any:
    """How often a sensor takes a sample."""
    meaning = f"samples of the {sensor} per second, 0 = one at every communication point"
    return parameter(0.0, "1/s", meaning, OFF, 0.0, 500.0)


def delay_of(sensor: str) -> Any:
    """How long a sample of a sensor takes."""
    return parameter(0.0, "s", f"time from a sample of the {sensor} to its arrival", OFF, 0.0, 0.5)


def noise_of(quantity: str, unit: str) -> Any:
    """How much samples scatter."""
    return parameter(0.0, unit, f"standard deviation of the {quantity} from sample to sample", OFF, 0.0, 1e4)


def bias_of(quantity: str, unit: str, size: int) -> Any:
    """What is added to every sample."""
    start = (0.0,) * size if size else 0.0
    return parameter(start, unit, f"what is added to the {quantity}", OFF, -1e4, 1e4)


def quantum_of(quantity: str, unit: str) -> Any:
    """What readings are multiples of."""
    return parameter(0.0, unit, f"readings of the {quantity} are multiples of it, 0 = any", OFF, 0.0, 1e4)


def dropout_of(sensor: str) -> Any:
    """How many samples are lost."""
    return parameter(0.0, "1", f"probability that a sample of the {sensor} is lost; the last one holds", OFF, 0.0, 1.0)


def gain_of(sensor: str) -> Any:
    """An error of scale."""
    return parameter(1.0, "1", f"reading of the {sensor} per truth, before the bias", OFF, -100.0, 100.0)


@dataclass(frozen=True)
class Parameters:
    """Seven sensors, each with its samples and its errors, and a delay and a gain common to all."""

    delay: float = parameter(
        0.0, "s", "further delay of all sensors (for a margin: raised until a loop no longer decays)", OFF, 0.0, 0.5
    )
    gain: float = parameter(
        1.0, "1", "factor on all that is shown (for a margin: raised until a loop no longer decays)", OFF, -100.0, 100.0
    )
    seed: int = parameter(1, "1", "seed of noise and lost samples; each number gives others", "any", 0, 2147483647)
    g: float = parameter(9.80665, "m/s2", "acceleration of gravity", STANDARD, minimum=0.0, maximum=100.0)
    r_imu: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "m", "place of the accelerometer, body frame", "assumed", -10.0, 10.0
    )

    rate_dvl: float = rate_of("DVL")
    delay_dvl: float = delay_of("DVL")
    noise_dvl: float = noise_of("velocity", "m/s")
    bias_dvl: tuple[float, ...] = bias_of("velocity", "m/s", 3)
    quantum_dvl: float = quantum_of("velocity", "m/s")
    dropout_dvl: float = dropout_of("DVL")
    gain_dvl: float = gain_of("DVL")

    rate_position: float = rate_of("position")
    delay_position: float = delay_of("position")
    noise_position: float = noise_of("position north and east", "m")
    bias_position: tuple[float, ...] = bias_of("position north and east", "m", 2)
    quantum_position: float = quantum_of("position north and east", "m")
    dropout_position: float = dropout_of("position")
    gain_position: float = gain_of("position")

    rate_depth: float = rate_of("depth sensor")
    delay_depth: float = delay_of("depth sensor")
    noise_depth: float = noise_of("depth", "m")
    bias_depth: float = bias_of("depth", "m", 0)
    quantum_depth: float = quantum_of("depth", "m")
    dropout_depth: float = dropout_of("depth sensor")
    gain_depth: float = gain_of("depth sensor")

    rate_attitude: float = rate_of("attitude")
    delay_attitude: float = delay_of("attitude")
    noise_attitude: float = noise_of("roll, pitch and yaw angles", "rad")
    bias_attitude: tuple[float, ...] = bias_of("roll, pitch and yaw angles", "rad", 3)
    quantum_attitude: float = quantum_of("roll, pitch and yaw angles", "rad")
    dropout_attitude: float = dropout_of("attitude")
    gain_attitude: float = gain_of("attitude")

    rate_gyro: float = rate_of("gyro")
    delay_gyro: float = delay_of("gyro")
    noise_gyro: float = noise_of("rates", "rad/s")
    bias_gyro: tuple[float, ...] = bias_of("rates", "rad/s", 3)
    quantum_gyro: float = quantum_of("rates", "rad/s")
    dropout_gyro: float = dropout_of("gyro")
    gain_gyro: float = gain_of("gyro")

    rate_accelerometer: float = rate_of("accelerometer")
    delay_accelerometer: float = delay_of("accelerometer")
    noise_accelerometer: float = noise_of("specific force", "m/s2")
    bias_accelerometer: tuple[float, ...] = bias_of("specific force", "m/s2", 3)
    quantum_accelerometer: float = quantum_of("specific force", "m/s2")
    dropout_accelerometer: float = dropout_of("accelerometer")
    gain_accelerometer: float = gain_of("accelerometer")

    rate_force: float = rate_of("force sensor")
    delay_force: float = delay_of("force sensor")
    noise_force: float = noise_of("tool force", "N")
    noise_moment: float = noise_of("tool moment", "N.m")
    bias_force: tuple[float, ...] = bias_of("tool force", "N", 3)
    bias_moment: tuple[float, ...] = bias_of("tool moment", "N.m", 3)
    quantum_force: float = quantum_of("tool force", "N")
    quantum_moment: float = quantum_of("tool moment", "N.m")
    dropout_force: float = dropout_of("force sensor")
    gain_force: float = gain_of("force sensor")


NOMINAL = Parameters()
