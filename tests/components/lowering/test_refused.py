"""What kernels may not use: each has an error that says what, with file and line."""

from __future__ import annotations

import pytest
from rovbrush.components.lowering.errors import KernelError
from sample_kernel import lower_text

RATES = """
def rates(x: State) -> Rates:
    return Rates(x.a, x.b)

"""
REFUSED = {
    "unknown field": ("y.first = x.aa", "State has no field 'aa'; did you mean 'a'?"),
    "unknown field written": ("y.frst = 1.0", "Outputs has no field 'frst'; did you mean 'first'?"),
    "attribute of an attribute": (
        "y.first = x.tip.F_n", "x.tip is a field; give it to a function that takes such a record"),
    "no record before the dot": ("y.first = h.real", "only a record stands before a dot, and h is none"),
    "alias": ("z = x", "the record x is no value: name a field of it, or give it to a function"),
    "record overwritten": ("x = 1.0", "the record x stays what it is: assign to its fields"),
    "record in an expression": ("y.first = x + 1.0", "the record x is no value"),
    "record as an array": ("y.first = x[0]", "the record x has fields, not elements"),
    "array without an index": ("y.first = u.v", "u.v is an array: name an element of it, or give it to a function"),
    "array overwritten": ("y.three = 1.0", "y.three is no scalar: assign to its elements"),
    "record overwritten in a record": ("x.tip = 1.0", "x.tip is no scalar"),
    "element of a scalar": ("y.first = p.k[0]", "p.k has no elements"),
    "slice": ("y.first = u.v[0:2]", "a kernel takes single elements, no slices"),
    "parameter written": ("p.k = 1.0", "p.k is a parameter, which no kernel changes"),
    "input written": ("u.v[0] = 1.0", "u.v is an input, which no kernel changes"),
    "method": ("y.first = x.total()", "x.total is no function; records have no methods"),
    "record made inside": ("y.first = rates(x).da", "only a record stands before a dot, and rates(x) is none"),
    "record made in an argument": ("y.first = abs(rates(x))", "a record is made alone on the right side"),
    "record under two names": ("a = b = rates(x)", "a record is made under one name"),
    "record in parts": ("a, b = rates(x)", "a record is made under one name"),
    "record of another class later": ("a = rates(x)\n    a = 1.0", "a is a Rates and stays one"),
    "record without a field": ("a = Rates(1.0)", "Rates is made of da, db, in this order"),
    "record with fields in another order": ("a = Rates(db=1.0, da=2.0)", "Rates is made of da, db, in this order"),
    "record of arrays made here": (
        "a = Tip(1.0, 2.0, 3.0, 4.0)", "Tip.r is an array; a record made here has scalars only"),
    "name of a lowered field": ("x_a = 1.0", "x_a is what x.a becomes; give the variable another name"),
    "unknown function": ("y.first = ratez(x)", "there is no function ratez; did you mean 'rates'?"),
    "named argument": ("y.first = scale(a=1.0)", "scale is called with values in order, without names"),
    "too few arguments": ("y.first = scale()", "scale takes 1 values (a), not 0"),
    "another record": ("a = rates(y)", "rates takes a State as x, and y is a Outputs"),
    "no record": ("a = rates(h)", "rates takes a State as x, and h is no record"),
    "number for an array": ("fill(h + 1.0)", "fill takes an array as v, and h + 1.0 is none"),
    "record of arrays for an array": ("fill(x)", "x is a record of several arrays, and fill takes one array as v"),
    "array inside a packed record": ("fill(y.three)", "y.three lies inside a packed record"),
    "same record twice": ("mix(x, x)", "x is given twice, and mix writes to it"),
    "record and array at once": ("press(x.tip, x.tip)", "x.tip is given twice, as a record and as an array"),
    "array of a record beside it": ("inside(x, x.eta)", "x.eta is given twice, also in x, of which inside uses it"),
    "rows as an array": ("fill(x.rows)", "x.rows is a record of rows, which no function takes as one array"),
    "record made here is written elsewhere": (
        "a = rates(x)\n    turn(a)", "turn writes to r, which a record made here cannot"),
    "list": ("a = [1.0]", "a kernel has no list"),
    "dictionary": ("a = {}", "a kernel has no dict"),
    "comprehension": ("a = [i for i in range(3)]", "a kernel has no list comp"),
    "lambda": ("a = lambda b: b", "a kernel has no lambda"),
    "text with values": ("a = f'{h}'", "a kernel has no joined str"),
    "try": ("try:\n        y.first = 1.0\n    except ValueError:\n        pass", "a kernel has no try"),
    "with": ("with h:\n        pass", "a kernel has no with"),
    "function in a function": ("def inner(a: float) -> float:\n        return a", "a kernel has no function def"),
    "class": ("class A:\n        pass", "a kernel has no class def"),
    "global": ("global g", "a kernel has no global"),
    "import": ("from math import sin", "a kernel has no import from"),
    "delete": ("del h", "a kernel has no delete"),
    "annotated assignment": ("a: float = 1.0", "a kernel has no ann assign"),
    "two assignments in one": ("a = b = 1.0", "one `=` per line"),
    "walrus": ("y.first = (a := 1.0)", "a kernel has no named expr"),
    "loop over an array": ("for v in u.v:\n        pass", "a kernel counts: `for i in range(n)`"),
    "line that does nothing": ("x.a", "this line does nothing"),
    "starred": ("y.first = scale(*u.v)", "a kernel has no starred"),
}  # fmt: skip
OTHERS = (
    RATES
    + """
def scale(a: float) -> float:
    return 2.0 * a

def fill(v: Vector) -> None:
    v[0] = 1.0

def mix(one: State, other: State) -> None:
    one.a = other.b

def press(t: Tip, v: Vector) -> None:
    t.F_n = v[0]

def inside(one: State, m: Matrix) -> None:
    one.eta[0, 0] = m[0, 1]

def turn(r: Rates) -> None:
    r.da = 0.0

"""
)


