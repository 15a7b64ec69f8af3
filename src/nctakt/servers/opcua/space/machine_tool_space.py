# SPDX-License-Identifier: MIT
"""The machine as OPC UA for Machine Tools shows it: monitoring, production, notifications.

In: the values of the nodes of the CNC model, the states of channels. Out: an object below
``Machines``, as dashboards look for it, whose IDs are names
(``MachineTool.Monitoring.Channel_1.ChannelState``). Values unknown to nctakt have no node if the
model makes it optional.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import PurePath
from typing import NamedTuple

from asyncua import ua

from nctakt.base.version import __version__
from nctakt.kernel import codes
from nctakt.lists.machine.machine import ChannelConfiguration
from nctakt.servers.host import Host
from nctakt.servers.opcua.live_space import LiveSpace
from nctakt.servers.opcua.model import machine_tool as model
from nctakt.servers.opcua.model import nodes as refs
from nctakt.servers.opcua.model.companion import ANALOG_RANGE, MANDATORY, PROPERTY
from nctakt.servers.opcua.model.machine_tool import (
    ABORTED,
    ENDED,
    INITIALIZING,
    INTERRUPTED,
    RUNNING,
)
from nctakt.servers.opcua.model.nodes import Nodes, VariableValue, standard, text
from nctakt.servers.opcua.model.types import CompanionTypes, all_components
from nctakt.servers.opcua.space.components import Shown, ShownPosition, fixed
from nctakt.servers.opcua.space.machine_space import MachineSpace
from nctakt.servers.opcua.values import Live, NotSupported, Value, ValueSnapshot
from nctakt.session.listening import Frame

_FOLDER, _OBJECTS = standard(61), standard(85)
_KINDS = ua.VariantType
#: Data types -> types on the wire; enumerations are Int32.
_VARIANTS = {
    "Boolean": _KINDS.Boolean,
    "Double": _KINDS.Double,
    "String": _KINDS.String,
    "UInt16": _KINDS.UInt16,
    "UInt32": _KINDS.UInt32,
}
#: ChannelMode and MachineOperationMode for programs.
_AUTOMATIC_CHANNEL, _AUTOMATIC_MACHINE = 0, 1
_ROOT = "MachineTool"

Components = Mapping[str, Shown | ShownPosition]


class Indices(NamedTuple):
    """The numbers of the namespaces of the models."""

    di: int
    machinery: int
    machine_tool: int


class MachineToolSpace:
    """The nodes of the machine; ``messages``: the object of its events, ``root``: the machine."""

    def __init__(
        self, nodes: Nodes, live: LiveSpace, host: Host, machine: MachineSpace, indices: Indices
    ) -> None:
        self._nodes = nodes
        self._live = live
        self._host = host
        self._machine = machine
        self.indices = indices
        self._types = self._add_types()
        self.states = ProgramStates(host)
        self.root = machine.id(_ROOT)
        self.messages = machine.id(f"{_ROOT}.Notification.Messages")
        self.message_type = machine.id("MessageEventType")

    def type(self, name: str) -> ua.NodeId:
        """Return the ID of a type."""
        return self._types.type(name)

    # --- types ----------------------------------------------------------------------------------

    def _add_types(self) -> CompanionTypes:
        group, group_number = model.FUNCTIONAL_GROUP
        base = self._add_type(self.indices.di, group, group_number, _FOLDER)
        for name, number in model.MACHINERY_TYPES:
            base = self._add_type(self.indices.machinery, name, number, base)
        types = CompanionTypes(
            self._nodes,
            self.indices.machine_tool,
            model.TYPES,
            model.ENUMERATIONS,
            {model.MACHINE_IDENTIFICATION: base},
        )
        types.add_all()
        for number, state in enumerate(model.STATES):
            self._add_state(types, number, state)
        return types

    def _add_type(self, index: int, name: str, number: int, base: ua.NodeId) -> ua.NodeId:
        node, named = ua.NodeId(number, index), ua.QualifiedName(name, index)
        return self._nodes.add_type(node, ua.NodeClass.ObjectType, named, base)

    def _add_state(self, types: CompanionTypes, number: int, state: model.State) -> None:
        node = types.id(state.number)
        self._nodes.add_object(node, types.name(state.name), standard(state.type))
        self._nodes.refer(types.type(model.PROGRAM_STATES), refs.HAS_COMPONENT, node)
        own = types.id(state.number_node)
        self._nodes.add_variable(
            own,
            types.name("StateNumber", is_standard=True),
            standard(PROPERTY),
            VariableValue(
                types.data_type("UInt32"), ua.DataValue(ua.Variant(number, _KINDS.UInt32))
            ),
        )
        self._nodes.refer(node, refs.HAS_PROPERTY, own)
        self._nodes.refer(own, refs.HAS_RULE, standard(MANDATORY))

    # --- the machine ----------------------------------------------------------------------------

    def add_all(self) -> None:
        """Add all nodes of the machine."""
        index = self.indices.machinery
        machines = ua.NodeId(model.MACHINES, index)
        self._nodes.add_object(machines, ua.QualifiedName("Machines", index), _FOLDER)
        self._nodes.refer(_OBJECTS, refs.ORGANIZES, machines)
        self._nodes.add_object(
            self.root,
            self._machine.name(self._host.machine.name),
            self.type("MachineToolType"),
            is_notifier=True,
        )
        self._nodes.refer(machines, refs.HAS_COMPONENT, self.root)
        self._add_identification()
        self._add_object(_ROOT, "Equipment", "EquipmentType")
        monitoring = self._add_object(_ROOT, "Monitoring", "MonitoringType")
        operation = self._add_object(monitoring, "MachineTool", "MachineOperationMonitoringType")
        self._add_values(
            operation,
            "MachineOperationMonitoringType",
            {"OperationMode": fixed(_AUTOMATIC_MACHINE)},
        )
        for channel in self._host.machine.channels:
            self._add_channel(monitoring, channel)
        self._add_production()
        notification = self._add_object(_ROOT, "Notification", "NotificationType")
        self._add_object(notification, "Messages", "MessagesType", is_notifier=True)
        self._nodes.refer(self.root, refs.HAS_NOTIFIER, self.messages)
        self._nodes.add_type(
            self.message_type,
            ua.NodeClass.ObjectType,
            self._machine.name("MessageEventType"),
            self.type("NotificationEventType"),
        )

    def _add_identification(self) -> None:
        """Add maker and name of the machine: those of nctakt, not of a real plate."""
        di, machine = self.indices.di, self._host.machine
        path = f"{_ROOT}.Identification"
        node = self._nodes.add_object(
            self._machine.id(path),
            ua.QualifiedName("Identification", di),
            self.type("MachineToolIdentificationType"),
        )
        self._nodes.refer(self.root, refs.HAS_ADD_IN, node)
        for name, value in (
            ("Manufacturer", text("nctakt")),
            ("Model", text(machine.name)),
            ("ProductInstanceUri", f"urn:nctakt:{machine.name}"),
            ("SerialNumber", machine.name),
            ("SoftwareRevision", __version__),
        ):
            kind = _KINDS.String if isinstance(value, str) else _KINDS.LocalizedText
            self._add_variable(
                f"{path}.{name}",
                ua.QualifiedName(name, di),
                PROPERTY,
                standard(int(kind)),
                Live(kind, _constant(value)),
            )

    def _add_channel(self, monitoring: str, channel: ChannelConfiguration) -> None:
        """Add a channel with its modifiers, and its spindles."""
        machine, number = self._machine, channel.number
        several = len(machine.channels) > 1
        prefix = f"CH{number}." if several else ""
        shown = machine.shown[f"CncChannelList.{number}"]
        path = self._add_object(
            monitoring, f"Channel_{number}", "ChannelMonitoringType", is_own=True
        )
        self._add_values(
            path,
            "ChannelMonitoringType",
            {
                "Name": fixed(f"Channel_{number}"),
                "ChannelMode": fixed(_AUTOMATIC_CHANNEL),
                "ChannelState": shown["ActStatus"],
                "FeedOverride": shown["CmdOverride"],
            },
        )
        modifiers = self._add_object(path, "ChannelModifiers", "ChannelModifierType")
        optional = f"{prefix}HLI.OPTIONAL_STOP"
        self._add_values(
            modifiers,
            "ChannelModifierType",
            {
                "DryRun": fixed(False),  # nctakt does not have it: it is never on
                "OptionalStop": Shown(lambda moment: moment.values[optional], (optional,)),
                "SingleStep": shown["BlockMode"],
            },
        )
        for spindle in channel.spindles:
            name = f"{prefix}{spindle.spindle.name}"
            self._add_spindle(monitoring, name, machine.shown[f"CncSpindleList.{name}"])

    def _add_spindle(self, monitoring: str, name: str, shown: Components) -> None:
        speed = shown["ActSpeed"]
        assert isinstance(speed, Shown)
        path = self._add_object(monitoring, f"Spindle_{name}", "SpindleMonitoringType", is_own=True)
        self._add_values(
            path,
            "SpindleMonitoringType",
            {
                "Name": fixed(name),
                "IsRotating": Shown(lambda moment: speed.read(moment) != 0.0, speed.names),
                "Override": shown["CmdOverride"],
            },
        )

    # --- production -----------------------------------------------------------------------------

    def _add_production(self) -> None:
        """Add the program of the first channel with its state, and the parts."""
        states = self.states
        shown = self._machine.shown[f"CncChannelList.{states.channel}"]
        name_of = shown["ActMainProgramName"]
        assert isinstance(name_of, Shown)

        def name(moment: ValueSnapshot) -> str:
            if states.channel in moment.blocks:
                return str(name_of.read(moment))
            if states.first_program and not states.has_run:
                return PurePath(states.first_program).name
            raise NotSupported(int(ua.StatusCodes.BadNoData))

        production = self._add_object(_ROOT, "Production", "ProductionType")
        program = self._add_object(production, "ActiveProgram", "ProductionActiveProgramType")
        self._add_values(
            program,
            "ProductionActiveProgramType",
            {"Name": Shown(name), "NumberInList": fixed(0)},
        )
        self._add_state_variable(self._add_object(program, "State", model.PROGRAM_STATES))
        statistics = self._add_object(production, "Statistics", "ProductionStatisticsType")
        self._add_values(
            statistics,
            "ProductionStatisticsType",
            {"PartsProducedInLifetime": Shown(lambda _: states.parts)},
        )

    def _add_state_variable(self, state: str) -> None:
        """Add the state of the program: its name, the ID of its node, its number."""
        states, path = self.states, f"{state}.CurrentState"

        def number(moment: ValueSnapshot) -> int:
            return states.state(moment)

        for own, name, type_, data_type, live in (
            (
                path,
                "CurrentState",
                model.STATE_VARIABLE,
                standard(21),
                Live(
                    _KINDS.LocalizedText,
                    lambda moment: text(model.STATES[number(moment)].name),
                    states.names,
                ),
            ),
            (
                f"{path}.Id",
                "Id",
                PROPERTY,
                standard(17),
                Live(
                    _KINDS.NodeId,
                    lambda moment: self._types.id(model.STATES[number(moment)].number),
                    states.names,
                ),
            ),
            (
                f"{path}.Number",
                "Number",
                PROPERTY,
                standard(7),
                Live(_KINDS.UInt32, number, states.names),
            ),
        ):
            self._add_variable(own, ua.QualifiedName(name, 0), type_, data_type, live)

    # --- nodes ----------------------------------------------------------------------------------

    def _add_object(
        self,
        parent: str,
        name: str,
        type_: str,
        *,
        is_own: bool = False,
        is_notifier: bool = False,
    ) -> str:
        """Add an object below another one; ``is_own``: its name is nctakt's. Return its path."""
        path = f"{parent}.{name}"
        named = self._machine.name(name) if is_own else self._types.name(name)
        node = self._nodes.add_object(
            self._machine.id(path), named, self.type(type_), is_notifier=is_notifier
        )
        self._nodes.refer(self._machine.id(parent), refs.HAS_COMPONENT, node)
        return path

    def _add_values(self, path: str, type_: str, shown: Components) -> None:
        """Add the values of an object."""
        for component in all_components(type_):
            own = shown[component.name]
            assert isinstance(own, Shown)
            kind = _VARIANTS.get(component.data_type, _KINDS.Int32)
            has_unit = component.type == ANALOG_RANGE
            assert isinstance(component.type, int)
            live = Live(
                kind,
                own.read,
                own.names,
                needs_state_view=own.needs_state_view,
                range=(own.low, own.high) if has_unit else None,
            )
            name = self._types.name(component.name, is_standard=component.is_standard)
            data_type = self._types.data_type(component.data_type)
            self._add_variable(f"{path}.{component.name}", name, component.type, data_type, live)
            if has_unit:
                node = f"{path}.{component.name}"
                self._machine.add_unit(node, own.unit or "%", own.low, own.high, 0)

    def _add_variable(
        self, path: str, name: ua.QualifiedName, type_: int, data_type: ua.NodeId, live: Live
    ) -> None:
        node = self._machine.id(path)
        self._nodes.add_variable(
            node,
            name,
            standard(type_),
            VariableValue(
                data_type,
                ua.DataValue(StatusCode=ua.StatusCode(ua.StatusCodes.BadWaitingForInitialData)),
            ),
        )
        kind = refs.HAS_PROPERTY if type_ == PROPERTY else refs.HAS_COMPONENT
        self._nodes.refer(self._machine.id(path.rpartition(".")[0]), kind, node)
        self._live.add(node, live)


