"""Cells of the memory that the loop and its workers share: one record per component that takes part, and a head."""

from __future__ import annotations

# A job: what becomes of it, what it is called with (as bits of doubles), the answer; function, instance and signatures
# (2 or 3); the jobs that a call of it posts; how often it was called and how long that took [ns]; what FMI 3.0 writes.
STATE, TIME, LENGTH, FINAL, STATUS, FUNCTION, INSTANCE, FMI, FIRST, LAST, CALLS, SPENT, FLAGS = range(13)
JOB = 16  # cells, two lines of the cache: no two threads write to one
IDLE, POSTED, TAKEN, DONE = range(4)  # of STATE

# The head: whether workers are to end, whether calls post others (or are timed), how many jobs there are.
STOP, MODE, JOBS = range(3)
HEAD = 16
TIMED, SHARED = range(2)  # of MODE
