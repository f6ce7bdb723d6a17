"""Instances for Windows for Model Exchange: members of a group in this process, each of whose functions passes its call
on to wine."""

from __future__ import annotations

from ..model_exchange.instance import Fmi2Member, Fmi3Member, FMU2Model, FMU3Model
from .instance import WindowsInstance


class Windows2Member(WindowsInstance, Fmi2Member):
    """Of FMI 2.0."""

    instantiates, choice, slave_kind = "fmi2Instantiate", 0, FMU2Model


class Windows3Member(WindowsInstance, Fmi3Member):
    """Of FMI 3.0."""

    instantiates, slave_kind = "fmi3InstantiateModelExchange", FMU3Model
