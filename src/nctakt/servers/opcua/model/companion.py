# SPDX-License-Identifier: MIT
"""The companion model for CNC systems (OPC 40502): its types with their numbers, as facts.

Out: ``OBJECT_TYPES``, ``ENUMERATIONS``, ``POSITION`` and the numbers around them, all of the
namespace ``CNC_URI``. A component names the numbers of the nodes below it in the order in which its
type declares them, those of its base first, 0 for one that it does not have.
"""

from __future__ import annotations

from typing import NamedTuple

#: The namespace of the model.
CNC_URI = "http://opcfoundation.org/UA/CNC"

#: Modelling rules, as numbers of their nodes in namespace 0.
MANDATORY, OPTIONAL, PLACEHOLDER = 78, 80, 11508

#: Types of variables and of base objects, as numbers of their nodes in namespace 0.
BASE_OBJECT, BASE_VARIABLE, PROPERTY, DATA_ITEM, ANALOG_ITEM = 58, 63, 68, 2365, 2368
#: An analog item that must have a unit; one that must also have a range.
ANALOG_UNIT, ANALOG_RANGE = 17497, 17570

#: The type of a position, its data type, the encodings of that, and their dictionaries.
POSITION_VARIABLE, POSITION, POSITION_BINARY, POSITION_XML = 2001, 3007, 5001, 5007
BINARY_SCHEMA, BINARY_DESCRIPTION, BINARY_NAMESPACE = 6022, 6042, 6035
XML_SCHEMA, XML_DESCRIPTION, XML_NAMESPACE = 6038, 6043, 6040

#: The fields of a position, each a Double and a separate component.
POSITION_FIELDS = ("ActPos", "CmdPos", "RemDist")


class Enumeration(NamedTuple):
    """A data type whose values are ``names``, from 0.

    ``values_number``: its EnumValues, or where it ``has_strings`` its EnumStrings; ``rule``: that
    of these, 0 for none.
    """

    name: str
    number: int
    values_number: int
    names: tuple[str, ...]
    has_strings: bool = False
    rule: int = MANDATORY


class Component(NamedTuple):
    """A component or property of a type.

    ``type``: a number of namespace 0, or a name of this model. ``dimensions``: of an array, 0 where
    any length is allowed; empty for a scalar. ``below``: numbers of the nodes below it.
    ``units_rule``: that of an analog item's EngineeringUnits. ``surplus``: further components.
    ``events``: those it generates, as in its type. ``rights``: 1 read, 3 write, too.
    ``is_standard``: its name is one of namespace 0.
    """

    name: str
    number: int
    type: int | str
    data_type: str = ""
    dimensions: tuple[int, ...] = ()
    below: tuple[int, ...] = ()
    rule: int = MANDATORY
    units_rule: int = MANDATORY
    surplus: tuple[Component, ...] = ()
    events: tuple[int | str, ...] = ()
    rights: int = 3
    is_standard: bool = False


class ObjectType(NamedTuple):
    """A type; ``base``: a number of namespace 0, or a name of this model.

    ``events``: those it generates, likewise.
    """

    name: str
    number: int
    base: int | str
    components: tuple[Component, ...]
    is_abstract: bool = False
    events: tuple[int | str, ...] = ()


def _item(
    name: str,
    number: int,
    data_type: str,
    dimensions: tuple[int, ...] = (),
    rule: int = MANDATORY,
) -> Component:
    return Component(name, number, DATA_ITEM, data_type, dimensions, rule=rule)


def _property(
    name: str,
    number: int,
    data_type: str,
    dimensions: tuple[int, ...] = (),
    rule: int = MANDATORY,
) -> Component:
    return Component(name, number, PROPERTY, data_type, dimensions, rule=rule)


def _analog(
    name: str, number: int, eu_range: int, units: int, units_rule: int = MANDATORY
) -> Component:
    return Component(
        name, number, ANALOG_ITEM, "Double", below=(eu_range, units), units_rule=units_rule
    )


def _position(name: str, number: int, *below: int) -> Component:
    return Component(name, number, "CncPositionVariableType", "CncPositionDataType", below=below)


def _object(
    name: str,
    number: int,
    type_: str,
    *below: int,
    rule: int = MANDATORY,
    surplus: tuple[Component, ...] = (),
    events: tuple[int | str, ...] = (),
) -> Component:
    return Component(name, number, type_, below=below, rule=rule, surplus=surplus, events=events)


