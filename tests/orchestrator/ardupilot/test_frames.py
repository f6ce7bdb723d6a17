"""The lock-step by frame counts: nothing is done twice, nothing is missed in silence."""

from __future__ import annotations

import pytest
from rovbrush.orchestrator.ardupilot.frames import SETTLING, Frames, Verdict
from rovbrush.orchestrator.ardupilot.packet import ServoPacket
from rovbrush.orchestrator.errors import RunError


def packet(count: int, rate: int = 400) -> ServoPacket:
    return ServoPacket(rate, count % 2**32, (1500,) * 16)


def at_frame(count: int) -> Frames:
    """A lock-step that has heard the frames up to `count` from "a", and told the state of the last at 0 s."""
    frames = Frames(400)
    for k in range(count + 1):
        assert frames.judge(packet(k), "a", 0.0) is Verdict.NEW
    frames.told(0.0)
    return frames


def test_frames_in_order_are_new_each_once() -> None:
    frames = at_frame(100)
    assert (frames.counts.frames, frames.counts.lost, frames.counts.doubled) == (101, 0, 0)
    assert frames.counts.text() == "101 frames, 0 lost, 0 doubled"


def test_the_first_frame_may_have_any_count() -> None:
    frames = Frames(400)
    assert frames.judge(packet(123456), "a", 0.0) is Verdict.NEW
    assert frames.judge(packet(123457), "a", 0.0) is Verdict.NEW
    assert frames.counts.lost == 0


def test_a_packet_that_the_network_doubled_is_dropped() -> None:
    frames = at_frame(5)
    assert frames.judge(packet(5), "a", 0.001) is Verdict.DROPPED
    assert frames.counts.doubled == 1
    assert frames.judge(packet(6), "a", 0.002) is Verdict.NEW
    assert frames.judge(packet(6), "a", 9.0) is Verdict.DROPPED  # its state line has not been sent yet


def test_a_frame_that_comes_again_much_later_asks_for_the_state_once_more() -> None:
    frames = at_frame(5)
    assert frames.judge(packet(5), "a", 1.0) is Verdict.AGAIN
    frames.told(1.0)
    assert frames.judge(packet(5), "a", 1.1) is Verdict.DROPPED
    assert frames.judge(packet(5), "a", 2.0) is Verdict.AGAIN
    assert (frames.counts.asked_again, frames.counts.doubled, frames.counts.frames) == (2, 1, 6)


def test_a_packet_that_comes_late_is_dropped() -> None:
    frames = at_frame(5)
    assert frames.judge(packet(4), "a", 0.0) is Verdict.DROPPED
    assert frames.judge(packet(0), "a", 0.0) is Verdict.DROPPED  # near enough to have been overtaken
    assert frames.counts.late == 2 and frames.counts.restarts == 0


def test_a_gap_in_the_counter_is_counted_as_lost_frames() -> None:
    frames = at_frame(5)
    assert frames.judge(packet(9), "a", 0.0) is Verdict.NEW
    assert frames.counts.lost == 3


def test_a_count_far_ahead_is_chance_and_is_dropped() -> None:
    frames = at_frame(5)
    assert frames.judge(packet(5 + 2000), "a", 0.0) is Verdict.DROPPED
    assert frames.counts.garbage == 1 and frames.last_garbage == "frame 2005 behind frame 5"
    assert frames.judge(packet(6), "a", 0.0) is Verdict.NEW


def test_a_count_of_0_from_another_sender_is_a_restart() -> None:
    frames = at_frame(5)
    assert frames.judge(packet(0, rate=1200), "b", 0.0) is Verdict.NEW
    assert frames.sender == "b" and frames.counts.restarts == 1
    assert frames.judge(packet(1, rate=1199), "b", 0.0) is Verdict.NEW
    assert frames.judge(packet(6), "a", 0.0) is Verdict.DROPPED  # the one before has nothing to say any more
    assert "1 restart of the autopilot" in frames.counts.text()


def test_a_count_of_0_far_back_from_the_same_sender_is_a_restart() -> None:
    frames = at_frame(100)
    assert frames.judge(packet(0), "a", 0.0) is Verdict.NEW
    assert frames.counts.restarts == 1


def test_a_second_autopilot_is_not_listened_to() -> None:
    frames = at_frame(5)
    assert frames.judge(packet(6), "b", 0.0) is Verdict.DROPPED
    assert frames.counts.strangers == 1 and frames.sender == "a"


def test_the_counter_begins_again_behind_its_32_bits_without_a_restart() -> None:
    frames = Frames(400)
    for k in range(2**32 - 3, 2**32 + 3):
        assert frames.judge(packet(k), "a", 0.0) is Verdict.NEW
    assert (frames.counts.restarts, frames.counts.lost) == (0, 0)


def test_a_wrong_rate_is_an_error_that_names_sim_rate_hz() -> None:
    frames = Frames(400)
    for k in range(SETTLING):  # the firmware begins with 1200 Hz, whatever its parameter
        frames.judge(packet(k, rate=1200), "a", 0.0)
    with pytest.raises(RunError, match=r"come at 1200 Hz, but the period of 2\.5 ms is 400 Hz; .*SIM_RATE_HZ to 400"):
        frames.judge(packet(SETTLING, rate=1200), "a", 0.0)
    with pytest.raises(RunError, match=r"401 Hz \(it follows .* 1 Hz .*SIM_RATE_HZ to 400"):
        at_frame(10).judge(packet(11, rate=401), "a", 0.0)
    frames = at_frame(10)
    with pytest.raises(RunError, match="come at 0 Hz"):
        frames.judge(packet(11, rate=0), "a", 0.0)
