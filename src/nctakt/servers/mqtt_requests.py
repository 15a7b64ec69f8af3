# SPDX-License-Identifier: MIT
"""Input of the endpoint for MQTT: the broker's address, and the requests of clients.

In: a URL, bytes of a message. Out: the broker, the values to write, the key to press.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections.abc import Callable, Mapping
from typing import Any, cast
from urllib.parse import urlsplit

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.servers import INVALID_BROKER
from nctakt.servers.host import KEYS, Key
from nctakt.servers.store import Scalar

#: The ports of brokers, without and with TLS.
_PORTS = {"mqtt": 1883, "mqtts": 8883}

#: The environment variables with the user and the password of the broker.
USER, PASSWORD = "NCTAKT_MQTT_USER", "NCTAKT_MQTT_PASSWORD"

#: The topics of requests.
REQUESTS = ("write", "press", "select")

#: Maximum bytes of one request.
_MAX_REQUEST = 65_536

#: How many requests wait for their turn at most.
MAX_WAITING = 100


@dataclass(frozen=True, slots=True)
class Broker:
    """Where a broker is, and the root of the topics there."""

    host: str
    port: int
    has_tls: bool
    root: str


class RequestQueue(asyncio.Queue[Any]):
    """Waiting requests of a broker; ``refuse`` reports why one of them is dropped.

    It keeps just enough of an overlong request to show its length.
    """

    def __init__(self, root: str, refuse: Callable[[str], None]) -> None:
        super().__init__(MAX_WAITING)
        self._topics = {f"{root}/{name}" for name in REQUESTS}
        self._refuse = refuse

    def put_nowait(self, item: Any) -> None:
        """Take a request, unless too many wait."""
        if str(item.topic) not in self._topics:
            return  # some brokers send unsubscribed messages
        if self.full():
            self._refuse(f"more than {MAX_WAITING} requests wait")
            return
        if isinstance(item.payload, bytes):
            item.payload = item.payload[: _MAX_REQUEST + 1]
        super().put_nowait(item)


def read_broker(url: str) -> Broker:
    """Return the broker of ``mqtt://HOST[:PORT][/ROOT]``; raises ``Failure`` for another text."""
    with contextlib.suppress(ValueError):
        parts = urlsplit(url)
        is_open = parts.username is None and parts.password is None
        root = parts.path.strip("/") or "nctakt"
        if parts.scheme in _PORTS and parts.hostname and is_open and not {"#", "+"} & set(url):
            port = parts.port or _PORTS[parts.scheme]
            if not parts.query and not parts.fragment:
                return Broker(parts.hostname, port, parts.scheme == "mqtts", root)
    shown = url.rpartition("@")[2] if "@" in url else url  # the part before may be secret
    raise Failure(diagnostic(INVALID_BROKER, text=shown, user=USER, password=PASSWORD))


def read_request(payload: bytes) -> dict[str, Any]:
    """Return the object of a request; raises ``ValueError`` for anything else."""
    if len(payload) > _MAX_REQUEST:
        raise ValueError(f"a request has at most {_MAX_REQUEST} bytes")
    try:
        request = json.loads(payload)
    except (ValueError, RecursionError) as error:
        raise ValueError(f"not JSON: {error}") from error
    if not isinstance(request, dict):
        raise ValueError("a request is an object")
    return request


def values_of(request: Mapping[str, Any]) -> dict[str, Scalar]:
    """Return the values of a write; raises ``ValueError`` for anything else."""
    values = request.get("values")
    if not isinstance(values, dict) or not values:
        raise ValueError('write {"values": {"V.E.NAME": 1}}')
    found: dict[str, Scalar] = {}
    for name, value in values.items():
        if not isinstance(value, int | float | str):
            raise ValueError(f"{name} needs a number, true, false or a text")
        try:
            found[name] = value if isinstance(value, str) else float(value)
        except OverflowError:
            raise ValueError(f"{name}: the number is too large") from None
    return found


def program_of(request: Mapping[str, Any], channels: int) -> tuple[str, int]:
    """Return program and channel of a request; raises ``ValueError`` for anything else."""
    program, channel = request.get("program"), request.get("channel", 1)
    if not isinstance(program, str) or not program or "\0" in program:
        raise ValueError('select {"program": "FILE"}')
    if type(channel) is not int or not 1 <= channel <= channels:
        raise ValueError(f"channel must be 1 … {channels}")
    return program, channel


def key_of(request: Mapping[str, Any]) -> tuple[Key, int]:
    """Return key and channel of a request; raises ``ValueError`` for anything else."""
    key, channel = request.get("key"), request.get("channel", 1)
    if key not in KEYS or type(channel) is not int:
        raise ValueError(f"key must be one of {', '.join(KEYS)}, channel a whole number")
    return cast("Key", key), channel
