"""What can go wrong while FMUs are built; the texts are for the user."""


class BuildError(Exception):
    """An FMU could not be built; the text says which and why."""


class UnknownComponentError(BuildError):
    """There is no component of that name."""


class NewComponentError(BuildError):
    """A component cannot be written under that name, or there."""
