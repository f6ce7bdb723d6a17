"""Gaussian noise by a counter: what is drawn depends on seed, stream and counter alone, in whatever order it is asked.

The bits are those of Philox4x32-10: J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, Parallel random numbers: as
easy as 1, 2, 3, SC11 (2011). Its counter is (counter, stream), its key the seed. Two numbers of 53 bits become one
Gaussian by G. E. P. Box, M. E. Muller, A note on the generation of random normal deviates (1958):

    u1 = (k1 + 1) / 2^53,  u2 = k2 / 2^53,  n = sqrt(-2 ln u1) cos(2 pi u2)
"""

from __future__ import annotations

from math import cos, log, pi, sqrt

from .lives import compilable

WORD = 0xFFFFFFFF
FACTOR_0, FACTOR_1 = 0xD2511F53, 0xCD9E8D57
WEYL_0, WEYL_1 = 0x9E3779B9, 0xBB67AE85
ROUNDS = 10
FINE = 1.0 / 9007199254740992.0  # 2^-53


@compilable
def high(a: int, b: int) -> int:
    """The upper 32 bits of the product of two 32-bit numbers, with no intermediate beyond 63 bits."""
    upper = a * (b >> 16)
    return (upper >> 16) + ((a * (b & 0xFFFF) + ((upper & 0xFFFF) << 16)) >> 32)


@compilable
def low(a: int, b: int) -> int:
    """The lower 32 bits of it."""
    return (a * (b & 0xFFFF) + (((a * (b >> 16)) & 0xFFFF) << 16)) & WORD


@compilable
def philox(c0: int, c1: int, c2: int, c3: int, k0: int, k1: int) -> tuple[int, int, int, int]:
    """Four random 32-bit words of a counter of four and a key of two."""
    for _ in range(ROUNDS):
        h0, l0, h1, l1 = high(c0, FACTOR_0), low(c0, FACTOR_0), high(c2, FACTOR_1), low(c2, FACTOR_1)
        c0, c1, c2, c3 = h1 ^ c1 ^ k0, l1, h0 ^ c3 ^ k1, l0
        k0, k1 = (k0 + WEYL_0) & WORD, (k1 + WEYL_1) & WORD
    return c0, c1, c2, c3


@compilable
def gaussian(seed: int, stream: int, counter: int) -> float:
    """One draw of mean 0 and standard deviation 1; all three are 64-bit numbers, of either sign."""
    w0, w1, w2, w3 = philox(
        counter & WORD, (counter >> 32) & WORD, stream & WORD, (stream >> 32) & WORD,
        seed & WORD, (seed >> 32) & WORD,
    )  # fmt: skip
    u1 = float(((w0 << 21) | (w1 >> 11)) + 1) * FINE
    u2 = float((w2 << 21) | (w3 >> 11)) * FINE
    return sqrt(-2.0 * log(u1)) * cos(2.0 * pi * u2)
