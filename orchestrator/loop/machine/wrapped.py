"""What Numba has compiled of the loop as text for LLVM that needs nothing of Numba: for libraries and for objects."""

from __future__ import annotations

import re
from typing import Any

from ..cells import GAVE_UP

ENTRY, ONE = "rovbrush_loop", "rovbrush_loop_one"  # names of the functions: the loop; and with its numbers in memory
# Numba counts the users of arrays that it has made; the loop makes none.
NOTHING_TO_FREE = "NRT_MemInfo_call_dtor"
_TEXT = f"""
define i64 @{ENTRY}(i64 %a, i64 %b, i64 %c, i64 %d, i64 %e, i64 %f) {{
  %result = alloca i64
  %raised = alloca ptr
  store i64 {GAVE_UP}, ptr %result
  %status = call i32 @LOOP(ptr %result, ptr %raised, i64 %a, i64 %b, i64 %c, i64 %d, i64 %e, i64 %f)
  %value = load i64, ptr %result
  %good = icmp eq i32 %status, 0
  %answer = select i1 %good, i64 %value, i64 {GAVE_UP}
  ret i64 %answer
}}
"""
_ONE = """
define i64 @ONE(i64 %at) {
  %p = inttoptr i64 %at to ptr
LOADS
  %answer = call i64 @ENTRY(i64 %v0, i64 %v1, i64 %v2, i64 %v3, i64 %v4, i64 %v5)
  ret i64 %answer
}
"""
_LOAD = """  %p{k} = getelementptr i64, ptr %p, i64 {k}
  %v{k} = load i64, ptr %p{k}"""


def text_of(made: Any) -> str:
    """Of Numba's object of the loop, freshly compiled: ENTRY and ONE, without what Numba calls it by."""
    text = made._library.get_llvm_str()
    wrapper, native = made._wrapper_name, made._wrapper_name.removeprefix("cfunc.")
    text = re.sub(rf"(?ms)^define [^\n]*@{re.escape(wrapper)}\(.*?^}}\n", "", text)
    if f"@{native}(" not in text or wrapper in text:
        raise RuntimeError(f"this version of Numba calls the loop otherwise than {native}")
    return text + _TEXT.replace("LOOP", native) + with_its_numbers(ONE, ENTRY)


def with_its_numbers(name: str, entry: str) -> str:
    """A function that takes the six whole numbers of another one out of memory: quicker to call from Python."""
    loads = "\n".join(_LOAD.format(k=k) for k in range(6))
    return _ONE.replace("ONE", name).replace("ENTRY", entry).replace("LOADS", loads)
