# SPDX-License-Identifier: MIT
"""The state of the machine's program, and how many parts it has made.

In: frames of the session with its events and the state of the first channel. Out: the state as
OPC UA for Machine Tools numbers it. A part is a program that has come to its end: M30.
"""

from __future__ import annotations

from asyncua import ua

from nctakt.kernel import codes
from nctakt.servers.host import Host
from nctakt.servers.opcua.model.machine_tool import (
    ABORTED,
    ENDED,
    INITIALIZING,
    INTERRUPTED,
    RUNNING,
)
from nctakt.servers.opcua.values import NotSupported, ValueSnapshot
from nctakt.session.listening import Frame


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
