# SPDX-License-Identifier: MIT
"""Messages of programs, and alarms about errors, until somebody acknowledges them.

In: notices of the host, the error of each channel. Out: events of CncMessageType and CncAlarmType
to all that subscribe, and the same as messages and alerts of the machine tool. An alarm is active
until its channel no longer has that error; it stays until somebody has acknowledged it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from datetime import datetime
from typing import Any

from asyncua import ua

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic, Severity, Text
from nctakt.results.run import ProgramMessage
from nctakt.servers.clock import MachineClock
from nctakt.servers.host import Host
from nctakt.servers.notices import ServerNotice
from nctakt.servers.opcua.clients.client import Client
from nctakt.servers.opcua.clients.subscriptions import Subscriptions
from nctakt.servers.opcua.events import Event, EventTypes, Field, SeenEvent, base_fields
from nctakt.servers.opcua.model.nodes import standard
from nctakt.servers.opcua.model.types import CompanionTypes
from nctakt.servers.opcua.space.machine_space import MachineSpace
from nctakt.servers.opcua.space.machine_tool_space import MachineToolSpace

#: Alarms that are kept at most; the oldest that is not active goes first.
MAX_ALARMS = 1_000

#: Severities of OPC UA, 1 … 1000.
_SEVERITIES = {Severity.ERROR: 800, Severity.WARNING: 400, Severity.NOTE: 100}
_MESSAGE_SEVERITY = 100

#: Nodes of namespace 0: the server, its class of conditions; events around a refresh.
_SERVER, _PROCESS_CLASS, _REFRESH_START, _REFRESH_END = 2253, 11164, 2787, 2788

_KINDS = ua.VariantType


def _state(en: str, de: str) -> Text:
    return Text(en, de)


_ENABLED = _state("Enabled", "Freigegeben")
_ACTIVE = {True: _state("Active", "Aktiv"), False: _state("Inactive", "Inaktiv")}
_ACKED = {
    True: _state("Acknowledged", "Quittiert"),
    False: _state("Unacknowledged", "Nicht quittiert"),
}
_NOTICES = {
    "refused": Text("refused", "abgelehnt"),
    "ended": Text("ended", "Ende"),
    "stopped": Text("stopped", "angehalten"),
}
#: How a run has ended, in German.
_RUN_STATES = {
    "ended": "Programmende",
    "error": "Fehler",
    "limit": "Grenze erreicht",
    "reset": "Reset",
    "interrupted": "abgebrochen",
}
_PROCESS = _state("ProcessConditionClassType", "ProcessConditionClassType")


@dataclass(slots=True, eq=False)
class Alarm:
    """An alarm; ``node``: its condition. ``channel``: its number, 0 for none.

    ``event_ids``: those that a client may acknowledge it by, the latest last.
    """

    node: ua.NodeId
    found: Diagnostic
    channel: int
    time: datetime
    is_active: bool = True
    is_acked: bool = False
    comment: Any = None
    user: str = ""
    event_ids: list[bytes] = field(default_factory=list)

    @property
    def is_retained(self) -> bool:
        """Whether somebody must still see it."""
        return self.is_active or not self.is_acked


class Alarms:
    """The messages and alarms of a machine."""

    def __init__(
        self,
        host: Host,
        types: CompanionTypes,
        machine: MachineSpace,
        subscriptions: Subscriptions,
        clock: MachineClock,
        event_types: EventTypes,
        tool: MachineToolSpace,
    ) -> None:
        self._tool = tool
        self._host = host
        self._types = types
        self._machine = machine
        self._subscriptions = subscriptions
        self._clock = clock
        self._event_types = event_types
        self._alarms: dict[ua.NodeId, Alarm] = {}
        self._errors: dict[int, int] = {}
        self._tool_notifiers = (tool.messages, tool.root)
        self._serial = 0
        several = len(machine.channels) > 1
        self.error_names = {
            number: f"CH{number}.HLI.ERROR" if several else "HLI.ERROR"
            for number in machine.channels
        }

    # --- events ---------------------------------------------------------------------------------

    def receive(self, notice: ServerNotice) -> None:
        """Send a notice to the subscribers."""
        if notice.kind == "message" and notice.message is not None:
            self._report_message(notice.message)
        elif notice.kind == "diagnostic" and notice.diagnostic is not None:
            self._take_diagnostic(notice.diagnostic, notice.tick)
        elif notice.kind in ("refused", "ended", "stopped"):
            time = self._clock.time(notice.tick)
            self._report_event(0, notice_text(notice), time, _MESSAGE_SEVERITY)

    def _report_message(self, message: ProgramMessage) -> None:
        channel = message.channel or 1
        tick = message.time_us // self._clock.cycle_time_us
        text = Text(message.text, message.text)
        self._report_event(channel, text, self._clock.time(tick), _MESSAGE_SEVERITY)

    def _take_diagnostic(self, found: Diagnostic, tick: int) -> None:
        severity, time = _SEVERITIES[found.severity], self._clock.time(tick)
        if found.severity is not Severity.ERROR:
            text = Text(f"{found.id}: {found.text('en')}", f"{found.id}: {found.text('de')}")
            self._report_event(0, text, time, severity, found)
            return
        self._serial += 1
        node = self._machine.id(f"Alarm.{found.id}.{self._serial}")
        alarm = Alarm(node, found, self._channel_of(found.id), time)
        self._make_room()
        self._alarms[node] = alarm
        self._report_alarm(alarm, time)

    def _channel_of(self, number: int) -> int:
        """Return the channel that has an error of this number; 0: none yet."""
        standing = [one for one, error in self._errors.items() if error == number]
        return standing[0] if standing else 0

    def _make_room(self) -> None:
        while len(self._alarms) >= MAX_ALARMS:
            idle = [one.node for one in self._alarms.values() if not one.is_active]
            del self._alarms[(idle or list(self._alarms))[0]]

    def look(self) -> None:
        """Assign alarms the channel that has their error; end them when it no longer has it."""
        values = self._host.store.values
        for number, name in self.error_names.items():
            error, before = int(values.get(name, 0.0)), self._errors.get(number, 0)
            if error == before:
                continue
            self._errors[number] = error
            for alarm in list(self._alarms.values()):
                is_its_own = alarm.channel in (0, number) and alarm.is_active
                if is_its_own and alarm.found.id == error:
                    alarm.channel = number
                elif is_its_own and before == alarm.found.id:
                    alarm.is_active = False
                    self._report_alarm(alarm, self._clock.time(self._host.store.tick))

    # --- events ---------------------------------------------------------------------------------

    def _notifiers(self, channel: int) -> Sequence[ua.NodeId]:
        own = self._machine.channels.get(channel)
        above = (standard(_SERVER), self._machine.interface)
        return above if own is None else (*above, own)

    def _source(self, channel: int) -> tuple[ua.NodeId, str]:
        own = self._machine.channels.get(channel)
        if own is None:
            return self._machine.interface, "CncInterface"
        return own, f"Channel_{channel}"

    def _event_id(self) -> bytes:
        self._serial += 1
        return hashlib.sha256(f"{self._clock.unix_us(0)} {self._serial}".encode()).digest()[:16]

    def _report_event(
        self,
        channel: int,
        text: Text,
        time: datetime,
        severity: int,
        found: Diagnostic | None = None,
    ) -> None:
        type_, event_id = self._types.type("CncMessageType"), self._event_id()
        source, name = self._source(channel)
        values = base_fields(type_, event_id, source, name, time, text, severity)
        self._send(Event(type_, event_id, values), self._notifiers(channel))
        if found is not None and found.severity is Severity.WARNING:
            passing = Alarm(ua.NodeId(), found, channel, time, is_active=False, is_acked=True)
            self._send_alert(self._event_of(passing, time))
            return
        identifier = "" if found is None else str(found.id)
        fields = self._as_the_tools(values, self._tool.message_type)
        fields["Identifier"] = identifier, _KINDS.String
        self._send(Event(self._tool.message_type, event_id, fields), self._tool_notifiers)

    def _as_the_tools(self, values: Mapping[str, Field], type_: ua.NodeId) -> dict[str, Field]:
        """Return the fields of an event as one of the machine tool."""
        return {
            **values,
            "EventType": (type_, _KINDS.NodeId),
            "SourceNode": (self._tool.messages, _KINDS.NodeId),
            "SourceName": ("Messages", _KINDS.String),
        }

    def _send_alert(self, event: Event) -> None:
        """Publish an alarm as an alert of the machine tool."""
        type_ = self._tool.type("AlertType")
        fields = self._as_the_tools(event.values, type_)
        fields["ErrorCode"] = event.values["AlarmIdentifier"]
        self._send(Event(type_, event.id, fields), self._tool_notifiers)

    def _report_alarm(self, alarm: Alarm, time: datetime) -> None:
        event = self._event_of(alarm, time)
        self._send(event, self._notifiers(alarm.channel))
        self._send_alert(event)
        if not alarm.is_retained:
            self._alarms.pop(alarm.node, None)

    def _event_of(self, alarm: Alarm, time: datetime) -> Event:
        found, type_ = alarm.found, self._types.type("CncAlarmType")
        event_id = self._event_id()
        alarm.event_ids = [*alarm.event_ids, event_id][-100:]
        source, name = self._source(alarm.channel)
        severity = _SEVERITIES[found.severity]
        text = Text(found.text("en"), found.text("de"))
        remedy = Text(found.remedy("en"), found.remedy("de"))
        cause = found.message.cause
        position = "" if found.span is None else str(found.span)
        values: dict[str, Field] = {
            **base_fields(type_, event_id, source, name, time, text, severity),
            "NodeId": (alarm.node, _KINDS.NodeId),
            "ConditionClassId": (standard(_PROCESS_CLASS), _KINDS.NodeId),
            "ConditionClassName": (_PROCESS, _KINDS.LocalizedText),
            "ConditionName": (str(found.id), _KINDS.String),
            "BranchId": (ua.NodeId(), _KINDS.NodeId),
            "Retain": (alarm.is_retained, _KINDS.Boolean),
            **_two_state("EnabledState", _ENABLED, is_true=True),
            **_two_state("AckedState", _ACKED[alarm.is_acked], is_true=alarm.is_acked),
            **_two_state("ActiveState", _ACTIVE[alarm.is_active], is_true=alarm.is_active),
            "Quality": (ua.StatusCode(), _KINDS.StatusCode),
            "LastSeverity": (severity, _KINDS.UInt16),
            "Comment": (alarm.comment or ua.LocalizedText("", ""), _KINDS.LocalizedText),
            "ClientUserId": (alarm.user, _KINDS.String),
            "InputNode": (ua.NodeId(), _KINDS.NodeId),
            "SuppressedOrShelved": (False, _KINDS.Boolean),
            "AlarmIdentifier": (str(found.id), _KINDS.String),
            "AuxParameters": ((remedy, cause, position), _KINDS.String),
            "HelpSource": (f"nctakt explain {found.id}", _KINDS.String),
        }
        return Event(type_, event_id, values)

    def _send(self, event: Event, notifiers: Sequence[ua.NodeId]) -> None:
        for subscription in self._subscriptions.subscriptions.values():
            language = self._subscriptions.language_of(subscription)
            seen = SeenEvent(event, language, self._event_types)
            subscription.notify_event(seen, notifiers)

    # --- answers of clients ---------------------------------------------------------------------

    def answer(
        self,
        session: Client,
        node: ua.NodeId,
        event_id: bytes,
        comment: Any,
        *,
        is_acknowledged: bool,
    ) -> int:
        """Take a comment, or an acknowledgement with a comment; return the status."""
        codes = ua.StatusCodes
        alarm = self._alarms.get(node)
        if alarm is None:
            return int(codes.BadNodeIdUnknown)
        if event_id not in alarm.event_ids:
            return int(codes.BadEventIdUnknown)
        if is_acknowledged and alarm.is_acked:
            return int(codes.BadConditionBranchAlreadyAcked)
        alarm.is_acked = alarm.is_acked or is_acknowledged
        if comment is not None and comment.Text:
            alarm.comment = comment
        alarm.user = session.client
        self._host.log.note(
            "acknowledged" if is_acknowledged else "comment",
            endpoint="opcua",
            client=session.client,
            alarm=alarm.found.id,
        )
        self._report_alarm(alarm, self._clock.time(self._host.store.tick))
        return 0

    def refresh(self, session: Client, number: int, item: int | None) -> int:
        """Send all active alarms again to a subscription; return the status."""
        subscription = self._subscriptions.subscriptions.get(number)
        if subscription is None or subscription.session_id != session.session_id:
            return int(ua.StatusCodes.BadSubscriptionIdInvalid)
        if item is not None and item not in subscription.items:
            return int(ua.StatusCodes.BadMonitoredItemIdInvalid)
        time = self._clock.time(self._host.store.tick)
        events = [self._around(_REFRESH_START, time)]
        events += [self._event_of(alarm, time) for alarm in self._alarms.values()]
        events.append(self._around(_REFRESH_END, time))
        for event in events:
            seen = SeenEvent(event, session.language, self._event_types)
            for known in subscription.items.values():
                if known.is_event and item in (None, known.id):
                    subscription.notify_item(seen, known)
        return 0

    def _around(self, number: int, time: datetime) -> Event:
        type_, event_id = standard(number), self._event_id()
        nothing = Text("", "")
        values = base_fields(type_, event_id, standard(_SERVER), "Server", time, nothing, 100)
        return Event(type_, event_id, values)


def notice_text(notice: ServerNotice) -> Text:
    """Return the text of a notice of the session."""
    kind = _NOTICES[notice.kind]
    state = _RUN_STATES.get(notice.text) if notice.kind == "ended" else None
    german = notice.text_de or notice.text if state is None else state
    return Text(f"{kind.en}: {notice.text}", f"{kind.de}: {german}")


def _two_state(name: str, text: Text, *, is_true: bool) -> dict[str, Field]:
    return {name: (text, _KINDS.LocalizedText), f"{name}/Id": (is_true, _KINDS.Boolean)}
