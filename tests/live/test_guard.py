# SPDX-License-Identifier: MIT
"""Who may see the live page: hosts, origins, fetch metadata, tokens, ports."""

import socket

import pytest

from nctakt.base.failure import Failure
from nctakt.live.access.guard import Access
from nctakt.live.server import usable_port

LOCAL = {"host": "127.0.0.1:8765"}

#: On this machine, on another address, and on this machine for an editor.
HERE, THERE = Access("secret", is_closed=False, is_embedded=False), Access("secret", True, False)
EMBEDDED = Access("secret", is_closed=False, is_embedded=True)


def is_admitted(access: Access, headers: dict[str, str], given: str = "", path: str = "/") -> bool:
    """Whether a request may pass."""
    return access.why_refused(headers, path, given) is None


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
    assert is_admitted(HERE, headers) is admitted


@pytest.mark.parametrize(
    ("site", "target", "admitted"),
    [
        ("none", "document", True),  # typed, or from a terminal
        ("same-origin", "script", False),  # the page as a script
        ("same-origin", "document", True),
        ("cross-site", "image", False),
        ("cross-site", "document", False),  # a link: a page with a link comes
        ("same-site", "document", False),  # another port of this machine
        ("cross-site", "iframe", False),
        ("same-origin", "iframe", False),
        ("cross-site", "websocket", False),
    ],
)
def test_what_browsers_say_of_a_request(site: str, target: str, admitted: bool) -> None:
    """Sec-Fetch-Site and Sec-Fetch-Dest, as the W3C's Fetch Metadata defines them."""
    headers = {**LOCAL, "sec-fetch-site": site, "sec-fetch-dest": target}
    assert is_admitted(HERE, headers) is admitted


def test_an_editor_shows_the_page_in_a_panel() -> None:
    """With the token in the address, and what the page asks for then; nobody else does."""
    panel = {**LOCAL, "sec-fetch-site": "cross-site", "sec-fetch-dest": "iframe"}
    own = {**LOCAL, "sec-fetch-site": "same-origin", "sec-fetch-dest": "script"}
    assert is_admitted(EMBEDDED, panel, "secret")
    assert is_admitted(EMBEDDED, own, path="/script.js")
    assert not is_admitted(EMBEDDED, panel, "secrex")
    assert not is_admitted(HERE, panel, "secret")
    policies = [dict(one.headers())[b"content-security-policy"] for one in (HERE, EMBEDDED)]
    assert policies == [b"frame-ancestors 'none'", b"frame-ancestors vscode-webview: vscode-file:"]


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
    assert is_admitted(THERE, headers, given) is admitted


def test_a_taken_port_is_reported() -> None:
    """901161, with what to do."""
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        with pytest.raises(Failure, match="901161"):
            usable_port("127.0.0.1", taken.getsockname()[1])
