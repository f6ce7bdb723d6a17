"""What was set at an instant is not set again for the step that begins there, unless an input has become another."""

from __future__ import annotations

from rovbrush.orchestrator.loop.operations import COPY, GET, ITERATE, LINEAR, MEAN, PUSH, SET, STEP
from rovbrush.orchestrator.plan.schedule.repeats import without_repeats
from rovbrush.orchestrator.plan.schedule.values import Row

INPUTS, OUTPUTS = {0: [0], 1: [1]}, {0: [2], 1: [3]}  # cells of two components
COPIED = (COPY, 0, 0, 3, 0, 0, 0, 0)  # the first takes what the second gives
SENT, STEPPED, READ = (SET, 0, 0, 0, 0, 0, 0, 0), (STEP, 0, 0, 1, 0, 0, 0, 0), (GET, 0, 1, 0, 0, 0, 0, 0)


def sets(*rows: Row) -> int:
    kept = without_repeats(rows, INPUTS, OUTPUTS)
    assert [row for row in kept if row[0] != SET] == [row for row in rows if row[0] != SET], "nothing else is dropped"
    return sum(row[0] == SET for row in kept)


def test_the_same_value_is_sent_once_between_two_steps() -> None:
    assert sets(COPIED, SENT, COPIED, SENT, STEPPED) == 1
    assert sets(COPIED, SENT, STEPPED, COPIED, SENT, STEPPED) == 2, "a step may change what an FMU holds"


def test_a_value_that_is_kept_and_comes_back_is_the_same() -> None:
    kept, back = (PUSH, 0, 0, 0, 9, 0, 0, 0), (PUSH, 0, 0, 9, 0, 0, 0, 0)
    assert sets(kept, COPIED, SENT, back, COPIED, SENT) == 1
    assert sets(kept, COPIED, SENT, back, SENT) == 2


def test_another_value_is_sent() -> None:
    assert sets(COPIED, SENT, READ, COPIED, SENT) == 2, "the source was read again"
    assert sets(COPIED, SENT, (COPY, 0, 0, 3, 0, 0, 0, 2), SENT) == 2, "by other coefficients"
    for code in (LINEAR, MEAN):
        formed = (code, 0, 0, 3, 0, 5, 6, 0)
        assert sets(formed, SENT, formed, SENT) == 2, "a time or an integral is in it"


def test_what_may_be_repeated_or_taken_back_stays_as_it_is() -> None:
    assert sets(COPIED, SENT, COPIED, SENT, (ITERATE, 0, -1, 0, 0, 0, 0, 0)) == 2
