# SPDX-License-Identifier: MIT
"""Addresses of endpoints: ``HOST:PORT`` -> host and port, and a server that listens there."""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
from collections.abc import Awaitable, Callable, Collection

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.servers import (
    ENDPOINT_ADDRESS_NOT_USABLE,
    INVALID_ENDPOINT_ADDRESS,
    INVALID_NETWORK,
)

#: Addresses that begin alike.
Network = ipaddress.IPv4Network | ipaddress.IPv6Network

#: The default address of an endpoint: this computer alone.
LOOPBACK = "127.0.0.1"

_MAX_PORT = 65535


def read_address(option: str, text: str, port: int) -> tuple[str, int]:
    """Return host and port of ``HOST:PORT``, ``[IPV6]:PORT`` or a numeric address (``port``).

    Raises ``Failure`` (901352) for another text.
    """
    with contextlib.suppress(ValueError):
        return str(ipaddress.ip_address(text.removeprefix("[").removesuffix("]"))), port
    host, _, number = text.rpartition(":")
    bare = host.removeprefix("[").removesuffix("]")
    is_port = number.isascii() and number.isdigit() and int(number[:6]) <= _MAX_PORT
    is_host = bool(bare) and "/" not in bare and (":" not in bare or host.startswith("["))
    if not is_port or not is_host:
        raise Failure(diagnostic(INVALID_ENDPOINT_ADDRESS, option=option, text=text))
    return bare, int(number)


def is_loopback(host: str) -> bool:
    """Return whether an address belongs to this computer alone, out of reach of others."""
    with contextlib.suppress(ValueError):
        return ipaddress.ip_address(host).is_loopback
    return host == "localhost"


def read_network(option: str, text: str) -> Network:
    """Return the addresses of ``ADDRESS`` or ``ADDRESS/BITS``; raises ``Failure`` (902020)."""
    try:
        return ipaddress.ip_network(text)
    except ValueError as error:
        raise Failure(diagnostic(INVALID_NETWORK, option=option, text=text)) from error


def is_within(address: str, networks: Collection[Network]) -> bool:
    """Return whether the address of a socket lies in one of the networks."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return False
    if isinstance(found, ipaddress.IPv6Address) and found.ipv4_mapped is not None:
        found = found.ipv4_mapped
    return any(found in network for network in networks)


def shown_address(host: str, port: int) -> str:
    """Return host and port as text."""
    return f"[{host}]:{port}" if ":" in host else f"{host}:{port}"


async def listen_at(
    endpoint: str,
    address: tuple[str, int],
    start: Callable[[str, int], Awaitable[asyncio.Server]],
) -> tuple[asyncio.Server, str]:
    """Return a server that listens at an address, and that address as text.

    Raises ``Failure`` (901351) where it cannot be used.
    """
    host, port = address
    try:
        server = await start(host, port)
    except (OSError, OverflowError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        found = diagnostic(
            ENDPOINT_ADDRESS_NOT_USABLE, endpoint=endpoint, host=host, port=port, reason=reason
        )
        raise Failure(found) from error
    taken = server.sockets[0].getsockname()[1]
    return server, shown_address(host, taken)
