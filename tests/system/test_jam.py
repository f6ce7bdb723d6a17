"""The shipped scenario: a brush that jams, and a drive that switches off."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
from helpers import column
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import AT_START
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system


def test_the_drive_switches_off_20_ms_after_its_current_has_crossed_120_a(fmus: Path) -> None:
    run = simulate(make_plan(load_system("jam", fmus)))
    assert not run.failure
    t, i = column(run, "motor.i")
    crossed = float(t[np.argmax(i > 120.0)])
    jam, seen, off = (row for row in run.events if row.what not in ("", AT_START))
    assert (jam.time, jam.what) == (1.0, "jam: brush.delta = 0.008 m, brush.friction_scale = 4")
    assert (seen.time, seen.what) == (crossed, "trip: motor.i > 120 A") and crossed > 1.0
    assert off.what == "trip: motor.V_in = 0 V" and abs(off.time - seen.time - 0.02) < 1e-12
    voltage = column(run, "motor.V_in")[1]
    assert np.all(voltage[t < off.time] == 12.0) and np.all(voltage[t >= off.time] == 0.0)
    assert i[-1] < 0.0  # the bent filaments turn the motor back


def test_until_the_jam_it_is_the_test_stand_bit_by_bit(fmus: Path) -> None:
    jam, stand = load_system("jam", fmus), load_system("test_stand", fmus)
    runs = [simulate(make_plan(replace(system, stop=Fraction(1)))) for system in (jam, stand)]
    assert runs[0].plan.groups[0].columns != runs[1].plan.groups[0].columns  # what events set is recorded too
    for name in ("motor.i", "motor.omega_b", "brush.F_z", "brush.T_brush"):
        assert column(runs[0], name)[1].tobytes() == column(runs[1], name)[1].tobytes()