ENUMERATIONS = (
    Enumeration("CncSpindleTurnDirection", 3001, 6146, ("None", "CW", "CCW")),
    Enumeration(
        "CncChannelProgramStatus",
        3002,
        6225,
        ("Stopped", "Running", "Waiting", "Interrupted", "Canceled"),
    ),
    Enumeration("CncChannelStatus", 3003, 6223, ("Active", "Interrupted", "Reset")),
    Enumeration("CncAxisStatus", 3004, 6976, ("InPosition", "Moving", "Parked")),
    Enumeration(
        "CncSpindleStatus",
        3005,
        6224,
        ("Stopped", "InTargetArea", "Accelerating", "Decelerating", "Parked"),
    ),
    Enumeration("CncOperationMode", 3006, 7106, ("Manual", "MDA", "Automatic"), has_strings=True),
)

#: The components of ``CncPositionVariableType``: name, number, type, data type.
POSITION_COMPONENTS = (
    ("ActPos", 6046, BASE_VARIABLE, "Double"),
    ("CmdPos", 6044, BASE_VARIABLE, "Double"),
    ("EURange", 6881, PROPERTY, "Range"),
    ("EngineeringUnits", 6829, PROPERTY, "EUInformation"),
    ("RemDist", 6050, BASE_VARIABLE, "Double"),
)

#: Components of a channel that the published model also has below the placeholder of a list of
#: spindles; ``CncSpindleType`` has none of them, so no spindle here has any.
_SURPLUS = (
    _item("ActOperationMode", 6576, "CncOperationMode"),
    _item("CmdOperationMode", 6627, "CncOperationMode"),
    _item("ActMainProgramFile", 6715, "String"),
    _item("ActProgramStatus", 6946, "CncChannelProgramStatus"),
    *(
        component._replace(rights=1)
        for component in (
            _analog("ActFeedrate", 6712, 6714, 6713),
            _item("ActGFunctions", 6720, "UInt32", (0,)),
            _analog("ActJogIncrement", 6721, 6723, 6722),
            _item("ActMainProgramFileOffset", 6716, "UInt32"),
            _item("ActMainProgramLine", 6717, "String"),
            _item("ActMainProgramName", 6724, "String"),
            _item("ActMFunctions", 6725, "UInt32", (0,)),
            _item("ActModalOffsetFunction", 6726, "UInt32"),
            _item("ActProgramBlock", 6943, "String", (3,)),
            _item("ActProgramFile", 6945, "String"),
            _item("ActProgramFileOffset", 6719, "UInt32"),
            _item("ActProgramLine", 6944, "String"),
            _item("ActProgramName", 6718, "String"),
            _item("BlockMode", 6947, "Boolean"),
            _analog("CmdFeedrate", 6948, 6950, 6949),
            _analog("DryRunFeed", 6951, 6953, 6952),
            _item("FeedHold", 6954, "Boolean"),
            _item("ToolId", 6957, "UInt32"),
        )
    ),
)

# fmt: off
_AXIS_OF_CHANNEL = (
    7147, 7148, 7150, 7149, 7151, 7153, 7152, 7154, 7156, 7155, 7157, 7159, 7158, 7160, 7161, 7132,
    7142, 7143, 7000, 7001, 7002, 7004, 7003, 7005, 7006, 7007, 7008, 7010, 7009, 7011, 7144, 7146,
    7145,
)
_SPINDLE_OF_CHANNEL = (
    7184, 7185, 7187, 7186, 7188, 7190, 7189, 7191, 7193, 7192, 7194, 7196, 7195, 7197, 7198, 7166,
    7167, 7168, 6057, 7169, 7171, 7170, 7173, 7174, 7012, 7013, 7014, 7016, 7015, 7017, 7178, 7179,
    7180, 0, 7181, 7183, 7182,
)
_AXIS_OF_LIST = (
    6654, 6655, 6657, 6656, 6658, 6660, 6659, 6661, 6664, 6662, 6665, 6667, 6666, 6668, 6669, 6636,
    6649, 6650, 6938, 6939, 6940, 6942, 6941, 6955, 6956, 6958, 6959, 6961, 6960, 6962, 6651, 6653,
    6652,
)
_SPINDLE_OF_LIST = (
    6104, 6105, 6107, 6106, 6108, 6110, 6109, 6111, 6113, 6112, 6114, 6116, 6115, 6117, 6118, 6076,
    6707, 6708, 6051, 6077, 6079, 6078, 6081, 6082, 6124, 6125, 6126, 6157, 6127, 6165, 6091, 6710,
    6711, 0, 6096, 6103, 6097,
)
_CHANNEL_OF_LIST = (
    6119, 6131, 6129, 6138, 6139, 6145, 6142, 6149, 6683, 6695, 6689, 6148, 6150, 6782, 6151, 6153,
    6152, 6281, 6283, 6137, 6282, 6133, 6365, 6366, 6367, 6444, 6453, 6445, 6816, 6596, 6622, 6597,
    0, 0, 6623, 6625, 6624, 6626, 6017, 6058, 6068, 6069, 6883, 6831, 6070, 6273, 6313, 6314, 6895,
    6843, 6315, 6323, 6324, 6325, 6896, 6844, 6355, 6356, 6357, 6397, 6897, 6845, 6398, 6405, 6406,
    6407, 6898, 6846, 6415, 6416, 6417, 6443, 6899, 6847, 6454, 6455, 6481, 6482, 6900, 6848, 6483,
    6491, 6492, 6493, 6901, 6849, 6516, 6544, 6577, 6587, 6902, 6850, 6595, 6619, 6628, 6638, 6903,
    6851, 6639, 6640, 6670, 6671, 6904, 6852, 6672, 6673, 6674, 6675, 6905, 6853, 6676, 6629,
)
# fmt: on