@pytest.mark.parametrize(("line", "said"), REFUSED.values(), ids=list(REFUSED))
def test_what_is_refused_is_said_with_file_and_line(line: str, said: str) -> None:
    head = "def step(h: float, p: Parameters, u: Inputs, x: State, y: Outputs) -> None:\n"
    used = "    y.last = p.k + u.u_1 + x.b + h\n"
    with pytest.raises(KernelError) as caught:
        lower_text(OTHERS + head + used + f"    {line}\n")
    text = str(caught.value)
    assert said in text
    place, _, number = text.split(": ", 1)[0].partition(":")
    assert place == "somewhere/kernel.py"
    first = OTHERS.count("\n") + 1  # of step
    assert first <= int(number) <= first + 2 + line.count("\n")


SIGNATURES = {
    "no type": ("def f(a) -> float:\n    return a\n", "parameter a needs a type"),
    "unknown type": ("def f(a: complex) -> float:\n    return 1.0\n", "'complex' is no type of a kernel"),
    "misspelt record": (
        "def f(x: Stat) -> float:\n    return x.a\n", "'Stat' is no type of a kernel; did you mean 'State'?"),
    "default": ("def f(a: float = 1.0) -> float:\n    return a\n", "f takes plain parameters only"),
    "any number of values": ("def f(*a: float) -> float:\n    return 1.0\n", "f takes plain parameters only"),
    "record that is not used": ("def f(x: State) -> float:\n    return 1.0\n", "f uses nothing of x; leave it out"),
    "record handed back": (
        "def f(x: State) -> State:\n    x.a = 1.0\n    return x\n", "the record x is the caller's already"),
    "record unsaid": ("def f(a: float) -> float:\n    return Rates(a, a)\n", "a Rates is returned; say so: `-> Rates`"),
    "scalar for a record": ("def f(a: float) -> Rates:\n    return a\n", "return a Rates that is made here"),
    "record of a function handed on": (
        RATES + "def f(x: State) -> Rates:\n    return rates(x)\n", "return a Rates that is made here"),
    "same name twice": ("def f(a: float) -> float:\n    return a\n\ndef f(b: float) -> float:\n    return b\n",
                        "there is a function f in kernel.py already"),
    "parameter made a record": (
        "def f(a: float) -> float:\n    a = Rates(1.0, 2.0)\n    return a.da\n", "a is a parameter"),
}  # fmt: skip


@pytest.mark.parametrize(("text", "said"), SIGNATURES.values(), ids=list(SIGNATURES))
def test_signatures_are_refused_with_file_and_line(text: str, said: str) -> None:
    with pytest.raises(KernelError, match=r"^somewhere/kernel\.py:\d+: ") as caught:
        lower_text(text)
    assert said in str(caught.value)
