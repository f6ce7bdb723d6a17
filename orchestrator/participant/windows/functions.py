"""The functions of FMI that are called under wine: their kinds of arguments, as in `server/protocol.h`, and in C."""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

from ..isolated.functions import functions as of_the_loop


class Shape(IntEnum):
    """`enum Shape` of the server."""

    SET_GET = 0
    SET_GET_SIZED = 1
    SET_TEXT = 2
    SET_TEXT_SIZED = 3
    GET_TEXT = 4
    GET_TEXT_SIZED = 5
    STEP = 6
    STEP3 = 7
    STATE_OUT = 8
    STATE_IN = 9
    STATE_SIZE = 10
    SERIALIZE = 11
    DESERIALIZE = 12
    PLAIN = 13
    FREE = 14
    EXPERIMENT = 15
    INITIALIZE1 = 16
    LOGGING = 17
    LOGGING1 = 18
    STATUS_NUMBER = 19
    STATUS_TEXT = 20
    TEXT = 21
    INSTANTIATE1 = 22
    INSTANTIATE2 = 23
    INSTANTIATE3 = 24


class Called(NamedTuple):
    """A function: its name in the standard, the kind of its arguments, and its signature in C."""

    name: str
    shape: Shape
    signature: str = ""  # empty: see `isolated.functions`


_ALONE, _VOID = "int(uintptr_t)", "void(uintptr_t)"
_SIZE, _SERIALIZE = "int(uintptr_t, uintptr_t, uintptr_t)", "int(uintptr_t, uintptr_t, uintptr_t, size_t)"
_DESERIALIZE, _STATUS = "int(uintptr_t, uintptr_t, size_t, uintptr_t)", "int(uintptr_t, int, uintptr_t)"
_STATUSES = (("Status", Shape.STATUS_NUMBER), ("RealStatus", Shape.STATUS_NUMBER),
             ("IntegerStatus", Shape.STATUS_NUMBER), ("BooleanStatus", Shape.STATUS_NUMBER),
             ("StringStatus", Shape.STATUS_TEXT))  # fmt: skip
_BY_NAME: dict[int, tuple[Called, ...]] = {
    1: (
        Called("fmiGetVersion", Shape.TEXT, "uintptr_t(void)"),
        Called("fmiGetTypesPlatform", Shape.TEXT, "uintptr_t(void)"),
        Called("fmiInstantiateSlave", Shape.INSTANTIATE1),
        Called("fmiInitializeSlave", Shape.INITIALIZE1, "int(uintptr_t, double, signed char, double)"),
        Called("fmiTerminateSlave", Shape.PLAIN, _ALONE), Called("fmiResetSlave", Shape.PLAIN, _ALONE),
        Called("fmiCancelStep", Shape.PLAIN, _ALONE), Called("fmiFreeSlaveInstance", Shape.FREE, _VOID),
        Called("fmiSetDebugLogging", Shape.LOGGING1, "int(uintptr_t, signed char)"),
        *(Called(f"fmiGet{name}", shape, _STATUS) for name, shape in _STATUSES),
    ),
    2: (
        Called("fmi2GetVersion", Shape.TEXT, "uintptr_t(void)"),
        Called("fmi2GetTypesPlatform", Shape.TEXT, "uintptr_t(void)"),
        Called("fmi2Instantiate", Shape.INSTANTIATE2),
        Called("fmi2SetupExperiment", Shape.EXPERIMENT, "int(uintptr_t, int, double, double, int, double)"),
        *(Called(f"fmi2{name}", Shape.PLAIN, _ALONE)
          for name in ("EnterInitializationMode", "ExitInitializationMode", "Terminate", "Reset", "CancelStep")),
        Called("fmi2FreeInstance", Shape.FREE, _VOID),
        Called("fmi2SetDebugLogging", Shape.LOGGING, "int(uintptr_t, int, size_t, uintptr_t)"),
        *(Called(f"fmi2Get{name}", shape, _STATUS) for name, shape in _STATUSES),
        Called("fmi2SerializedFMUstateSize", Shape.STATE_SIZE, _SIZE),
        Called("fmi2SerializeFMUstate", Shape.SERIALIZE, _SERIALIZE),
        Called("fmi2DeSerializeFMUstate", Shape.DESERIALIZE, _DESERIALIZE),
    ),
    3: (
        Called("fmi3GetVersion", Shape.TEXT, "uintptr_t(void)"),
        Called("fmi3InstantiateCoSimulation", Shape.INSTANTIATE3),
        Called("fmi3EnterInitializationMode", Shape.EXPERIMENT,
               "int(uintptr_t, _Bool, double, double, _Bool, double)"),
        *(Called(f"fmi3{name}", Shape.PLAIN, _ALONE)
          for name in ("ExitInitializationMode", "Terminate", "Reset", "EnterEventMode", "EnterStepMode",
                       "EnterConfigurationMode", "ExitConfigurationMode", "EvaluateDiscreteStates")),
        Called("fmi3FreeInstance", Shape.FREE, _VOID),
        Called("fmi3SetDebugLogging", Shape.LOGGING, "int(uintptr_t, _Bool, size_t, uintptr_t)"),
        Called("fmi3SerializedFMUStateSize", Shape.STATE_SIZE, _SIZE),
        Called("fmi3SerializeFMUState", Shape.SERIALIZE, _SERIALIZE),
        Called("fmi3DeserializeFMUState", Shape.DESERIALIZE, _DESERIALIZE),
    ),
}  # fmt: skip
INSTANTIATE = {1: "fmiInstantiateSlave", 2: "fmi2Instantiate", 3: "fmi3InstantiateCoSimulation"}


def called(version: int) -> list[Called]:
    """All that can be called, by number: those of the loop first, as they are numbered for any isolated FMU."""
    sized = version == 3
    kinds = {
        "step": Shape.STEP3 if sized else Shape.STEP,
        "save": Shape.STATE_OUT, "forget": Shape.STATE_OUT, "restore": Shape.STATE_IN,
    }  # fmt: skip
    found = []
    for function in of_the_loop(version):
        if function.kind in kinds:
            shape = kinds[function.kind]
        elif function.text:
            plain = Shape.SET_TEXT if function.kind == "set" else Shape.GET_TEXT
            shape = Shape(plain + sized)
        else:
            shape = Shape.SET_GET_SIZED if sized else Shape.SET_GET
        found.append(Called(function.name, shape))
    return [*found, *_BY_NAME[version]]
