"""What other tools say: fmpy, which every installation has, and fmutool of the FMU manipulation toolbox."""

from __future__ import annotations

import logging
from importlib.metadata import version as installed_version
from typing import Any

from fmpy.validation import validate_fmu

from .rows import Row, judged
from .subject import Subject

STAGE = "other tools"
INSTALL = 'pip install "rovbrush[check]"'


def fmpy_row(subject: Subject) -> Row:
    """fmpy's validation: XML schema, names, model structure, start values, causality and variability, units."""
    problems = [str(problem).strip() for problem in validate_fmu(str(subject.archive))]
    mend = "correct modelDescription.xml as it says"
    return judged(STAGE, f"fmpy {installed_version('fmpy')}", problems, "no problems found", "", mend, "finding")


def fmutool_row(subject: Subject) -> Row:
    """`fmutool -check`, by the toolbox's own checkers; a row that says so where it is not installed."""
    try:
        from fmu_manipulation_toolbox.checker import OperationGenericCheck, get_checkers
        from fmu_manipulation_toolbox.operations import FMU
    except ImportError:
        return Row(STAGE, "fmutool -check", "skipped", "fmu-manipulation-toolbox is not installed", INSTALL)
    name = f"fmutool {installed_version('fmu-manipulation-toolbox')} -check"
    fmi = str(subject.description.fmiVersion)
    if fmi not in OperationGenericCheck.SUPPORTED_FMI_VERSIONS:
        return Row(STAGE, name, "not applicable", f"{name} cannot read FMI {fmi}; not counted")
    with _Collected() as complaints:
        try:
            with FMU(str(subject.archive)) as fmu:
                for checker in get_checkers():
                    fmu.apply_operation(checker())
        except Exception as error:
            complaints.append(str(error) or type(error).__name__)
    return judged(
        STAGE, name, complaints, "no problems found", "", "correct modelDescription.xml as it says", "finding"
    )


class _Collected(logging.Handler):
    """The errors that the toolbox logs, and none of them on the terminal."""

    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.logger = logging.getLogger("fmu_manipulation_toolbox")
        self.messages: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.messages.append(record.getMessage())

    def __enter__(self) -> list[str]:
        self.propagated, self.logger.propagate = self.logger.propagate, False
        self.logger.addHandler(self)
        return self.messages

    def __exit__(self, *_: Any) -> None:
        self.logger.removeHandler(self)
        self.logger.propagate = self.propagated
