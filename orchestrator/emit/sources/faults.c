/* What faults make of an input. */
#include "inside.h"

enum { MODE, GAIN, OFFSET_OR_VALUE, SIGMA, SEED }; /* cells of a fault */

/* Gaussian noise by a counter: Philox4x32-10 (Salmon, Moraes, Dror, Shaw, SC11, 2011) and Box-Muller (1958). */
static double gaussian(int64_t seed, int64_t stream, int64_t counter) {
    uint32_t c[4] = {(uint32_t)counter, (uint32_t)((uint64_t)counter >> 32), (uint32_t)stream, (uint32_t)((uint64_t)stream >> 32)};
    uint32_t k0 = (uint32_t)seed, k1 = (uint32_t)((uint64_t)seed >> 32);
    for (int round = 0; round < 10; round++) {
        const uint64_t a = UINT64_C(0xD2511F53) * c[0], b = UINT64_C(0xCD9E8D57) * c[2];
        const uint32_t next[4] = {(uint32_t)(b >> 32) ^ c[1] ^ k0, (uint32_t)b, (uint32_t)(a >> 32) ^ c[3] ^ k1, (uint32_t)a};
        memcpy(c, next, sizeof c);
        k0 += UINT32_C(0x9E3779B9), k1 += UINT32_C(0xBB67AE85);
    }
    const double u1 = (double)((((uint64_t)c[0] << 21) | (c[1] >> 11)) + 1) * 0x1p-53;
    const double u2 = (double)(((uint64_t)c[2] << 21) | (c[3] >> 11)) * 0x1p-53;
    return sqrt(-2.0 * log(u1)) * cos(2.0 * 3.141592653589793 * u2);
}

double SYSTEM_faulted(const SYSTEM *s, int first, int64_t stream, int64_t counter, double value) {
    double found = s->now.z[first + GAIN] * value + s->now.z[first + OFFSET_OR_VALUE];
    if (s->now.z[first + SIGMA] != 0.0)
        found += s->now.z[first + SIGMA] * gaussian(s->now.whole[first + SEED], stream, counter);
    return found;
}
