"""All that take part in a run, from their start to their end; what they change in this process is restored at once."""

from __future__ import annotations

from typing import Any

from ..errors import FmuError
from ..fmu.tolerant.rules import FUNCTIONS, Note
from ..participant.base import Participant
from ..participant.opening import Starting, why_not_here
from ..participant.surroundings import Surroundings
from ..system.model import System


class Participants:
    """The components of a system, loaded and instantiated; `notes` says what they did that a person must know.

    Raises FmuError if one of them refuses; the others are closed then.
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self.by_name: dict[str, Participant] = {}
        self.notes: list[str] = []
        self._surroundings = Surroundings()
        starting = Starting(system.components.values())
        try:
            for name, component in system.components.items():
                if why := why_not_here(component):
                    self.notes.append(
                        f"component {name} runs in a process of its own: {component.fmu.path.name} was used in this "
                        f"process before, and {why}"
                    )
                self.by_name[name] = starting.start(component)
                self.look_for_functions(name)
                self.look_around(f"while {name} was loaded")
        except BaseException:
            starting.close()
            self.abandon()
            raise

    def look_for_functions(self, name: str) -> None:
        """Note what functions a library lacks. Raises FmuError where the system is to be strict."""
        instance = self.by_name[name]
        note = Note(FUNCTIONS, instance.missing)
        text = f"{instance.fmu.path.name}: {note.found}"
        if instance.missing and self.system.strict:
            raise FmuError(f"component {name}: {text}; {note.rule.mend}")
        if instance.missing and text not in self.notes:
            self.notes.append(text)

    def look_around(self, when: str, folder: bool = True) -> None:
        """Restore what one of them has changed for the whole process, and note it once; `folder`: look at that too."""
        for change in self._surroundings.restore(folder):
            here = [c.name for c in self.system.components.values() if not c.isolation]
            who = f"component {here[0]}" if len(here) == 1 else f"a component in this process ({', '.join(here)})"
            known = any(change in note for note in self.notes)
            if not known:
                self.notes.append(
                    f"{who} {change} {when}, which was restored; what it computed with it stays as it is; "
                    f'isolation = "process" under [components.NAME] keeps it apart'
                )

    @property
    def disturbed(self) -> bool:
        """Whether one of them has changed how numbers are rounded: what is to be looked after without delay."""
        return self._surroundings.disturbed

    @property
    def minds_rounding(self) -> bool:
        """Whether that can be told here."""
        return self._surroundings.exact

    def calculated(self) -> dict[str, Any]:
        """What they have calculated of their parameters, by `component.variable`."""
        return {
            f"{name}.{variable}": instance.get(variable)
            for name, instance in self.by_name.items()
            for variable in instance.fmu.names("calculatedParameter")
            if instance.fmu.type_of(variable) is not None
        }

    def look(self) -> None:
        """Let those that talk say some more."""
        for instance in self.by_name.values():
            instance.look()

    def messages(self) -> list[str]:
        """What they have logged, as lines of a file."""
        return [line for instance in self.by_name.values() for line in instance.logged()]

    def close(self) -> str:
        """Terminate and free them; how they fell down in that, one a line."""
        faults = [fault for instance in self.by_name.values() if (fault := instance.close())]
        self.notes += faults
        self.look_around("in its end")
        return "\n".join(faults)

    def abandon(self) -> None:
        """Give back what there is, of a run that does not begin."""
        for instance in self.by_name.values():
            instance.close()
