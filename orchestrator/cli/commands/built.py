"""What goes wrong in the package that builds components, in the words of this one."""

from __future__ import annotations

from typing import NoReturn

from ...errors import InputError, RunError

KINDS = {"BuildError": RunError, "UnknownComponentError": InputError, "NewComponentError": InputError}


def raise_ours(error: Exception) -> NoReturn:
    """Raise it as one of ours, by the name of its kind: the package of the builder is not known here."""
    kind = KINDS.get(type(error).__name__)
    if kind:
        raise kind(str(error)) from error
    raise error
