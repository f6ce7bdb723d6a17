"""Random numbers by counter: number k of a stream is a pure function of k, the stream and a seed, in any order."""

from math import cos, floor, log, pi, sqrt


def philox(counter: int, stream: int, seed: int) -> tuple[int, int]:
    """Two numbers of 32 bits from three: Philox2x32-10 (Salmon, Moraes, Dror and Shaw 2011).

    The product of 64 bits is made of two halves, which no sign can reach.
    """
    left = counter
    right = stream
    key = seed
    for _ in range(10):
        low = left * 53651
        middle = (low >> 16) + left * 53846  # 53846*2^16 + 53651 = 0xD256D193
        left = (middle >> 16) ^ key ^ right
        right = ((middle & 65535) << 16) | (low & 65535)
        key = (key + 2654435769) & 4294967295  # 0x9E3779B9
    return left, right


def bits_of(number: float) -> int:
    """The last 32 bits of a whole number."""
    return int(number - 4294967296.0 * floor(number / 4294967296.0))


def uniform(number: float, stream: int, seed: int) -> float:
    """Between 0 and 1, never either."""
    left, right = philox(bits_of(number), stream, seed)
    return ((left ^ right) + 0.5) / 4294967296.0


def gaussian(number: float, stream: int, seed: int) -> float:
    """Of mean 0 and variance 1, by the cosine of Box and Muller (1958); at most 6.7."""
    left, right = philox(bits_of(number), stream, seed)
    return sqrt(-2.0 * log((left + 0.5) / 4294967296.0)) * cos(2.0 * pi * ((right + 0.5) / 4294967296.0))
