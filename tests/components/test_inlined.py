"""Functions of kernels are compiled as parts of what calls them; Python calls each through one of its own."""

from __future__ import annotations

import numba
import numpy as np
import pytest
from lives import component
from rovbrush.components.python.kernels import compiled


def test_functions_inside_a_kernel_make_no_machine_code_of_their_own() -> None:
    functions = compiled(component("rov_vehicle").kernel)
    z = np.zeros(18)
    z[3:7] = 2.0, 0.0, 0.0, 0.0
    functions.normalize(z)
    assert z[3:7].tolist() == [1.0, 0.0, 0.0, 0.0]
    part = functions.inner["normalize"]
    part.compile((numba.typeof(z),))
    for made in part.overloads.values():
        assert "cpython" not in made.library.get_llvm_str() and "cfunc" not in made.library.get_llvm_str()
    with pytest.raises(TypeError):
        part(z[:0], z)


def test_python_gets_what_a_function_returns_and_an_error_for_one_that_there_is_not() -> None:
    functions = compiled(component("rov_vehicle").kernel)
    assert functions.thrust_of(0.5, 40.0, 30.0) == 10.0
    assert functions.has("step") and not functions.has("stop")
    with pytest.raises(AttributeError, match="has no function stop"):
        functions.stop()
