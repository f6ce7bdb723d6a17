"""The parameters as vectors: by sensor, and by channel."""

from ..library.vectors import copy
from .parameters import Parameters
from .records import Channels, Scratch, Sensors, State


def channels_of(k: Sensors) -> None:
    """How many channels each sensor has."""
    k.dvl = 3.0
    k.position = 2.0
    k.depth = 1.0
    k.attitude = 3.0
    k.gyro = 3.0
    k.accelerometer = 3.0
    k.force = 6.0


def period_of(rate: float) -> float:
    """Time between two samples; 0 without a rate."""
    period = 0.0
    if rate > 0.0:
        period = 1.0 / rate
    return period


def periods(k: Sensors, p: Parameters) -> None:
    """Time between the samples of each sensor."""
    k.dvl = period_of(p.rate_dvl)
    k.position = period_of(p.rate_position)
    k.depth = period_of(p.rate_depth)
    k.attitude = period_of(p.rate_attitude)
    k.gyro = period_of(p.rate_gyro)
    k.accelerometer = period_of(p.rate_accelerometer)
    k.force = period_of(p.rate_force)


def latencies(k: Sensors, p: Parameters) -> None:
    """Delay of each sensor, the common one included."""
    k.dvl = p.delay_dvl + p.delay
    k.position = p.delay_position + p.delay
    k.depth = p.delay_depth + p.delay
    k.attitude = p.delay_attitude + p.delay
    k.gyro = p.delay_gyro + p.delay
    k.accelerometer = p.delay_accelerometer + p.delay
    k.force = p.delay_force + p.delay


def gains(k: Sensors, p: Parameters) -> None:
    """Gain of each sensor."""
    k.dvl = p.gain_dvl
    k.position = p.gain_position
    k.depth = p.gain_depth
    k.attitude = p.gain_attitude
    k.gyro = p.gain_gyro
    k.accelerometer = p.gain_accelerometer
    k.force = p.gain_force


def dropouts(k: Sensors, p: Parameters) -> None:
    """Probability that a sample is lost, of each sensor."""
    k.dvl = p.dropout_dvl
    k.position = p.dropout_position
    k.depth = p.dropout_depth
    k.attitude = p.dropout_attitude
    k.gyro = p.dropout_gyro
    k.accelerometer = p.dropout_accelerometer
    k.force = p.dropout_force


def equal(c: Channels, dvl: float, position: float, depth: float, attitude: float, gyro: float) -> None:
    """The same for all channels of a sensor; of those with arrays see `equal_arrays`."""
    c.u = dvl
    c.v = dvl
    c.w = dvl
    c.x_n = position
    c.y_n = position
    c.z_n = depth
    c.phi = attitude
    c.theta = attitude
    c.psi = attitude
    c.p = gyro
    c.q = gyro
    c.r = gyro


def equal_arrays(c: Channels, accelerometer: float, force: float, moment: float) -> None:
    """The same for all elements of the arrays."""
    for i in range(3):
        c.f[i] = accelerometer
        c.F_tool[i] = force
        c.M_tool[i] = moment


def biases(c: Channels, p: Parameters) -> None:
    """What is added to each channel."""
    c.u = p.bias_dvl[0]
    c.v = p.bias_dvl[1]
    c.w = p.bias_dvl[2]
    c.x_n = p.bias_position[0]
    c.y_n = p.bias_position[1]
    c.z_n = p.bias_depth
    c.phi = p.bias_attitude[0]
    c.theta = p.bias_attitude[1]
    c.psi = p.bias_attitude[2]
    c.p = p.bias_gyro[0]
    c.q = p.bias_gyro[1]
    c.r = p.bias_gyro[2]
    for i in range(3):
        c.f[i] = p.bias_accelerometer[i]
        c.F_tool[i] = p.bias_force[i]
        c.M_tool[i] = p.bias_moment[i]


def wrapping(c: Channels) -> None:
    """Roll and yaw begin again behind pi."""
    equal(c, 0.0, 0.0, 0.0, 0.0, 0.0)
    equal_arrays(c, 0.0, 0.0, 0.0)
    c.phi = 1.0
    c.psi = 1.0


def into_vectors(p: Parameters, x: State, s: Scratch) -> None:
    """All settings into the vectors of the state."""
    channels_of(s.sensors)
    copy(7, x.channels, s.sensors)
    periods(s.sensors, p)
    copy(7, x.period, s.sensors)
    latencies(s.sensors, p)
    copy(7, x.latency, s.sensors)
    gains(s.sensors, p)
    copy(7, x.scale, s.sensors)
    dropouts(s.sensors, p)
    copy(7, x.dropout, s.sensors)
    equal(s.settings, p.noise_dvl, p.noise_position, p.noise_depth, p.noise_attitude, p.noise_gyro)
    equal_arrays(s.settings, p.noise_accelerometer, p.noise_force, p.noise_moment)
    copy(21, x.noise, s.settings)
    equal(s.settings, p.quantum_dvl, p.quantum_position, p.quantum_depth, p.quantum_attitude, p.quantum_gyro)
    equal_arrays(s.settings, p.quantum_accelerometer, p.quantum_force, p.quantum_moment)
    copy(21, x.quantum, s.settings)
    biases(s.settings, p)
    copy(21, x.bias, s.settings)
    wrapping(s.settings)
    copy(21, x.wraps, s.settings)
