# SPDX-License-Identifier: MIT
"""A client as methods and alarms see it."""

from __future__ import annotations

from typing import Any, Protocol

from nctakt.base.diagnostics import Language


class Client(Protocol):
    """The session of a client; ``client``: its address, ``language``: of its texts."""

    client: str
    language: Language
    session_id: Any
    aspace: Any
