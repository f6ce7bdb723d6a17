"""What stands in files where nobody expects it: strange values and words of TOML, XML and CSV."""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass

_TOML = [
    "0", "-1", "1.5", "1e400", "nan", "-inf", '""', '" "', '"0 s"', '"1/3 s"', '"1e30000000 s"', '"1e300 s"', "[]",
    "{}", "[[]]", "[1, [2]]", "{ a = { b = 1 } }", "true", '"a.b.c"', '"a.y -> a.u"', '"../x"', '"\\u0000"',
    '"\\uFFFF"', "1979-05-27", "07:32:00", "9" * 400, "9" * 5000, "0x" + "f" * 600, "[" * 40 + "]" * 40,
    "[" * 2000 + "]" * 2000, '"' + "x" * 5000 + '"', ".".join("a" * 90), '"' + "[" * 50 + '"', "{ csv = 3 }",
    '{ csv = "t.csv" }', "{ time = [0, 1], values = [[1], 2] }", '"*"', '"mean"', '"ratio a.y"', "[components.a]",
    "[[bonds]]", "[iteration]", "#", "\n", "=", "]", "}", '"""', "'''",
]  # fmt: skip
_XML = [
    '""', '" "', '"-1"', '"nan"', '"1e400"', '"1e-400"', '"true"', '"a.b"', '"../x"', '"a%00b"', '"http://[x"',
    '"//x/y"', '"#a"', f'"{"9" * 400}"', f'"{"9" * 5000}"', f'"{"x" * 5000}"', '"&#0;"', '"&amp;"', '"&unknown;"',
    '"2.0"', '"1.0"', '"3.0"', '"input"', '"output"', '"parameter"', '"calculatedParameter"', '"independent"',
    '"structuralParameter"', '"exact"', '"any"', '"ModelExchange"', '"a"', '"b"', '"toy"', '"u"', '"y"', '"kg"',
    '"deg"', '"N.m"', "<Real/>", "<Annotations/>", "<", ">", "</a>", "<a>" * 300, "<!-- -->", "<![CDATA[x]]>",
    '<!DOCTYPE a [<!ENTITY e "x">]>', "<?x?>", "xmlns", "\u2028", "é",
]  # fmt: skip
_CSV = [
    "0", "-1", "1e400", "nan", "inf", "", " ", "x", '"', '""', '"a\nb"', ",", ",,", ";", "\n", "\r", "\r\n", "\0",
    "\ufeff", "1e-400", "9" * 400, "9" * 5000, "time", "time [ms]", "a.u", "a.u [m]", "a.u [", "a.none", "true",
    "true", "1/3", "0x10", "1_000", "١", "a" * 140_000,
]  # fmt: skip


@dataclass(frozen=True)
class Kind:
    """Of a text: what may stand in the place of any word, what in the place of a value, and where values stand."""

    strangers: list[str]
    values: list[str]
    places: re.Pattern[str]


def _is_toml(text: str) -> bool:
    try:
        tomllib.loads(f"x = {text}\n")
    except (ValueError, RecursionError):
        return False
    return True


TOML = Kind(
    _TOML, [*filter(_is_toml, _TOML)], re.compile(r'(?<=[=\[,] )"[^"\n]*"|(?<== )[\w.+-]+|(?<=\[)"[^"\n]*"(?!\])')
)
XML = Kind(_XML, [x for x in _XML if x[0] == '"' and "&#0" not in x and "&u" not in x], re.compile(r'"[^"\n]*"'))
CSV = Kind(_CSV, [x for x in _CSV if not set(x) & set(',\n\r"')], re.compile(r"[^,\n]+"))
