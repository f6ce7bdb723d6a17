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
    SET_BINARY = 25
    GET_BINARY = 26
    PAIRS = 27
    TRIPLES = 28
    UPDATE = 29
    ACTIVATE = 30
    INSTANTIATE_SCHEDULED = 31
    TIME = 32
    VECTOR = 33
    COMPLETED2 = 34
    COMPLETED3 = 35
    EVENT_INFO = 36
    COUNT = 37
    DIRECTIONAL2 = 38
    DIRECTIONAL3 = 39
    INSTANTIATE_MODEL = 40


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
_TIME, _VECTOR = "int(uintptr_t, double)", "int(uintptr_t, uintptr_t, size_t)"
_POINTERS = ["int(uintptr_t, uintptr_t, size_t" + ", uintptr_t" * count + ")" for count in range(4)]
_CLOCKS = (("Clock", Shape.SET_GET, 1), ("IntervalDecimal", Shape.PAIRS, 2), ("IntervalFraction", Shape.TRIPLES, 3),
           ("ShiftDecimal", Shape.SET_GET, 1), ("ShiftFraction", Shape.PAIRS, 2))  # fmt: skip
_SET_CLOCKS = (("Clock", Shape.SET_GET, 1), ("IntervalDecimal", Shape.SET_GET, 1),
               ("IntervalFraction", Shape.PAIRS, 2), ("ShiftDecimal", Shape.SET_GET, 1),
               ("ShiftFraction", Shape.PAIRS, 2))  # fmt: skip
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
        *(Called(f"fmi2{name}", Shape.PLAIN, _ALONE) for name in ("EnterEventMode", "EnterContinuousTimeMode")),
        *(Called(f"fmi2{name}", Shape.VECTOR, _VECTOR) for name in
          ("SetContinuousStates", "GetContinuousStates", "GetDerivatives", "GetEventIndicators",
           "GetNominalsOfContinuousStates")),
        Called("fmi2SetTime", Shape.TIME, _TIME),
        Called("fmi2NewDiscreteStates", Shape.EVENT_INFO, "int(uintptr_t, uintptr_t)"),
        Called("fmi2CompletedIntegratorStep", Shape.COMPLETED2, "int(uintptr_t, int, uintptr_t, uintptr_t)"),
        Called("fmi2GetDirectionalDerivative", Shape.DIRECTIONAL2,
               "int(uintptr_t, uintptr_t, size_t, uintptr_t, size_t, uintptr_t, uintptr_t)"),
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
        Called("fmi3InstantiateScheduledExecution", Shape.INSTANTIATE_SCHEDULED),
        Called("fmi3InstantiateModelExchange", Shape.INSTANTIATE_MODEL),
        *(Called(f"fmi3Get{name}", shape, _POINTERS[count]) for name, shape, count in _CLOCKS),
        *(Called(f"fmi3Set{name}", shape, _POINTERS[count]) for name, shape, count in _SET_CLOCKS),
        Called("fmi3UpdateDiscreteStates", Shape.UPDATE, "int(uintptr_t" + ", uintptr_t" * 6 + ")"),
        Called("fmi3ActivateModelPartition", Shape.ACTIVATE, "int(uintptr_t, uint32_t, double)"),
        Called("fmi3EnterContinuousTimeMode", Shape.PLAIN, _ALONE),
        *(Called(f"fmi3{name}", Shape.VECTOR, _VECTOR) for name in
          ("SetContinuousStates", "GetContinuousStates", "GetContinuousStateDerivatives", "GetEventIndicators",
           "GetNominalsOfContinuousStates")),
        *(Called(f"fmi3GetNumberOf{name}", Shape.COUNT, "int(uintptr_t, uintptr_t)")
          for name in ("ContinuousStates", "EventIndicators")),
        Called("fmi3SetTime", Shape.TIME, _TIME),
        Called("fmi3CompletedIntegratorStep", Shape.COMPLETED3, "int(uintptr_t, _Bool, uintptr_t, uintptr_t)"),
        Called("fmi3GetDirectionalDerivative", Shape.DIRECTIONAL3,
               "int(uintptr_t, uintptr_t, size_t, uintptr_t, size_t, uintptr_t, size_t, uintptr_t, size_t)"),
    ),
}  # fmt: skip


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
        elif function.binary:
            shape = Shape.SET_BINARY if function.kind == "set" else Shape.GET_BINARY
        elif function.text:
            plain = Shape.SET_TEXT if function.kind == "set" else Shape.GET_TEXT
            shape = Shape(plain + sized)
        else:
            shape = Shape.SET_GET_SIZED if sized else Shape.SET_GET
        found.append(Called(function.name, shape))
    return [*found, *_BY_NAME[version]]
