# SPDX-License-Identifier: MIT
"""Who may see the live page: hosts, origins, tokens, ports."""

import socket

import pytest

from nctakt.base.failure import Failure
from nctakt.live.guard import is_admitted
from nctakt.live.server import usable_port

LOCAL = {"host": "127.0.0.1:8765"}


@pytest.mark.parametrize(
    ("headers", "admitted"),
    [
        (LOCAL, True),
        ({"host": "localhost:8765"}, True),
        ({"host": "[::1]:8765"}, True),
        ({"host": "rebound.example:8765"}, False),
        ({}, False),
        ({"host": "["}, False),
        ({**LOCAL, "origin": "http://127.0.0.1:8765"}, True),
        ({**LOCAL, "origin": "http://127.0.0.1:80"}, False),
        ({**LOCAL, "origin": "https://elsewhere.example"}, False),
        ({**LOCAL, "origin": "null"}, False),
        ({**LOCAL, "origin": "http://["}, False),
        ({**LOCAL, "origin": "http://127.0.0.1:8765@elsewhere.example"}, False),
    ],
)
def test_on_this_machine(headers: dict[str, str], admitted: bool) -> None:
    """No token, but the page's own host and origin."""
    assert is_admitted(headers, "", None) is admitted


@pytest.mark.parametrize(
    ("cookie", "given", "admitted"),
    [
        ("", "", False),
        ("", "secret", True),
        ("", "secrex", False),
        ("a=1; nctakt_token=secret", "", True),
        ("nctakt_token=other", "", False),
        ("nctakt_token=grün", "", False),
    ],
)
def test_on_another_address(cookie: str, given: str, admitted: bool) -> None:
    """The token is in the address once, then in a cookie."""
    headers = {"host": "cnc.example:8765", "cookie": cookie}
    assert is_admitted(headers, given, "secret") is admitted


def test_a_taken_port_is_told() -> None:
    """901161, with what to do."""
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        with pytest.raises(Failure, match="901161"):
            usable_port("127.0.0.1", taken.getsockname()[1])
