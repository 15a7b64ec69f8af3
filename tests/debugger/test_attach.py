# SPDX-License-Identifier: MIT
"""A debugger at the session of the live page: beside its stops, and through a port."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from threading import Thread

import pytest
from support.debug_client import DebugClient, Refused

from nctakt.debugger.server import PortServer
from nctakt.session.session import Session

pytestmark = pytest.mark.slow

PROGRAM = """\
G01 X10 F6000
G01 X20
G01 X30
G01 X40
M30
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("attached") / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    return str(path)


@pytest.fixture
def session(program: str) -> Iterator[Session]:
    with Session(program, until="24 h") as own:
        yield own


def test_a_debugger_joins_a_session_and_leaves_it_as_it_was(session: Session, program: str) -> None:
    """Stops of the page hold, too; what the page does is reported."""
    session.set_stops("line 3")
    with DebugClient(session=lambda: session) as client:
        client.ask("initialize")
        client.ask("attach")
        client.event("initialized")
        own = {"source": {"path": program}, "breakpoints": [{"line": 2}]}
        assert client.ask("setBreakpoints", **own)["breakpoints"][0]["verified"]
        client.ask("configurationDone")
        assert client.stopped()["reason"] == "entry"
        assert client.go()["line"] == 2
        other = client.go()
        assert (other["reason"], other["line"]) == ("pause", 3)
        session.step(5)  # by the page
        assert client.stopped()["text"].startswith(f"before tick {session.tick} ")
        session.play(0.05)
        client.event("continued")
        session.pause()
        assert client.stopped()["reason"] == "pause"
        client.ask("disconnect")
    assert [stop.line for stop in session.stops] == [3]
    assert session.run().run_state == "ended"


def test_the_page_may_begin_its_program_anew(session: Session, program: str) -> None:
    """The debugger goes over to the new session, with its breakpoints."""
    shared = [session]
    with DebugClient(session=lambda: shared[0]) as client:
        client.ask("initialize")
        client.ask("attach")
        own = {"source": {"path": program}, "breakpoints": [{"line": 2}]}
        client.ask("setBreakpoints", **own)
        client.ask("configurationDone")
        client.stopped()
        with Session(program, until="24 h") as again:
            shared[0] = again
            session.close()
            assert client.event("breakpoint")["breakpoint"]["verified"]
            assert client.stopped()["reason"] == "entry"
            assert client.go()["line"] == 2
            client.ask("disconnect")


def test_a_debugger_at_a_pipe_attaches_at_a_port(session: Session) -> None:
    """It is of the same user, and so knows the token of the port."""
    server = PortServer(0, session=lambda: session)
    Thread(target=server.serve, daemon=True).start()
    with DebugClient() as client:
        client.ask("initialize")
        with pytest.raises(Refused, match="no nctakt live answers"):
            client.ask("attach", port=1)
        client.ask("attach", port=server.endpoint.port)
        client.event("initialized")
        client.ask("configurationDone")
        assert client.stopped()["reason"] == "entry"
        assert client.go("next")["line"] == 1
        assert session.tick == 1
        client.ask("disconnect")
    server.close()
    assert not session.is_over


def test_a_port_lets_nobody_attach_without_its_token(session: Session) -> None:
    """901921 and 901922, and the connection ends; the token is an attribute of ``attach``."""
    server = PortServer(0, folders=["."], session=lambda: session)
    Thread(target=server.serve, daemon=True).start()
    for arguments, number in (({}, "901921"), ({"token": "x" * 32}, "901922")):
        with DebugClient(port=server.endpoint.port) as client:
            client.ask("initialize")
            with pytest.raises(Refused) as refused:
                client.ask("attach", **arguments)
            assert number in refused.value.error["format"]
            with pytest.raises((AssertionError, OSError)):
                client.ask("threads")
    with DebugClient(port=server.endpoint.port) as client:
        client.ask("initialize")
        client.ask("attach", token=server.endpoint.token)
        client.ask("configurationDone")
        assert client.stopped()["reason"] == "entry"
    server.close()
    assert not session.is_over


def test_messages_are_reported_while_the_page_plays_and_the_debugger_pauses_it(
    tmp_path: Path,
) -> None:
    """Each once, whoever lets it run; ``pause`` holds what the page has started."""
    part = tmp_path / "reported.nc"
    part.write_text('G04 X0.1\n#MSG ["first"]\nG04 X0.1\n#MSG ["second"]\nG04 X3600\nM30\n')
    with Session(str(part)) as session, DebugClient(session=lambda: session) as client:
        client.ask("initialize")
        client.ask("attach")
        client.ask("configurationDone")
        client.stopped()
        session.play(20.0)
        client.event("continued")
        for text in ("first", "second"):
            reported = client.event("output", lambda body: body["category"] == "stdout")
            assert text in reported["output"]
        client.ask("pause", threadId=1)
        assert client.stopped()["reason"] == "pause"
        assert not session.is_playing
        session.back(10)
        client.stopped()
        session.step(20)
        client.stopped()
        client.ask("disconnect")
        outputs = [one for one in client.events if one["event"] == "output"]
        assert [one for one in outputs if one["body"]["category"] == "stdout"] == []
