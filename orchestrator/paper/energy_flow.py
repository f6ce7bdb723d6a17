"""Where the battery's energy goes: from motor and brush to the hull, as links of a flow diagram."""

from __future__ import annotations

from dataclasses import dataclass

from .lab import Case


@dataclass(frozen=True)
class Flow:
    """Energy [J] from one place to another over a run."""

    source: str
    target: str
    energy: float


def stored_in_brush(case: Case) -> float:
    """Energy [J] that the brush holds at the end; what is pressed in at the start counts, since W_hull counts it."""
    return sum(case.last(f"brush.E_{kind}") for kind in ("kinetic", "strain", "centrifugal", "contact"))


def flows(case: Case) -> list[Flow]:
    """Every flow of motor and brush, each turned so that its energy is positive; what is nothing is left out."""
    stored_motor = case.rise("motor.E_stored")
    stored_brush = stored_in_brush(case)
    links = [
        Flow("battery", "motor", case.last("motor.W_electrical")),
        Flow("motor", "heat in the winding", case.last("motor.W_copper")),
        Flow("motor", "friction in motor and gear", case.last("motor.W_friction") + case.last("motor.W_gear")),
        Flow("motor", "inertia of rotor and brush", stored_motor),
        Flow("motor", "brush", case.last("motor.W_shaft")),
        Flow("brush", "friction on the hull", case.last("brush.W_friction")),
        Flow("brush", "bristle damping", case.last("brush.W_damping")),
        Flow("brush", "contact loss", case.last("brush.W_contact")),
        Flow("brush", "water", case.last("brush.W_water")),
        Flow("brush", "elastic and kinetic energy of the bristles", stored_brush),
        Flow("brush", "work on the passing hull", -case.last("brush.W_hull")),
    ]
    turned = [link if link.energy >= 0 else Flow(link.target, link.source, -link.energy) for link in links]
    return [link for link in turned if link.energy > 1e-6 * links[0].energy]


def imbalance(links: list[Flow], node: str) -> float:
    """What flows into a node and not out of it [J]."""
    return sum(link.energy * ((link.target == node) - (link.source == node)) for link in links)
