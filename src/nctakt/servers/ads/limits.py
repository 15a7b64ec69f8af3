# SPDX-License-Identifier: MIT
"""The limits of the ADS server, each with its number; docs/ads-objects.md lists them."""

from __future__ import annotations

#: Connections at a time. A further connection replaces one that has made no request for that many
#: seconds and gets no notifications; if there is none, it is closed at once.
MAX_CONNECTIONS, IDLE_S = 256, 30.0

#: Clients (source NetId and port) of a connection.
MAX_CLIENTS = 256

#: Handles and notifications of a client.
MAX_HANDLES = 10_000
MAX_NOTIFICATIONS = 4096

#: Handles of all clients of a connection.
MAX_CONNECTION_HANDLES = 20_000

#: Notifications of all clients; beyond, the connection with most of them loses its oldest.
MAX_ALL_NOTIFICATIONS = 32_768

#: Requests of a connection that wait for the session; then nothing more is read from it.
MAX_IN_FLIGHT = 256

#: Bytes that wait for a client to take them: beyond, nothing more is read from it …
MAX_UNREAD_ANSWERS = 1024 * 1024
#: … and with notifications it is disconnected.
MAX_UNREAD = 4 * 1024 * 1024

#: Parts of a sum command, and bytes of an answer.
MAX_PARTS = 65_536
MAX_ANSWER = 4 * 1024 * 1024 - 64

#: The shortest distance of notifications, and the longest, in ticks.
MIN_PERIOD, MAX_PERIOD = 1, 1_000_000_000
