"""The time of a kernel under Numba is measured with the values that it is given."""

from __future__ import annotations

import pytest
from rovbrush.components.python.timing import seconds_per_step


def test_a_kernel_is_timed_with_its_values() -> None:
    assert 0.0 < seconds_per_step("dc_motor", {"V_in": 12.0, "R": 0.1}, 1e-3, 100) < 1.0


def test_a_name_that_is_no_variable_is_refused() -> None:
    with pytest.raises(ValueError, match="V_inn"):
        seconds_per_step("dc_motor", {"V_inn": 12.0}, 1e-3, 10)


def test_array_elements_are_named_as_fmi_2_names_them() -> None:
    assert seconds_per_step("tool_frame", {"x_tool[3]": 0.5}, 1e-3, 10) > 0.0
