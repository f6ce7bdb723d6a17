"""Whether FMUs offer what the Jacobian of their group can be made of: directional derivatives, as they state it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ...fmu.fmu import Fmu
from ...fmu.reading.states import state_names


def offers_directional(fmu: Fmu) -> bool:
    """Whether an FMU says that it gives directional derivatives."""
    return bool(fmu.interface.providesDirectionalDerivative)


def why_differences(fmus: Sequence[Fmu], sources: Iterable[tuple[int, str]]) -> tuple[int, str] | None:
    """Whose fault it is that the Jacobian must be made of differences, and why; None where it need not.

    `sources`: outputs that are connected at all times, by FMU and its own name.
    """
    sources = list(sources)
    senders = {m for m, _ in sources}
    for m, fmu in enumerate(fmus):
        if (m in senders or state_names(fmu)) and not offers_directional(fmu):
            return m, "offers no directional derivatives"
    for m, name in sources:
        own = fmus[m].own
        stated = {element for unknown in own.description.outputs for element in own.expand(unknown.variable.name)}
        if name not in stated and name not in state_names(fmus[m]):
            return m, f"says of {name}, which is no output, nothing that directional derivatives could be of"
    return None
