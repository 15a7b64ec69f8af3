# SPDX-License-Identifier: MIT
"""Services shared by all client sessions: values, methods and past of a machine, limits."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.servers.host import Host
from nctakt.servers.opcua.history import History
from nctakt.servers.opcua.limits import Limits
from nctakt.servers.opcua.live_space import LiveSpace
from nctakt.servers.opcua.methods import Methods


@dataclass(frozen=True, slots=True)
class MachineServices:
    """The services of one machine."""

    host: Host
    space: LiveSpace
    methods: Methods
    history: History
    limits: Limits
