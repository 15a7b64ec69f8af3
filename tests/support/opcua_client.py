# SPDX-License-Identifier: MIT
"""Clients of OPC UA that wait for a busy machine."""

from __future__ import annotations

from asyncua import Client

from support.served import PATIENCE_S


def patient_client(url: str) -> Client:
    """Return a client for a URL, with patience for each answer.

    By itself it leaves a server that does not say within a second that it is alive.
    """
    return Client(url, timeout=PATIENCE_S, watchdog_intervall=PATIENCE_S)