def _constant(value: Value) -> Callable[[ValueSnapshot], Value]:
    return lambda _: value


class ProgramStates:
    """The state of the program of the first channel.

    ``names``: the values that it needs. ``parts``: programs that have ended since the start of the
    server. ``first_program``: the one it was started with, "" for none; ``has_run``: whether any
    has begun.
    """

    def __init__(self, host: Host) -> None:
        machine = host.machine
        self.channel = machine.channels[0].number
        prefix = f"CH{self.channel}." if len(machine.channels) > 1 else ""
        self._state, self._armed = f"{prefix}HLI.STATE", f"{prefix}HLI.ARMED"
        self._stops = (f"{prefix}HLI.PAUSED", f"{prefix}HLI.FEED_HOLD")
        self.names = (self._state, self._armed, *self._stops)
        self.first_program = next(iter(host.session.description.texts), "")
        self.parts = 0
        self.has_run = False
        self._has_ended = False

    def receive(self, frame: Frame) -> None:
        """Notice a program that has begun or ended."""
        if self._state not in frame.values:
            return
        ends = sum(one.kind == "end" and one.channel in (0, self.channel) for one in frame.events)
        self.parts += ends
        if ends:
            self.has_run = self._has_ended = True
        if frame.values[self._state] == codes.CHANNEL_RUNNING:
            self.has_run, self._has_ended = True, False

    def state(self, moment: ValueSnapshot) -> int:
        """Return the number of the state."""
        state = moment.values.get(self._state)
        if state is None:
            raise NotSupported(int(ua.StatusCodes.BadWaitingForInitialData))
        if state == codes.CHANNEL_RUNNING:
            is_held = any(moment.values[name] for name in self._stops)
            return INTERRUPTED if is_held else RUNNING
        if state in (codes.CHANNEL_ERROR, codes.CHANNEL_RESET):
            return ABORTED
        return ENDED if self._has_ended and not moment.values[self._armed] else INITIALIZING
