# SPDX-License-Identifier: MIT
"""The endpoint of OPC UA: a machine's session for HMIs, control systems and other clients.

In: the host of all endpoints, an address. Out: a server with the companion models for CNC and
machine tools, their values, events, methods and past.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Sequence
from pathlib import Path

from asyncua import ua

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.servers.address import is_loopback, listen_at
from nctakt.servers.host import Host
from nctakt.servers.opcua.alarms import Alarms
from nctakt.servers.opcua.clients.security import Security
from nctakt.servers.opcua.clients.subscriptions import Subscriptions
from nctakt.servers.opcua.events import EventTypes
from nctakt.servers.opcua.history import History
from nctakt.servers.opcua.limits import Limits
from nctakt.servers.opcua.live_space import LiveSpace
from nctakt.servers.opcua.machine_services import MachineServices
from nctakt.servers.opcua.methods import Methods
from nctakt.servers.opcua.model import nodes as refs
from nctakt.servers.opcua.model.companion import CNC_URI
from nctakt.servers.opcua.model.machine_tool import DI_URI, MACHINE_TOOL_URI, MACHINERY_URI
from nctakt.servers.opcua.model.nodes import Nodes, standard
from nctakt.servers.opcua.model.position import register_position
from nctakt.servers.opcua.model.types import CompanionTypes
from nctakt.servers.opcua.server import CncServer
from nctakt.servers.opcua.space.components import ProgramTexts
from nctakt.servers.opcua.space.cycle_space import CycleSpace
from nctakt.servers.opcua.space.machine_space import OWN_URI, MachineSpace
from nctakt.servers.opcua.space.machine_tool_space import Indices, MachineToolSpace

#: The port of OPC UA.
PORT = 4840

#: How often it is looked for new realtime cycles, in seconds.
_CYCLES_S = 0.5


class OpcuaEndpoint:
    """OPC UA at an address; ``folder``: of certificate and users, for other addresses than this
    computer's own. Raises ``Failure`` where that cannot be used.
    """

    def __init__(
        self, host: Host, address: tuple[str, int], folder: Path, limits: Limits | None = None
    ) -> None:
        self._host = host
        self._address = address
        self._limits = limits or Limits()
        self.max_connections = self._limits.connections
        self.security = None if is_loopback(address[0]) else Security(folder)
        self._tasks: list[asyncio.Task[None]] = []
        self._unlisten: list[Callable[[], None]] = []

    async def prepare(self) -> None:
        """Build the address space."""
        host, limits = self._host, self._limits
        self.server = server = CncServer(limits, host.log, self.security)
        await server.init()
        uris = (CNC_URI, OWN_URI, DI_URI, MACHINERY_URI, MACHINE_TOOL_URI)
        cnc, own, *others = [await server.register_namespace(uri) for uri in uris]
        register_position(cnc)
        internal = server.iserver
        nodes = Nodes(internal.aspace)
        self.space = space = LiveSpace(internal.aspace, host, host.clock)
        self.subscriptions = Subscriptions(space, limits, internal.make_room, internal.refuse)
        internal.subscription_service = internal.isession.subscription_service = self.subscriptions
        types = CompanionTypes(nodes, cnc)
        types.add_all()
        machine = MachineSpace(nodes, types, space, host, own)
        machine.add_all(ProgramTexts(_known_texts(host), self._read_text))
        self._cycles = CycleSpace(nodes, machine, space)
        self.tool = tool = MachineToolSpace(nodes, space, host, machine, Indices(*others))
        tool.add_all()
        self._alarms = Alarms(
            host, types, machine, self.subscriptions, host.clock, EventTypes(internal.aspace), tool
        )
        nodes.refer(standard(ua.ObjectIds.Server), refs.HAS_NOTIFIER, machine.interface)
        for channel in machine.channels.values():
            nodes.refer(machine.interface, refs.HAS_EVENT_SOURCE, channel)
        methods = Methods(nodes, machine, host, self._alarms)
        history = History(space, host, limits)
        internal.services = MachineServices(host, space, methods, history, limits)
        await server.publish_limits()
        await host.store.subscribe((*self._alarms.error_names.values(), *tool.states.names))
        host.want_events()

    async def open(self) -> str:
        """Serve clients from now on; return the address. Raises ``Failure``."""
        host = self._host
        _, address = await listen_at("OPC UA", self._address, self.server.listen)
        self._tasks = [asyncio.get_running_loop().create_task(self._look())]
        self._unlisten = [
            host.notices.listen(self._alarms.receive),
            host.store.listen(lambda _: self._alarms.look()),
            host.store.listen(self.tool.states.receive),
        ]
        if self.security is not None and self.security.made_password:
            host.log.note("first user", endpoint="opcua", folder=str(self.security.folder))
        return f"opc.tcp://{address}/"

    def _read_text(self, file: str) -> Sequence[str]:
        """Return the lines of a program that was selected later; none if it cannot be read."""
        try:
            return FileAccess([]).read_lines(Path(file))
        except (Failure, OSError):
            return ()

    async def _look(self) -> None:
        """Look for realtime cycles that have no node yet."""
        while True:
            with contextlib.suppress(Failure):
                self._cycles.show(await self._host.ask(self._host.session.cycles))
            await asyncio.sleep(_CYCLES_S)

    async def close(self) -> None:
        """Inform clients that it ends, and stop serving."""
        for task in self._tasks:
            task.cancel()
        while self._unlisten:
            self._unlisten.pop()()
        self.subscriptions.stop()
        await self.server.stop()


def _known_texts(host: Host) -> dict[str, Sequence[str]]:
    return dict(host.session.description.texts)
