"""Signal dictionaries: what one component writes, all others that refer to the dictionary read."""

from __future__ import annotations

import math

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.ssp.files import rules
from ssp_files import GAINS, XMLNS, Read, component, connection, connectors, document, system


def entries(*names: str, namespaces: str = "") -> str:
    rows = "".join(
        f'<ssb:DictionaryEntry name="{name}"><ssc:Real{f" unit={unit!r}" if unit else ""}/></ssb:DictionaryEntry>'
        for name, _, unit in (text.partition("|") for text in names)
    )
    return f'<ssb:SignalDictionary {namespaces} version="1.0">{rows}</ssb:SignalDictionary>'


def dictionary(content: str = "", source: str = "", name: str = "bus") -> str:
    more = f' source="{source}"' if source else ""
    return (
        f'<ssd:SignalDictionaries><ssd:SignalDictionary name="{name}"{more}>{content}</ssd:SignalDictionary>'
        f"</ssd:SignalDictionaries>"
    )


def reference(name: str, *signals: str, to: str = "bus") -> str:
    own = connectors(**dict.fromkeys(signals, "inout")) if signals else ""
    return f'<ssd:SignalDictionaryReference name="{name}" dictionary="{to}">{own}</ssd:SignalDictionaryReference>'


WIRES = connection("a.y", "one.speed") + connection("one.speed", "b.u")


@pytest.mark.parametrize("source", ["", "resources/bus.ssb"])
def test_a_signal_goes_through_the_dictionary(source: str, read: Read) -> None:
    inside = "" if source else entries("speed")
    top = system(GAINS + reference("one", "speed"), WIRES, tail=dictionary(inside, source))
    found = read(document(top), {"resources/bus.ssb": entries("speed", namespaces=XMLNS)})
    assert [(c.label, c.gain) for c in found.connections] == [("a.y -> b.u", 1.0)] and not found.breaches


def test_all_references_to_a_dictionary_share_its_signals_in_inner_systems_too(read: Read) -> None:
    inner = system(component("b", "gain") + reference("there", "speed"), connection("b.u", "there.speed"), name="inner")
    top = system(
        component("a", "gain") + reference("one", "speed") + reference("two", "speed") + component("c", "gain") + inner,
        connection("one.speed", "a.y") + connection("two.speed", "c.u"),
        tail=dictionary(entries("speed")),
    )
    assert sorted(c.label for c in read(document(top)).connections) == ["a.y -> c.u", "a.y -> inner_b.u"]


def test_an_inner_dictionary_of_the_same_name_is_another_one(read: Read) -> None:
    own = dictionary(entries("speed"))
    inner = system(
        component("b", "gain") + reference("there", "speed"), connection("b.u", "there.speed"), tail=own, name="inner"
    )
    top = system(component("a", "gain") + reference("one", "speed") + inner, connection("a.y", "one.speed"), tail=own)
    assert read(document(top)).connections == ()


def test_units_convert_into_a_dictionary_and_out_of_it(read: Read) -> None:
    factor = '<ssc:LinearTransformation offset="50"/>'  # 50 percent more, in the dictionary's unit
    wires = connection("a.y", "one.speed", factor) + connection("one.speed", "b.u")
    found = read(document(system(GAINS + reference("one"), wires, tail=dictionary(entries("speed|percent")))))
    (c,) = found.connections
    assert math.isclose(c.gain, 1.0, rel_tol=1e-15) and math.isclose(c.offset, 0.5, rel_tol=1e-15)


def test_two_that_write_one_signal_are_an_error(read: Read) -> None:
    wires = connection("a.y", "one.speed") + connection("b.y", "two.speed")
    top = system(GAINS + reference("one") + reference("two"), wires, tail=dictionary(entries("speed")))
    with pytest.raises(InputError, match=r"b\.y -> two\.speed: the second connection to the same connector"):
        read(document(top))


def test_what_the_dictionary_does_not_have_is_noted_or_an_error(read: Read) -> None:
    found = read(document(system(GAINS + reference("one", "speed"), WIRES, tail=dictionary(entries()))))
    assert {note.rule for note in found.breaches} >= {rules.NO_SIGNAL} and len(found.connections) == 1
    with pytest.raises(InputError, match=r"'bus' has no connector 'speed'"):
        read(document(system(GAINS + reference("one"), WIRES, tail=dictionary(entries()))))
    with pytest.raises(InputError, match=r"there is no signal dictionary 'buss'; did you mean 'bus'\?"):
        read(document(system(GAINS + reference("one", to="buss"), WIRES, tail=dictionary(entries("speed")))))
    with pytest.raises(InputError, match=r"no file 'lost\.ssb' in case\.ssp"):
        read(document(system(GAINS + reference("one"), WIRES, tail=dictionary(source="lost.ssb"))))
