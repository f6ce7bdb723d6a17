"""What must be the same for a run to go on from a checkpoint: FMUs, values, schedule."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any

from ...environment import changes, environment
from ...errors import InputError
from ...files import plain
from ...plan.plan import Plan


def fingerprint(plan: Plan) -> dict[str, Any]:
    """Hashes and values of a plan, ready for JSON."""
    system = plan.system
    operations = hashlib.sha256(plan.cycle.tobytes() + plan.last.tobytes() + plan.coefficients.tobytes()).hexdigest()
    return {
        "components": {
            name: {
                "fmu": component.fmu.path.name, "sha256": component.fmu.digest,
                "choices": component.choices,
                "values": {
                    **plain({**component.fmu.structure, **component.parameters, **component.inputs}),
                    **{name: f"{series} ({series.digest[:12]})" for name, series in component.series.items()},
                },
            } for name, component in system.components.items()
        },
        "tick": str(plan.clock.seconds(1)), "start": str(system.start), "stop": str(system.stop),
        "algorithm": system.algorithm,
        "recorded": [[".".join(key) for key in group.columns] for group in plan.groups],
        "connections": [c.label for c in (*system.connections, *system.clock_connections)],
        "solving": system.choices,
        "schedule": operations,
        **({"scenario": [repr(event) for event in system.events]} if system.events else {}),
        "versions": environment(),
    }  # fmt: skip


def require_unchanged(then: Mapping[str, Any], plan: Plan, force: bool = False) -> None:
    """Raise InputError that says what is not as it was when fingerprint `then` was taken.

    `force`: other versions and another processor are taken.
    """
    now = fingerprint(plan)
    said = "cannot go on from the checkpoint:"
    if list(then["components"]) != list(now["components"]):
        raise InputError(
            f"{said} the components were {', '.join(then['components'])}, now they are {', '.join(now['components'])}"
        )
    for name, new in now["components"].items():
        old = then["components"][name]
        if old["sha256"] != new["sha256"]:
            raise InputError(
                f"{said} component {name}: the FMU has changed, {old['fmu']} had sha256 {old['sha256'][:12]}, "
                f"{new['fmu']} has {new['sha256'][:12]}; put the old one back, or start again"
            )
        for key, chosen in new["choices"].items():
            if old["choices"].get(key) != chosen:
                raise InputError(
                    f"{said} component {name}: {key} was {old['choices'].get(key)}, now it is {chosen}; put it back "
                    f"({plan.system.path.name}), or start again"
                )
        for key in dict.fromkeys([*old["values"], *new["values"]]):
            if old["values"].get(key) != new["values"].get(key):
                raise InputError(
                    f"{said} {name}.{key} was {old['values'].get(key)}, now it is {new['values'].get(key)}; "
                    f"put it back ({plan.system.path.name}), or start again"
                )
    if not force and (differing := changes(then["versions"], now["versions"])):
        raise InputError(
            f"{said} {differing}: the results may differ in their last digits; put it back, or go on nevertheless with "
            f"--force"
        )
    for key, new in now.items():
        if key != "versions" and then.get(key) != new:
            shown = f": was {then.get(key)}, now {new}" if isinstance(new, str) and key != "schedule" else ""
            raise InputError(f"{said} the system has another {key} now{shown}; put it back, or start again")
