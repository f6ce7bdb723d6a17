"""Texts by number: the compiled loop and plain Python agree on each, and a long text costs no more than its bytes."""

from __future__ import annotations

import ctypes
from typing import Any

import numba
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rovbrush.orchestrator.loop import texts
from rovbrush.orchestrator.loop.machine import entry
from rovbrush.orchestrator.loop.texts import ADDRESS, Texts, hash_at, number_of

entry.told_to_compiler()  # of what is compiled here beside the loop

TEXT = st.text(st.characters(exclude_characters="\0", exclude_categories=["Cs"]), max_size=40)


@pytest.fixture(scope="module")
def compiled() -> Any:
    """`number_of` as the compiled loop has it."""

    @numba.njit
    def run(address: int, pool: np.ndarray, index: np.ndarray) -> int:
        return number_of(address, pool, index)

    return run


def test_python_and_the_compiled_loop_give_the_same_numbers_and_tables(compiled: Any) -> None:
    @settings(max_examples=200, deadline=None)
    @given(st.lists(TEXT, max_size=60))
    def same(found: list[str]) -> None:
        plain, fast = Texts(count=40, size=500), Texts(count=40, size=500)
        for text in found:
            buffer = ctypes.create_string_buffer(text.encode())
            number = plain.number(text)
            assert number == compiled(ctypes.addressof(buffer), fast.pool, fast.index)
            assert number < 0 or plain.text(number) == text
        assert np.array_equal(plain.pool, fast.pool)
        assert np.array_equal(np.delete(plain.index, ADDRESS), np.delete(fast.index, ADDRESS))

    same()


@pytest.mark.parametrize("length", [0, 1, texts.BLOCK - 1, texts.BLOCK, texts.BLOCK + 1, 3 * texts.BLOCK + 7])
def test_the_hash_of_a_long_text_is_that_of_its_bytes(length: int) -> None:
    content = np.random.default_rng(length).integers(1, 256, length).astype(np.uint8).tobytes()
    expected = 0
    for byte in content:
        expected = (expected * texts.FACTOR + byte) & texts.BITS
    buffer = ctypes.create_string_buffer(content)
    assert hash_at(ctypes.addressof(buffer), length) == expected


def test_texts_that_differ_in_their_last_byte_only_have_two_numbers(compiled: Any) -> None:
    known = Texts()
    long = "x" * 5_000_000
    assert [known.number(long + end) for end in ("", "a", "b", "a", "")] == [1, 2, 3, 2, 1]
    assert known.text(3) == long + "b"


def test_a_text_for_which_there_is_no_room_is_told() -> None:
    known = Texts(count=10, size=100)
    assert known.number("x" * 98) == 1 and known.number("y") == -1 and known.number("x" * 98) == 1


def test_bytes_have_numbers_whatever_is_in_them() -> None:
    @numba.njit
    def run(address: int, length: int, pool: np.ndarray, index: np.ndarray) -> int:
        return texts.number_of_bytes(address, length, pool, index)

    @settings(max_examples=200, deadline=None)
    @given(st.lists(st.binary(max_size=12), max_size=60))
    def same(found: list[bytes]) -> None:
        plain, fast = Texts(count=40, size=500), Texts(count=40, size=500)
        known: dict[bytes, int] = {}
        for content in found:
            buffer = ctypes.create_string_buffer(content, len(content) + 1)
            number = plain.number_of_bytes(content)
            assert number == run(ctypes.addressof(buffer), len(content), fast.pool, fast.index)
            if number >= 0:
                assert plain.bytes(number) == content and known.setdefault(content, number) == number
        assert len(set(known.values())) == len(known)
        assert np.array_equal(plain.pool, fast.pool)

    same()


def test_a_text_is_its_bytes_and_what_goes_on_behind_a_zero_is_another() -> None:
    store = Texts()
    longer = store.number_of_bytes(b"ab\0c")
    assert store.number("ab") != longer and store.number("ab") == store.number_of_bytes(b"ab")
    assert store.number_of_bytes(b"") == store.number("") == 0 and store.bytes(longer) == b"ab\0c"
    assert store.number_of_bytes(b"\0") not in (0, longer)
