"""Peers that take part from outside, by UDP or by shared memory: packets, waiting, and what is counted."""
