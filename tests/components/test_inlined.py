"""Functions of kernels are compiled as parts of what calls them; Python calls each through one of its own."""

from __future__ import annotations

from pathlib import Path

import numba
import numpy as np
import pytest
from helpers import python
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
    assert functions.ring(130.0) == 2.0
    assert functions.has("step") and not functions.has("stop")
    with pytest.raises(AttributeError, match="has no function stop"):
        functions.stop()


@pytest.mark.evidence
def test_a_numba_that_nobody_has_tried_compiles_them_by_itself_to_the_same_bits(tmp_path: Path) -> None:
    code = """
import sys
import numba
if sys.argv[1] == "new":
    numba.version_info = (9, 0, 0)
    sys.modules["rovbrush.components.python.parts"] = None  # whose imports may be gone by then
from rovbrush.components.python.component import component_class
motor = component_class("dc_motor")(instance_name="motor")
motor.set_real([motor.memory.index["V_in"]], [12.0])
motor.enter_initialization_mode()
motor.exit_initialization_mode()
assert all(motor.do_step(k * 1e-3, 1e-3) for k in range(20))
print([value.hex() for value in motor.memory.y.tolist()])
"""
    seen = [python(code, one, timeout=300.0, ROVBRUSH_CACHE=str(tmp_path / one)) for one in ("new", "known")]
    assert not any(done.returncode for done in seen), seen[0].stderr
    assert seen[0].stdout == seen[1].stdout and "0x" in seen[0].stdout
