"""Names and literals of C: identifiers of components, cells and files, and numbers with all of their digits."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from ...plan.plan import Plan
from .own_names import own_names

WORDS = (
    "auto break case char const continue default do double else enum extern float for goto if inline int long register "
    "restrict return short signed sizeof static struct switch typedef union unsigned void volatile while main s z w at "
    "and or not xor class new delete this template t h v x n tail total found sent again slope curvature value seconds "
    "status_ k k_"
)
KEYWORDS = frozenset(re.findall(r"\w+", WORDS))
# What a system must not be called in C: headers, files that Windows does not have, functions and types of libraries.
TAKEN = (
    "assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg "
    "stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string strings tgmath threads time uchar wchar wctype "
    "windows dlfcn memory malloc sched unistd aux con nul prn bool true false NULL NAN INFINITY EOF stdin stdout "
    "stderr abort abs acos asin atan atexit atof atoi atol bind bsearch calloc ceil clock close cos cosh exit exp "
    "fabs fclose feof ferror fflush floor fmax fmin fmod fopen fork fprintf fputc fputs fread free frexp fscanf "
    "fseek ftell fwrite getc getenv index isfinite isinf isnan j0 j1 jn kill labs ldexp link log lround malloc "
    "memchr memcmp memcpy memmove memset modf nan open pause perror pipe pow printf putc puts qsort raise rand "
    "random read realloc remainder remove rename rewind rindex rint round scanf select send sin sinh sleep socket "
    "sprintf sqrt srand sscanf stat stpcpy strcat strchr strcmp strcpy strlen strtod strtok sync system tan tanh "
    "test tmpfile trunc truncate ungetc wait write y0 y1 yn div gamma signbit step linux unix components fmi2 fmi3 "
    "TABLES"
)
LONGEST = 63  # characters of a name of C that count everywhere
RESERVED = KEYWORDS | frozenset(TAKEN.split())


def identifier(text: str) -> str:
    """A text as a name of C: what is no letter, digit or _ becomes one _."""
    name = re.sub(r"\W+", "_", text, flags=re.ASCII).strip("_") or "x"
    return f"{name}_" if name in KEYWORDS else f"_{name}"[name[0].isalpha() :]


def file_identifier(text: str) -> str:
    """A name of C that names of files can begin with."""
    return identifier(identifier(text)[:LONGEST])


def system_identifier(text: str) -> str:
    """The name of a system, of which are called its type, its header and its files."""
    name = file_identifier(text)
    meets = name.lower() in RESERVED or name in RESERVED or name in own_names()
    return f"{name}_" if meets or ("_" in name and FUNCTIONS.fullmatch(name)) else name


def identifiers(texts: Iterable[str], taken: Iterable[str] = ()) -> list[str]:
    """Names of C, each another one."""
    used, found = set(taken), []
    for text in texts:
        name = base = identifier(text)
        number = 2
        while name in used:
            name, number = f"{base}_{number}", number + 1
        used.add(name)
        found.append(name)
    return found


SHORT = (
    "unfit", "not_finite", "asks", "not_converged", "solve_start", "iterate", "held_at", "row_at", "mean_over",
    "read_outputs",
    "paused", "keep", "go_back", "gauge", "choose_step", "estimate",
)  # fmt: skip
# Of a system's own file and the headers that it takes in: functions and types in small letters, macros in large ones.
FUNCTIONS = re.compile(
    r"(begin|end|loop|bring|pass_on|macro_step|together)(_last)?_(\d+|all)?|\w+_t|sent_back|k_|"
    r"(str|mem|wcs|lgamma)\w*_[rsl]|explicit_bzero|[A-Z_0-9]+"
)


def cell_identifiers(texts: Iterable[str], taken: Iterable[str], system: str) -> list[str]:
    """Names of cells, none of which is that of a function beside them, of a macro or of a type."""
    texts = list(texts)
    names = map(identifier, texts)
    meets = (FUNCTIONS.fullmatch(name) or name.startswith(f"{system}_") for name in names)
    free = (f"cell {text}" if found else text for text, found in zip(texts, meets, strict=True))
    return identifiers(free, {*taken, *SHORT, *own_names(), system})


def number(value: float) -> str:
    """A double with all of its digits."""
    if math.isnan(value):
        return "NAN"
    if math.isinf(value):
        return "INFINITY" if value > 0 else "-INFINITY"
    return repr(float(value))


def whole(value: int) -> str:
    """A whole number of 64 bits; those beyond the largest signed one by their bits."""
    value = value - 2**64 if value >= 2**63 else value
    return "INT64_MIN" if value == -(2**63) else f"INT64_C({value})"


def at(ticks: int) -> str:
    """An instant, from the one of the function that it is in."""
    return "at" if ticks == 0 else f"at {'+' if ticks > 0 else '-'} {abs(ticks)}"


def text(value: str) -> str:
    """A text in quotes."""
    escaped = "".join(
        f"\\{c}" if c in '"\\' else c if " " <= c < "\x7f" and c != "?" else "".join(f"\\{b:03o}" for b in c.encode())
        for c in value
    )
    return f'"{escaped}"'


def comment(value: str) -> str:
    """A text inside of a comment."""
    return value.replace("*/", "* /").replace("/*", "/ *").replace("\n", " ")


def cell_words(plan: Plan) -> list[str]:
    """What each cell of the run's vector is, in words: `motor.i`, `previous motor.i`, `loops` by their own names."""
    layout = plan.layout
    words = {slot: ".".join(key) for table in (layout.outputs, layout.inputs) for key, slot in table.items()}
    for before, table in (
        ("previous", layout.previous), ("twice previous", layout.before), ("integral for", layout.integrals),
        ("at the beginning", layout.begins),
    ):  # fmt: skip
        words |= {slot: f"{before} {'.'.join(key)}" for key, slot in table.items()}
    words |= {extra.slot: ".".join(key) for key, extra in layout.extras.items()}
    words |= layout.named
    return [words.get(slot, f"cell {slot}") for slot in range(layout.size)]
