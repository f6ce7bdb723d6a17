"""FMI 3.0 with event mode, driven by hand: impacts, time events, periodic, countdown and triggered clocks."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import pytest
from clock_build import built, clocked
from native_build import needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.base import State
from rovbrush.orchestrator.participant.here.event_mode import EventModeInstance
from rovbrush.orchestrator.participant.timetable import Timetable

pytestmark = needs_gcc


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("clocks"))


def begun(path: Path, stop: float = 100.0, **values: float) -> EventModeInstance:
    """In event mode, behind its initialization."""
    instance = EventModeInstance(Fmu.open(path), path.stem)
    instance.set_up(stop)
    instance.set_all(values)
    instance.enter_initialization()
    instance.exit_initialization()
    return instance


def impacts(count: int, g: float = 9.81, e: float = 0.7) -> list[float]:
    """When a ball that falls from 1 m hits the ground."""
    tau = math.sqrt(2 / g)
    return [tau * (1 + 2 * sum(e**k for k in range(1, i + 1))) for i in range(count)]


def test_steps_end_at_the_impacts_of_the_closed_form(fmus: Path) -> None:
    ball = begun(fmus / "ball.fmu")
    ball.update_states()
    ball.leave_event_mode()
    time, found = 0.0, []
    while len(found) < 20:
        reached = ball.step_once(time, 0.01)
        time = reached.time
        if reached.event:
            found.append(time)
            ball.enter_event_mode()
            assert not ball.update_states().again
            ball.leave_event_mode()
    assert found == pytest.approx(impacts(20), abs=1e-12) and ball.get("bounces") == 20
    assert ball.close() == ""


def test_a_step_of_an_fmu_alone_goes_on_over_its_events(fmus: Path) -> None:
    ball, times = begun(fmus / "ball.fmu"), impacts(8)
    ball.step(0.0, times[7] + 1e-6)
    assert ball.get("bounces") == 8 and ball.get("hit") == pytest.approx(times[7], abs=1e-12)
    square = begun(fmus / "square.fmu")
    for k in range(100):
        square.step(k * 0.1, 0.1)
    assert square.get("changes") == 40 and square.get("y") == 1.0


def test_a_periodic_clock_ticks_at_whole_multiples_of_its_exact_period(fmus: Path) -> None:
    controller = begun(fmus / "controller.fmu", k=6.0)
    assert controller.timetable.periods == {"tick": Fraction(1, 60)}
    x, seen = 0.0, []
    for k in range(600):
        instant = Fraction(k, 60)
        assert controller.timetable.due() == instant
        if k:
            controller.enter_event_mode()
        assert controller.timetable.ticking(instant) == ["tick"]
        controller.tick(["tick"])
        controller.set("y", x)
        u = controller.get("u")
        assert (controller.get("ticks"), controller.get("at")) == (k + 1, float(instant))
        controller.update_states()
        controller.timetable.ticked(["tick"])
        controller.leave_event_mode()
        seen.append(x)
        x += u / 60
        reached = controller.step_once(float(instant), float(instant + Fraction(1, 60)) - float(instant))
        assert reached == (pytest.approx(float(instant + Fraction(1, 60)), abs=1e-15), False)
        controller.enter_event_mode()
        controller.leave_event_mode()
    assert seen == pytest.approx([1 - 0.9**k for k in range(600)], abs=1e-12)


def test_a_clocked_variable_is_refused_while_its_clock_does_not_tick(fmus: Path) -> None:
    controller = begun(fmus / "controller.fmu")
    controller.tick(["tick"])
    assert controller.get("u") == 1.0
    controller.update_states()
    for call in (lambda: controller.get("u"), lambda: controller.set("y", 1.0)):
        with pytest.raises(FmuError, match="has a clock that does not tick"):
            call()
    controller.close()


def test_a_countdown_begins_with_every_tick(fmus: Path) -> None:
    countdown, time = begun(fmus / "countdown.fmu"), 0.0
    for k in range(50):
        exact = sum((Fraction(100 + i, 1000) for i in range(k + 1)), Fraction(0))
        if countdown.state is State.EVENTS:
            countdown.settle(Fraction(repr(time)))
        assert countdown.timetable.due() == exact
        countdown.step(time, float(exact) - time)
        time = float(exact)
    assert countdown.timetable.next == {"fire": exact + Fraction(150, 1000)}


def test_a_countdown_is_not_known_before_it_is_armed(fmus: Path) -> None:
    countdown = begun(fmus / "countdown.fmu", first=0)
    assert countdown.timetable.due() is None
    countdown.step(0.0, 0.5)
    countdown.enter_event_mode()
    countdown.tick(["arm"])
    countdown.update_states()
    countdown.timetable.ask(Fraction(1, 2))
    assert countdown.timetable.due() == Fraction(525, 1000)
    countdown.leave_event_mode()
    countdown.step(0.5, 0.5)
    assert countdown.timetable.due() is None
    countdown.enter_event_mode()
    countdown.tick(["fire"])
    assert countdown.get("fired") == 2
    assert countdown.close() == ""


def test_what_is_ahead_goes_with_a_saved_state(fmus: Path) -> None:
    countdown, square = begun(fmus / "countdown.fmu"), begun(fmus / "square.fmu")
    for instance, name in ((countdown, "fire"), (square, "")):
        instance.step(0.0, 0.35)
        kept = instance.save()
        instance.step(0.35, 0.35)
        instance.restore(instance.deserialize(instance.serialize(kept)))
        if name:
            assert instance.timetable.due() == Fraction(406, 1000)
        else:
            assert instance.next_event == 0.5
        instance.step(0.35, 0.35)
    assert square.get("changes") == 2


def test_an_output_clock_ticks_where_its_step_ends_and_a_triggered_input_takes_its_value(fmus: Path) -> None:
    producer, consumer = begun(fmus / "producer.fmu"), begun(fmus / "consumer.fmu")
    for instance in (producer, consumer):
        instance.update_states()
        instance.leave_event_mode()
    time = 0.0
    for k in range(1, 31):
        reached = producer.step_once(time, 10.0)
        assert reached == (pytest.approx(k / 3, abs=1e-15), True)
        consumer.step_once(time, reached.time - time)
        time = reached.time
        producer.enter_event_mode()
        consumer.enter_event_mode()
        assert producer.ticking(["crossing"]) == [True]
        consumer.tick(["sample"])
        consumer.set("v", producer.get("count"))
        assert (consumer.get("ticks"), consumer.get("sum")) == (k, k * (k + 1) // 2)
        for instance in (producer, consumer):
            instance.update_states()
            instance.leave_event_mode()


@pytest.mark.parametrize(
    ("variability", "stated", "calculated", "period"),
    [
        ("fixed", 'intervalDecimal="0.1"', False, "1/10"),
        ("fixed", 'supportsFraction="true"', True, "1/60"),
        ("calculated", 'supportsFraction="true"', True, "1/60"),
        ("tunable", 'supportsFraction="true"', True, "1/60"),
        ("tunable", "", True, "0.016666666666666666"),  # the shortest decimal number that is the double
    ],
)
def test_an_interval_that_the_description_leaves_open_is_asked_for(
    variability: str, stated: str, calculated: bool, period: str, tmp_path: Path
) -> None:
    tick = f'intervalVariability="{variability}" {stated}'
    path = clocked(tmp_path / "c.fmu", "controller", tick=tick, calculated=calculated)
    assert begun(path).timetable.periods == {"tick": Fraction(period)}


def test_an_interval_that_is_the_importers_to_choose_is_told_to_the_fmu(tmp_path: Path) -> None:
    for fractions, chosen in (("", Fraction(1, 8)), ('supportsFraction="true"', Fraction(1, 7))):
        tick = f'intervalVariability="fixed" intervalDecimal="0.1" {fractions}'
        path = clocked(tmp_path / f"c{len(fractions)}.fmu", "controller", tick=tick)
        instance = EventModeInstance(Fmu.open(path), "chosen")
        instance.begin(1.0)
        timetable = Timetable(instance, instance.fmu.clocks.values(), {"tick": chosen})
        timetable.begin(Fraction(0))
        assert timetable.periods == {"tick": chosen} and instance.interval("tick") == (1, chosen)


def test_calls_keep_to_the_states_of_event_mode(fmus: Path) -> None:
    controller = begun(fmus / "controller.fmu")
    with pytest.raises(FmuError, match="cannot step from t = 0 s while it is in event mode"):
        controller.step_once(0.0, 1.0)
    controller.update_states()
    controller.leave_event_mode()
    for what, call in (
        ("tick clock tick", lambda: controller.tick(["tick"])),
        ("update its discrete states", controller.update_states),
        ("enter step mode", controller.leave_event_mode),
        ("ask for the interval of clock tick", lambda: controller.interval("tick")),
    ):
        with pytest.raises(FmuError, match=f"cannot {what} while it is between two steps"):
            call()
    controller.enter_event_mode()
    assert controller.close() == "" and controller.state is State.FREED
