"""Values of a run that goes on, by name: any can be read, free inputs and tunable parameters can be set."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ...errors import InputError, nearest
from ...fmu.types import Value
from ...participant.base import Participant
from ...plan.plan import Plan
from ...system.values import checked_values, follows_tables
from .memory import Memory


class Access:
    """Between two cycles. Names and errors as of `Session.get` and `Session.set`."""

    def __init__(self, plan: Plan, memory: Memory, instances: Mapping[str, Participant]) -> None:
        self.plan, self.memory, self.instances = plan, memory, instances
        self.driven = {c.target: c.label for c in plan.system.connections}

    def get(self, name: str) -> Any:
        """A value; of an array all values."""
        component, _, variable = self.plan.system.full_name(name).partition(".")
        extra = self.plan.layout.extras.get((component, variable))
        if extra:
            return float(self.memory.z[extra.slot])
        fmu = self._instance("get", name, component).fmu
        scalars = fmu.expand(variable)
        if not scalars:
            raise InputError(f"get {name}: {component} has no variable '{variable}'{nearest(variable, fmu.variables)}")
        if fmu.type_of(scalars[0]) is None:
            raise InputError(f"get {name}: values of type {fmu.variables[scalars[0]].type} cannot be exchanged")
        values = [self._value(component, scalar) for scalar in scalars]
        return values[0] if variable in fmu.variables else values

    def _instance(self, what: str, name: str, component: str) -> Participant:
        if component not in self.instances:
            raise InputError(f"{what} {name}: no component '{component}'{nearest(component, self.instances)}")
        return self.instances[component]

    def _value(self, component: str, variable: str) -> Value:
        key = (component, variable)
        for table in (self.plan.layout.outputs, self.plan.layout.inputs):
            if key in table:
                return self.memory.value(key, table[key])
        value: Value = self.instances[component].get(variable)
        return value

    def checked(self, name: str, value: object) -> tuple[str, dict[str, Value]]:
        """The component of an input that nothing drives, and its values by scalar. Raises as `Session.set` does."""
        component, _, variable = self.plan.system.full_name(name).partition(".")
        instance = self._instance("set", name, component)
        plain = value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value
        values = checked_values(self.plan.system.components[component], variable, plain, "set")
        for scalar in values:
            if not follows_tables(instance.fmu.variables[scalar]):
                raise InputError(
                    f"set {name}: a parameter is set before the run; only inputs and tunable parameters can be set "
                    f"while it goes"
                )
            if (component, scalar) in self.driven:
                raise InputError(
                    f"set {name}: {component}.{scalar} is driven by the connection {self.driven[component, scalar]}; "
                    f"remove that first"
                )
            if scalar in self.plan.system.components[component].series:
                followed = self.plan.system.components[component].series[scalar]
                raise InputError(f"set {name}: {component}.{scalar} follows {followed}; remove that first")
        return component, values

    def set(self, name: str, value: object) -> tuple[str, dict[str, Value]]:
        """Set an input that nothing drives; the component, and the values that are left to be set at an event of it."""
        component, values = self.checked(name, value)
        apart = self.plan.system.components[component].at_events
        for scalar, scalar_value in values.items():
            if (component, scalar) in self.plan.layout.inputs:  # of an array other elements are driven
                slot = self.plan.layout.inputs[component, scalar]
                self.memory.put((component, scalar), slot, scalar_value)
        later = {scalar: scalar_value for scalar, scalar_value in values.items() if scalar in apart}
        self.instances[component].set_all(
            {scalar: scalar_value for scalar, scalar_value in values.items() if scalar not in apart}
        )
        return component, later