#: Events of namespace 0: the model has changed; a message; an alarm.
_MODEL_CHANGE, _EVENT, _ALARM = 2133, 2041, 10523

#: The types of objects and events, each after its base.
OBJECT_TYPES = (
    ObjectType("CncMessageType", 1011, _EVENT, ()),
    ObjectType(
        "CncAlarmType",
        1006,
        _ALARM,
        (
            _property("AlarmIdentifier", 6865, "String"),
            _property("AuxParameters", 6862, "String", (0,), OPTIONAL),
            _property("HelpSource", 6854, "String", rule=OPTIONAL),
        ),
    ),
    ObjectType("CncComponentType", 1001, BASE_OBJECT, (), is_abstract=True),
    ObjectType(
        "CncDriveType",
        1003,
        "CncComponentType",
        (
            _item("ActChannel", 6059, "NodeId"),
            _analog("ActLoad", 6060, 6061, 6015),
            _analog("ActPower", 6062, 6063, 6018),
            _analog("ActTorque", 6064, 6065, 6021),
            _analog("CmdTorque", 6066, 6067, 6036),
            _item("IsInactive", 6200, "Boolean"),
            _item("IsVirtual", 6189, "Boolean"),
        ),
        is_abstract=True,
    ),
    ObjectType(
        "CncAxisType",
        1004,
        "CncDriveType",
        (
            _item("ActStatus", 6102, "CncAxisStatus"),
            _item("IsReferenced", 6182, "Boolean"),
            _item("IsRotational", 6211, "Boolean"),
            _position("PosDirect", 6041, 6088, 6089, 6227, 6226, 6228),
            _position("PosIndirect", 6039, 6086, 6087, 6213, 6204, 6218),
            _analog("ZeroOffset", 6100, 6101, 6154),
        ),
    ),
    ObjectType(
        "CncSpindleType",
        1005,
        "CncDriveType",
        (
            _item("ActGear", 6128, "UInt32"),
            _analog("ActOverride", 6700, 6701, 6045, OPTIONAL),
            _analog("ActSpeed", 6120, 6121, 6161),
            _item("ActStatus", 6135, "CncSpindleStatus"),
            _item("ActTurnDirection", 6132, "CncSpindleTurnDirection"),
            _position("AnglePos", 6072, 6073, 6074, 6084, 6083, 6085),
            _item("CmdGear", 6130, "UInt32"),
            _analog("CmdOverride", 6702, 6706, 0),
            _analog("CmdSpeed", 6122, 6123, 6169),
        ),
    ),
    ObjectType(
        "CncChannelType",
        1002,
        "CncComponentType",
        (
            _analog("ActFeedrate", 6005, 6006, 6010),
            _item("ActGFunctions", 6028, "UInt32", (0,)),
            _analog("ActJogIncrement", 6026, 6027, 6155),
            _item("ActMFunctions", 6177, "UInt32", (0,)),
            _item("ActMainProgramFile", 6682, "String"),
            _item("ActMainProgramFileOffset", 6694, "UInt32", rule=OPTIONAL),
            _item("ActMainProgramLine", 6688, "String", rule=OPTIONAL),
            _item("ActMainProgramName", 6031, "String"),
            _item("ActModalOffsetFunction", 6029, "UInt32"),
            _item("ActOperationMode", 6055, "CncOperationMode"),
            _analog("ActOverride", 6001, 6002, 6011),
            _item("ActProgramBlock", 6033, "String", (3,)),
            _item("ActProgramFile", 6034, "String"),
            _item("ActProgramFileOffset", 6032, "UInt32", rule=OPTIONAL),
            _item("ActProgramLine", 6047, "String", rule=OPTIONAL),
            _item("ActProgramName", 6030, "String"),
            _item("ActProgramStatus", 6023, "CncChannelProgramStatus"),
            _item("ActStatus", 6048, "CncChannelStatus"),
            _item("BlockMode", 6049, "Boolean"),
            _analog("CmdFeedrate", 6007, 6008, 6012),
            _item("CmdOperationMode", 6543, "CncOperationMode"),
            _analog("CmdOverride", 6003, 6004, 6013),
            _object("<CncAxis>", 5029, "CncAxisType", *_AXIS_OF_CHANNEL, rule=PLACEHOLDER),
            _object("<CncSpindle>", 5030, "CncSpindleType", *_SPINDLE_OF_CHANNEL, rule=PLACEHOLDER),
            _analog("DryRunFeed", 6024, 6025, 6014),
            _item("FeedHold", 6009, "Boolean"),
            _property("Id", 6016, "UInt32"),
            _position("PosTcpBcsA", 6037, 6052, 6053, 6882, 6830, 6054),
            _position("PosTcpBcsB", 6159, 6162, 6163, 6885, 6833, 6164),
            _position("PosTcpBcsC", 6166, 6167, 6178, 6886, 6834, 6184),
            _position("PosTcpBcsX", 6168, 6170, 6192, 6887, 6835, 6193),
            _position("PosTcpBcsY", 6172, 6181, 6203, 6888, 6836, 6229),
            _position("PosTcpBcsZ", 6183, 6188, 6230, 6893, 6841, 6231),
            _position("PosTcpWcsA", 6175, 6190, 6191, 6891, 6839, 6239),
            _position("PosTcpWcsB", 6176, 6198, 6199, 6892, 6840, 6240),
            _position("PosTcpWcsC", 6201, 6202, 6241, 6894, 6842, 6271),
            _position("PosTcpWcsX", 6140, 6160, 6171, 6884, 6832, 6209),
            _position("PosTcpWcsY", 6173, 6210, 6212, 6889, 6837, 6217),
            _position("PosTcpWcsZ", 6174, 6221, 6222, 6890, 6838, 6272),
            _item("ToolId", 6056, "UInt32"),
        ),
        events=("CncMessageType", _MODEL_CHANGE),
    ),
    ObjectType(
        "CncAxisListType",
        1008,
        BASE_OBJECT,
        (_object("<CncAxis>", 5019, "CncAxisType", *_AXIS_OF_LIST, rule=PLACEHOLDER),),
        events=(_MODEL_CHANGE,),
    ),
    ObjectType(
        "CncSpindleListType",
        1009,
        BASE_OBJECT,
        (
            _object(
                "<CncSpindle>",
                5002,
                "CncSpindleType",
                *_SPINDLE_OF_LIST,
                rule=PLACEHOLDER,
                surplus=_SURPLUS,
            ),
        ),
        events=(_MODEL_CHANGE,),
    ),
    ObjectType(
        "CncChannelListType",
        1010,
        BASE_OBJECT,
        (
            _object(
                "<CncChannel>",
                5003,
                "CncChannelType",
                *_CHANNEL_OF_LIST,
                rule=PLACEHOLDER,
                events=("CncMessageType", _MODEL_CHANGE),
            ),
        ),
        events=(_MODEL_CHANGE,),
    ),
    ObjectType(
        "CncInterfaceType",
        1007,
        BASE_OBJECT,
        (
            _object("CncAxisList", 5026, "CncAxisListType"),
            _object("CncChannelList", 5028, "CncChannelListType"),
            _object("CncSpindleList", 5027, "CncSpindleListType"),
            _property("CncTypeName", 6092, "String", rule=OPTIONAL),
            _property("Fix", 6618, "String", rule=OPTIONAL),
            _property("VendorName", 6620, "String"),
            _property("VendorRevision", 6621, "String"),
            _property("Version", 6616, "String"),
        ),
        events=("CncAlarmType", "CncMessageType"),
    ),
)
