"""One viewer drives; others look on until nobody does."""

from __future__ import annotations

from rovbrush.orchestrator.live.viewers import Viewers


def two() -> Viewers:
    viewers = Viewers(grace=5.0)
    viewers.arrive("a", 0.0)
    viewers.arrive("b", 1.0)
    return viewers


def test_the_first_viewer_drives_and_the_second_looks_on() -> None:
    viewers = two()
    assert viewers.drives("a") and not viewers.drives("b")
    assert viewers.driver == "viewer 1" and viewers.here == 2


def test_nobody_takes_over_from_one_who_drives() -> None:
    viewers = two()
    assert viewers.take("b", 2.0).startswith("viewer 1 drives")
    assert viewers.drives("a")


def test_a_viewer_takes_over_when_the_driver_lets_go() -> None:
    viewers = two()
    viewers.release("a")
    assert viewers.driver == ""
    assert viewers.take("b", 2.0) == "" and viewers.drives("b")
    assert viewers.take("a", 2.0).startswith("viewer 2 drives")


def test_a_reload_keeps_the_role() -> None:
    viewers = two()
    viewers.leave("a", 10.0)
    viewers.look(14.0)
    viewers.arrive("a", 14.0)
    viewers.look(30.0)
    assert viewers.drives("a") and viewers.name("a") == "viewer 1"


def test_a_browser_that_is_gone_frees_the_role_after_a_while() -> None:
    viewers = two()
    viewers.leave("a", 10.0)
    assert viewers.take("b", 12.0) != ""
    assert viewers.take("b", 16.0) == "" and viewers.drives("b")


def test_a_page_that_is_opened_twice_stays_until_both_are_gone() -> None:
    viewers = two()
    viewers.arrive("a", 2.0)
    viewers.leave("a", 3.0)
    viewers.look(100.0)
    assert viewers.drives("a")


def test_whoever_comes_to_an_empty_page_drives() -> None:
    viewers = two()
    for key in "ab":
        viewers.leave(key, 5.0)
    viewers.arrive("c", 20.0)
    assert viewers.drives("c")


def test_a_page_that_is_not_connected_cannot_drive() -> None:
    viewers = Viewers()
    assert "load it again" in viewers.take("z", 0.0) and not viewers.drives("")
