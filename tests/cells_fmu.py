"""An FMU whose variables are cells that keep what is set, under any description: what readers must understand."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from xml.sax.saxutils import quoteattr

from native_build import NATIVE
from rovbrush.orchestrator.studies.bench.fmus import native

MODES = '<SimpleType name="Mode"><Enumeration><Item name="off" value="1"/><Item name="on" value="7"/></Enumeration></SimpleType>'  # noqa: E501


def scalar(name: str, reference: int, causality: str = "output", kind: str = "Real", **attributes: object) -> str:
    """One ScalarVariable; `variability`, `initial` and `description` are its own, other attributes its type's."""
    own = {key: attributes.pop(key) for key in ("variability", "initial", "description") if key in attributes}
    usual = "fixed" if causality == "parameter" else "continuous" if kind == "Real" else "discrete"
    own = {"name": name, "valueReference": reference, "causality": causality, "variability": usual, **own}
    texts = ["".join(f" {key}={quoteattr(str(x))}" for key, x in table.items()) for table in (own, attributes)]
    return f"<ScalarVariable{texts[0]}><{kind}{texts[1]}/></ScalarVariable>"


def cells(target: Path, variables: Iterable[str], experiment: str = "", types: str = MODES) -> Path:
    """Real cell 0 is what the sums (cells from 100 on) rest on, cell 1 the time, 2 the stop, 3 the tolerance."""
    known = list(variables)
    outputs = [k + 1 for k, text in enumerate(known) if 'causality="output"' in text]
    identifier = re.sub(r"\W", "_", target.stem)
    xml = native.description2(identifier, known, outputs)
    for flag in ("canGetAndSetFMUstate", "canSerializeFMUstate"):
        xml = xml.replace(f'{flag}="true"', f'{flag}="false"')
    units = sorted({unit for text in known for unit in re.findall(r' unit="([^"]+)"', text)})
    defined = f"<UnitDefinitions>{''.join(f'<Unit name={quoteattr(u)}/>' for u in units)}</UnitDefinitions>\n"
    types = f"<TypeDefinitions>{types}</TypeDefinitions>\n" if types else ""
    experiment = f"<DefaultExperiment {experiment}/>\n" if experiment else ""
    xml = xml.replace("<ModelVariables>", f"{defined if units else ''}{types}{experiment}<ModelVariables>")
    return native.native_fmu(target.with_stem(identifier), [NATIVE / "cells.c"], xml, 2).replace(target)
