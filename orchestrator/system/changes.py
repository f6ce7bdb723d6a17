"""What the command line changes of a system's components: other FMUs in their place, other periods."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

from ..clock import duration
from ..errors import InputError, nearest
from ..fmu.fmu import Fmu
from .model import System
from .replace.mapping import VariableMapping, load_mapping
from .replace.view import replace_component


@dataclass(frozen=True)
class Changes:
    """By component: the FMU that replaces it, its mapping file, its period as text. Hashable, small to send."""

    fmus: tuple[tuple[str, str], ...] = ()  # absolute paths
    mappings: tuple[tuple[str, str], ...] = ()
    periods: tuple[tuple[str, str], ...] = ()

    def apply(self, system: System) -> System:
        """The changed system. Raises InputError or FmuError for what does not fit."""
        fmus, mappings = dict(self.fmus), dict(self.mappings)
        periods: dict[str, Fraction] = {}
        for option, pairs in (("--period", self.periods), ("--replace", self.fmus), ("--map", self.mappings)):
            for name, _ in pairs:
                if name not in system.components:
                    raise InputError(f"{option}: no component '{name}'{nearest(name, system.components)}")
        for name, text in self.periods:
            periods[name] = duration(text, f"--period {name}")
        for name in mappings.keys() - fmus.keys():
            raise InputError(f"--map {name}: nothing replaces {name}; give --replace {name}=their.fmu too")
        for name, path in fmus.items():
            mapping = load_mapping(Path(mappings[name])) if name in mappings else VariableMapping()
            system = replace_component(system, name, Fmu.open(Path(path)), mapping)
        return _with_periods(system, periods)


UNCHANGED = Changes()


def _with_periods(system: System, periods: dict[str, Fraction]) -> System:
    """With other periods; a stated order goes on putting fast before slow."""
    components = {name: replace(c, period=periods.get(name, c.period)) for name, c in system.components.items()}
    order = tuple(sorted(system.order, key=lambda name: components[name].period))
    return replace(system, components=components, order=order if periods else system.order)


def changes_of(replacements: Iterable[str], mappings: Iterable[str], periods: Iterable[str]) -> Changes:
    """From the options `--replace motor=their.fmu --map motor=map.toml --period motor="1 ms"`. Raises InputError."""
    return Changes(
        _pairs("--replace", replacements, "motor=their.fmu", paths=True),
        _pairs("--map", mappings, "motor=map.toml", paths=True),
        _pairs("--period", periods, 'motor="1 ms"'),
    )


def _pairs(option: str, texts: Iterable[str], example: str, paths: bool = False) -> tuple[tuple[str, str], ...]:
    found: dict[str, str] = {}
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not (name and equals and value):
            raise InputError(f"{option} {text}: write component=value, for instance {option} {example}")
        if name in found:
            raise InputError(f"{option} {text}: {name} has {found[name]} already")
        found[name] = str(Path(value).absolute()) if paths else value
    return tuple(found.items())
