# SPDX-License-Identifier: MIT
"""The instance of the companion model: a machine's axes, spindles and channels as nodes.

In: a machine, its values by name. Out: nodes in the address space, those of the session as ``Live``
ones. IDs are names, such as ``CncChannelList.1.V.E.COUNT``: they stay from one start to the next.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from asyncua import ua

from nctakt.base.version import __version__
from nctakt.lists.machine.machine import ChannelConfiguration
from nctakt.servers.catalogue import Value as CatalogueValue
from nctakt.servers.host import Host
from nctakt.servers.opcua.live_space import LiveSpace
from nctakt.servers.opcua.model import nodes as refs
from nctakt.servers.opcua.model.companion import (
    ANALOG_ITEM,
    ANALOG_UNIT,
    BASE_VARIABLE,
    DATA_ITEM,
    MANDATORY,
    POSITION_FIELDS,
    PROPERTY,
    Component,
)
from nctakt.servers.opcua.model.nodes import (
    ARRAY,
    HISTORY,
    READ,
    SCALAR,
    WRITE,
    Nodes,
    VariableValue,
    standard,
)
from nctakt.servers.opcua.model.position import CncPositionDataType
from nctakt.servers.opcua.model.types import ANALOG_PROPERTIES, CompanionTypes, all_components
from nctakt.servers.opcua.space.components import (
    ProgramTexts,
    Shown,
    ShownPosition,
    axis_components,
    channel_components,
    spindle_components,
)
from nctakt.servers.opcua.values import Live, NotSupported, Value, ValueSnapshot

#: The namespace of the instance, and of nctakt's own nodes.
OWN_URI = "urn:nctakt"

#: The shortest interval for a value, in ms, as published by nodes.
_INTERVAL_MS = 10.0

#: The properties with a value's unit and range -> their data types.
_UNIT_TYPES = dict(ANALOG_PROPERTIES)

#: Types of variables lists -> types of OPC UA.
KINDS = {
    "BOOLEAN": ua.VariantType.Boolean,
    "SGN08": ua.VariantType.SByte,
    "UNS08": ua.VariantType.Byte,
    "SGN16": ua.VariantType.Int16,
    "UNS16": ua.VariantType.UInt16,
    "SGN32": ua.VariantType.Int32,
    "UNS32": ua.VariantType.UInt32,
    "REAL64": ua.VariantType.Double,
    "STRING": ua.VariantType.String,
    "VSTRING": ua.VariantType.String,
}

#: Data types of the model -> types on the wire.
_VARIANTS = {
    "Boolean": ua.VariantType.Boolean,
    "UInt32": ua.VariantType.UInt32,
    "Double": ua.VariantType.Double,
    "String": ua.VariantType.String,
    "NodeId": ua.VariantType.NodeId,
}


_NAMESPACE = "http://www.opcfoundation.org/UA/units/un/cefact"

#: Sign -> code and name.
_UNITS = {
    "mm": ("MMT", "millimetre"),
    "°": ("DD", "degree [unit of angle]"),
    "%": ("P1", "percent"),
    "mm/min": ("H81", "millimetre per minute"),
    "mm/s": ("C16", "millimetre per second"),
    "1/min": ("RPM", "revolutions per minute"),
    "s": ("SEC", "second [unit of time]"),
    "ms": ("C26", "millisecond"),
    "µs": ("B98", "microsecond"),
    "N·m": ("NU", "newton metre"),
    "kW": ("KWT", "kilowatt"),
}


class MachineSpace:
    """The nodes of a machine; ``interface``: the object above them, ``channels``: by number.

    ``shown``: the values of the components of axes, spindles and channels, by their paths.
    """

    def __init__(
        self, nodes: Nodes, types: CompanionTypes, live: LiveSpace, host: Host, index: int
    ) -> None:
        self._nodes = nodes
        self._types = types
        self._live = live
        self._host = host
        self.index = index
        self.interface = self.id("CncInterface")
        self.channels: dict[int, ua.NodeId] = {}
        self.shown: dict[str, Mapping[str, Shown | ShownPosition]] = {}

    def id(self, path: str) -> ua.NodeId:
        """Return the ID of a node by its path."""
        return ua.NodeId(path, self.index)

    def name(self, words: str) -> ua.QualifiedName:
        """Return a name of our namespace."""
        return ua.QualifiedName(words, self.index)

    def add_all(self, texts: ProgramTexts) -> None:
        """Add all nodes."""
        machine = self._host.machine
        self._add_object(
            "CncInterface",
            self.name("CncInterface"),
            "CncInterfaceType",
            standard(85),
            refs.ORGANIZES,
        )
        for name, value in (
            ("VendorName", "nctakt"),
            ("VendorRevision", __version__),
            ("Version", "1.00"),
            ("CncTypeName", machine.name),
        ):
            component = _component("CncInterfaceType", name)
            self._add_fixed("CncInterface", component, value)
        for list_ in ("CncAxisList", "CncChannelList", "CncSpindleList"):
            name = self._types.name(list_)
            self._add_object(list_, name, f"{list_}Type", self.interface, refs.HAS_COMPONENT)
        several = len(machine.channels) > 1
        for channel in machine.channels:
            prefix = f"CH{channel.number}." if several else ""
            self._add_channel(channel, prefix, texts)
        self._add_marked()

    # --- axes, spindles and channels ------------------------------------------------------------

    def _add_channel(self, channel: ChannelConfiguration, prefix: str, texts: ProgramTexts) -> None:
        number, machine = channel.number, self._host.machine
        path = f"CncChannelList.{number}"
        node = self.channels[number] = self._add_object(
            path, self.name(f"Channel_{number}"), "CncChannelType", self.id("CncChannelList")
        )
        axes = {axis.name: machine.axes[axis.index] for axis in channel.axes}
        session = self._host.session
        shown = channel_components(channel, axes, prefix, texts, lambda: session.latest)
        self._add_components(path, "CncChannelType", shown)
        for index, (name, axis) in enumerate(axes.items()):
            own = f"CncAxisList.{prefix}{name}"
            axis_node = self._add_object(
                own, self.name(f"{prefix}{name}"), "CncAxisType", self.id("CncAxisList")
            )
            self._nodes.refer(node, refs.HAS_COMPONENT, axis_node)
            shown = axis_components(axis, name, prefix, index, number, node)
            self._add_components(own, "CncAxisType", shown)
        for index, spindle in enumerate(channel.spindles):
            name = spindle.spindle.name
            own = f"CncSpindleList.{prefix}{name}"
            spindle_node = self._add_object(
                own, self.name(f"{prefix}{name}"), "CncSpindleType", self.id("CncSpindleList")
            )
            self._nodes.refer(node, refs.HAS_COMPONENT, spindle_node)
            listed = None if spindle.index is None else machine.axes[spindle.index]
            self._add_components(
                own,
                "CncSpindleType",
                spindle_components(
                    name,
                    prefix,
                    0.0 if listed is None else listed.max_speed / 6.0,
                    100.0 if listed is None else listed.max_override_pct,
                    index,
                    number,
                    plc=spindle.spindle.plc_controlled,
                    channel=node,
                ),
            )
        self._add_values(path, prefix, number)

    def _add_object(
        self,
        path: str,
        name: ua.QualifiedName,
        type_: str,
        parent: ua.NodeId,
        reference: int = refs.HAS_COMPONENT,
    ) -> ua.NodeId:
        node = self._nodes.add_object(
            self.id(path), name, self._types.type(type_), is_notifier=True
        )
        self._nodes.refer(parent, reference, node)
        return node

    # --- components of the model ----------------------------------------------------------------

    def _add_components(
        self, path: str, type_: str, shown: Mapping[str, Shown | ShownPosition]
    ) -> None:
        """Add the components of an object; one without a value belongs to an optional one."""
        self.shown[path] = shown
        for component in all_components(type_):
            own = shown.get(component.name)
            if own is None:
                assert component.rule != MANDATORY, component.name
                continue
            if isinstance(own, ShownPosition):
                self._add_position(path, component, own)
            else:
                self._add_component(path, component, own)

    def _add_component(self, path: str, component: Component, own: Shown) -> None:
        kind = _VARIANTS.get(component.data_type, ua.VariantType.Int32)
        node = f"{path}.{component.name}"
        live = Live(
            kind,
            own.read,
            own.names,
            bool(component.dimensions),
            own.needs_state_view,
            write_name=own.write_name,
            to_session=bool_to_number if kind == ua.VariantType.Boolean else None,
            signal=own.signal,
            factor=own.factor,
            range=(own.low, own.high) if component.type == ANALOG_ITEM else None,
        )
        self._add_variable(node, component, live)
        if component.type == ANALOG_ITEM:
            is_named = bool(component.below[1]) or bool(own.unit)
            self.add_unit(node, own.unit, own.low, own.high, 0, is_named=is_named)

    def _add_variable(self, node: str, component: Component, live: Live) -> None:
        rights = READ | (WRITE if live.write_name else 0) | (HISTORY if live.signal else 0)
        parent = self.id(node.rpartition(".")[0])
        self._nodes.add_variable(
            self.id(node),
            self._types.name(component.name),
            self._types.type(component.type),
            VariableValue(
                self._types.data_type(component.data_type),
                ua.DataValue(StatusCode=ua.StatusCode(ua.StatusCodes.BadWaitingForInitialData)),
                rank=ARRAY if component.dimensions else SCALAR,
                dimensions=component.dimensions if any(component.dimensions) else (),
                rights=rights,
                interval_ms=_INTERVAL_MS,
            ),
        )
        kind = refs.HAS_PROPERTY if component.type == PROPERTY else refs.HAS_COMPONENT
        self._nodes.refer(parent, kind, self.id(node))
        self._live.add(self.id(node), live)

    def _add_fixed(self, path: str, component: Component, value: str) -> None:
        self._add_variable(
            f"{path}.{component.name}", component, Live(ua.VariantType.String, lambda _: value)
        )

    def _add_position(self, path: str, component: Component, own: ShownPosition) -> None:
        node = f"{path}.{component.name}"
        names = own.actual, own.command, own.to_go

        def read(moment: ValueSnapshot) -> CncPositionDataType:
            if not own.actual:
                raise NotSupported
            # nctakt does not have a value without a name: it is not 0
            numbers = [float(moment.values[name]) if name else math.nan for name in names]
            return CncPositionDataType(*numbers)

        needed = tuple(name for name in names if name)
        self._add_variable(node, component, Live(ua.VariantType.ExtensionObject, read, needed))
        for field, name in zip(POSITION_FIELDS, names, strict=True):
            live = Live(
                ua.VariantType.Double,
                _reader(name),
                (name,) if name else (),
                signal=name,
                range=(own.low, own.high),
            )
            part = Component(field, 0, BASE_VARIABLE, "Double")
            self._add_variable(f"{node}.{field}", part, live)
        self.add_unit(node, own.unit, own.low, own.high, self._types.index)

    def add_unit(
        self, node: str, sign: str, low: float, high: float, index: int, *, is_named: bool = True
    ) -> None:
        """Add EURange and EngineeringUnits to a variable, names of namespace ``index``."""
        values: list[tuple[str, Any]] = [("EURange", ua.Range(Low=low, High=high))]
        if is_named:
            shown = unit(sign) if is_unit(sign) else ua.EUInformation()
            values.append(("EngineeringUnits", shown))
        for name, value in values:
            self._add_fixed_property(node, name, value, index)

    def _add_fixed_property(self, node: str, name: str, value: Any, index: int) -> None:
        """Add EURange or EngineeringUnits to a variable, a name of namespace ``index``."""
        self._nodes.add_variable(
            self.id(f"{node}.{name}"),
            ua.QualifiedName(name, index),
            standard(PROPERTY),
            VariableValue(
                self._types.data_type(_UNIT_TYPES[name]),
                ua.DataValue(ua.Variant(value, ua.VariantType.ExtensionObject)),
            ),
        )
        self._nodes.refer(self.id(node), refs.HAS_PROPERTY, self.id(f"{node}.{name}"))

    # --- values by name -------------------------------------------------------------------------

    def _add_values(self, path: str, prefix: str, number: int) -> None:
        """Add the variables, the operator's values and the signals of a channel."""
        for folder in ("V.E", "HLI", "Signals"):
            self._add_folder(path, folder)
        for value in self._host.catalogue.values.values():
            if value.channel != number or not value.name.startswith(prefix):
                continue
            own = value.name[len(prefix) :]
            if own.startswith("V.E."):
                self._add_value(f"{path}.V.E", own[4:], value)
            elif own.startswith("HLI."):
                self._add_value(f"{path}.HLI", own[4:], value)
            elif not own.startswith("V."):
                self._add_value(f"{path}.Signals", own, value)

    def _add_marked(self) -> None:
        """Add the variables that a PLC marks for clients, if there are any."""
        if self._host.marked:
            self._add_folder("CncInterface", "PLC")
        for value in self._host.marked.values():
            self._add_value("CncInterface.PLC", value.name, value, has_past=False)

    def _add_folder(self, path: str, name: str) -> ua.NodeId:
        node = self._nodes.add_object(self.id(f"{path}.{name}"), self.name(name), standard(61))
        self._nodes.refer(self.id(path), refs.HAS_COMPONENT, node)
        return node

    def _add_value(
        self, folder: str, name: str, value: CatalogueValue, *, has_past: bool = True
    ) -> None:
        kind = KINDS[value.type]
        session_name = value.name
        live = Live(
            kind,
            _text_reader(session_name) if value.is_text else _reader(session_name),
            (session_name,),
            write_name=session_name if value.is_writable else "",
            to_session=bool_to_number if kind == ua.VariantType.Boolean else None,
            signal=session_name if has_past and not value.is_text else "",
        )
        node = self.id(f"{folder}.{name}")
        rights = READ | (WRITE if live.write_name else 0) | (HISTORY if live.signal else 0)
        has_unit = is_unit(value.unit)
        self._nodes.add_variable(
            node,
            self.name(name),
            standard(ANALOG_UNIT if has_unit else DATA_ITEM),
            VariableValue(
                standard(int(kind)),
                ua.DataValue(StatusCode=ua.StatusCode(ua.StatusCodes.BadWaitingForInitialData)),
                rights=rights,
                interval_ms=_INTERVAL_MS,
            ),
        )
        self._nodes.refer(self.id(folder), refs.HAS_COMPONENT, node)
        self._live.add(node, live)
        if has_unit:
            self._add_fixed_property(f"{folder}.{name}", "EngineeringUnits", unit(value.unit), 0)


def bool_to_number(value: Value) -> float:
    """Return 1 for true and 0 for false, as the session expects."""
    return 1.0 if value else 0.0


def _reader(name: str) -> Any:
    def read(moment: ValueSnapshot) -> Value:
        if not name:
            raise NotSupported
        return moment.values[name]

    return read


def _text_reader(name: str) -> Any:
    """Return the reader of a text, or of an enumeration, which is a number if no item has it."""
    return lambda moment: str(moment.values[name])


def _component(type_: str, name: str) -> Component:
    return next(one for one in all_components(type_) if one.name == name)


def unit(sign: str) -> ua.EUInformation:
    """Return a unit by its sign."""
    code, name = _UNITS[sign]
    return ua.EUInformation(
        NamespaceUri=_NAMESPACE,
        UnitId=int.from_bytes(code.encode(), "big"),
        DisplayName=ua.LocalizedText(sign, ""),
        Description=ua.LocalizedText(name, "en"),
    )


def is_unit(sign: str) -> bool:
    """Return whether there is a unit of this sign."""
    return sign in _UNITS
