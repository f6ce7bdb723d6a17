"""On what outputs and calculated parameters of a whole system depend at its start: InitialUnknowns.

References: FMI 2.0.4, section 2.2.8; FMI 3.0.1, section 2.4.8.
"""

from __future__ import annotations

from .code.exposed import CALCULATED, INPUT, OUTPUT, PARAMETER, TUNABLE
from .prepared import Prepared

Key = tuple[str, str]


def at_the_start(found: Prepared) -> dict[int, list[int]]:
    """For the number of every unknown in what a system shows, the numbers of inputs and parameters that it depends on.

    They are what the FMUs state of their inputs, followed along connections, and all parameters of the components on
    that way.
    """
    system, shown = found.plan.system, found.code.shown
    names = list(system.components)
    answers = {name: component.fmu.feedthrough(initial=True) for name, component in system.components.items()}
    inputs = {name: frozenset(component.fmu.names("input")) for name, component in system.components.items()}
    parameters: dict[str, list[int]] = {name: [] for name in names}
    free: dict[Key, int] = {}
    for number, e in enumerate(shown):
        if e.component >= 0 and e.causality in (PARAMETER, TUNABLE):
            parameters[names[e.component]].append(number)
        elif e.component >= 0 and e.causality == INPUT:
            free[names[e.component], e.name.partition(".")[2]] = number
    made: dict[int, list[int]] = {}
    for number, e in enumerate(shown):
        if e.causality not in (OUTPUT, CALCULATED):
            continue
        waiting: list[Key] = [(names[e.component], e.name.partition(".")[2])] if e.component >= 0 else []
        seen, known = set(waiting), set[int]()
        while waiting:
            name, variable = waiting.pop()
            known.update(parameters[name])
            for own in answers[name].get(variable, inputs[name]):
                driver = system.drivers.get((name, own))
                if driver is None:
                    known.update({free[name, own]} if (name, own) in free else ())
                elif driver.source not in seen:
                    seen.add(driver.source)
                    waiting.append(driver.source)
        made[number] = sorted(known)
    return made
