# SPDX-License-Identifier: MIT
"""OPC UA for Machine Tools (OPC 40501-1, 1.02): the types that nctakt shows, as facts.

Out: ``TYPES``, ``ENUMERATIONS``, ``STATES`` with their published numbers, all of the namespace
``MACHINE_TOOL_URI``, and those of the models below it. Types without an instance here, and the
nodes below their optional parts, are left out.
"""

from __future__ import annotations

from typing import NamedTuple

from nctakt.servers.opcua.model.companion import (
    ANALOG_RANGE,
    BASE_OBJECT,
    BASE_VARIABLE,
    MANDATORY,
    OPTIONAL,
    PROPERTY,
    Component,
    Enumeration,
    ObjectType,
)

#: The namespaces of the model and of those that it builds on.
MACHINE_TOOL_URI = "http://opcfoundation.org/UA/MachineTool/"
MACHINERY_URI = "http://opcfoundation.org/UA/Machinery/"
DI_URI = "http://opcfoundation.org/UA/DI/"

#: The folder of all machines, in Machinery.
MACHINES = 1001
#: The type of an identification with its bases: name, number; those of Machinery, that of DI.
MACHINE_IDENTIFICATION = "MachineIdentificationType"
MACHINERY_TYPES = (("MachineryItemIdentificationType", 1004), (MACHINE_IDENTIFICATION, 1012))
FUNCTIONAL_GROUP = ("FunctionalGroupType", 1005)

#: Types of namespace 0: an ordered machine of states, its variable, events, alarms.
_STATE_MACHINE, _EVENT, _ALARM = 2771, 2041, 2915
STATE_VARIABLE = 2760


class State(NamedTuple):
    """A state of a program: its node, that of its number, the type of the node."""

    name: str
    number: int
    number_node: int
    type: int


#: The states of a program in the order of their numbers.
STATES = (
    State("Initializing", 5039, 6060, 2309),
    State("Running", 5041, 6062, 2307),
    State("Ended", 5038, 6059, 2307),
    State("Interrupted", 5040, 6061, 2307),
    State("Aborted", 5037, 6058, 2307),
)
INITIALIZING, RUNNING, ENDED, INTERRUPTED, ABORTED = range(5)
#: The type whose states these are.
PROGRAM_STATES = "ProductionProgramStateMachineType"


def _value(name: str, number: int, data_type: str, rule: int = MANDATORY) -> Component:
    return Component(name, number, BASE_VARIABLE, data_type, rule=rule, rights=1)


def _property(name: str, number: int, data_type: str, *, is_standard: bool = False) -> Component:
    return Component(name, number, PROPERTY, data_type, rights=1, is_standard=is_standard)


def _override(name: str, number: int, eu_range: int, units: int, rule: int = OPTIONAL) -> Component:
    return Component(
        name, number, ANALOG_RANGE, "Double", below=(eu_range, units), rule=rule, rights=1
    )


ENUMERATIONS = (
    Enumeration("ChannelState", 64, 266, ("Active", "Interrupted", "Reset"), rule=0),
    Enumeration(
        "MachineOperationMode",
        65,
        320,
        ("Manual", "Automatic", "Setup", "AutoWithManualIntervention", "Service", "Other"),
        rule=0,
    ),
    Enumeration(
        "ChannelMode",
        67,
        288,
        (
            "Automatic",
            "MdaMdi",
            "JogManual",
            "JogIncrement",
            "TeachingHandle",
            "Remote",
            "Reference",
            "Other",
        ),
        rule=0,
    ),
)

#: The types of objects and events, each after its base.
TYPES = (
    ObjectType("MachineToolType", 13, BASE_OBJECT, ()),
    ObjectType("MachineToolIdentificationType", 11, MACHINE_IDENTIFICATION, ()),
    ObjectType("MonitoringType", 14, BASE_OBJECT, ()),
    ObjectType(
        "MachineOperationMonitoringType",
        26,
        BASE_OBJECT,
        (_value("OperationMode", 225, "MachineOperationMode"),),
    ),
    ObjectType(
        "ElementMonitoringType",
        23,
        BASE_OBJECT,
        (_property("Name", 234, "String"),),
        is_abstract=True,
    ),
    ObjectType(
        "ChannelMonitoringType",
        16,
        "ElementMonitoringType",
        (
            _value("ChannelMode", 249, "ChannelMode"),
            _value("ChannelState", 332, "ChannelState"),
            _override("FeedOverride", 276, 336, 335, MANDATORY),
        ),
    ),
    ObjectType(
        "ChannelModifierType",
        33,
        BASE_OBJECT,
        (
            _value("DryRun", 340, "Boolean"),
            _value("OptionalStop", 325, "Boolean"),
            _value("SingleStep", 317, "Boolean"),
        ),
    ),
    ObjectType("WorkingUnitMonitoringType", 41, "ElementMonitoringType", (), is_abstract=True),
    ObjectType(
        "SpindleMonitoringType",
        22,
        "WorkingUnitMonitoringType",
        (
            _value("IsRotating", 247, "Boolean"),
            _override("Override", 241, 275, 246),
        ),
    ),
    ObjectType("ProductionType", 21, BASE_OBJECT, ()),
    ObjectType(
        "ProductionProgramType",
        59,
        BASE_OBJECT,
        (
            _property("Name", 193, "String"),
            _property("NumberInList", 230, "UInt16", is_standard=True),
        ),
    ),
    ObjectType("ProductionActiveProgramType", 32, "ProductionProgramType", ()),
    ObjectType("ProductionStateMachineType", 24, _STATE_MACHINE, ()),
    ObjectType(PROGRAM_STATES, 15, "ProductionStateMachineType", ()),
    ObjectType(
        "ProductionStatisticsType",
        20,
        BASE_OBJECT,
        (_value("PartsProducedInLifetime", 405, "UInt32", OPTIONAL),),
    ),
    ObjectType("EquipmentType", 12, BASE_OBJECT, ()),
    ObjectType("NotificationType", 7, BASE_OBJECT, ()),
    ObjectType("AlertType", 39, _ALARM, (_property("ErrorCode", 231, "String"),)),
    ObjectType(
        "NotificationEventType",
        35,
        _EVENT,
        (_property("Identifier", 232, "String"),),
        is_abstract=True,
    ),
    ObjectType("MessagesType", 38, BASE_OBJECT, (), events=("AlertType", "NotificationEventType")),
)
