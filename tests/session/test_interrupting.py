# SPDX-License-Identifier: MIT
"""Whatever takes long can be interrupted from another thread, and the session stays usable."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from nctakt import NcText
from nctakt.base.failure import Failure
from nctakt.session.core import SessionCore
from nctakt.session.history import timeline
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.session import Session

pytestmark = pytest.mark.slow

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G04 X60
M30
"""

#: A condition of which the record shows nothing, so that the past is run again.
AGAIN = "V.E.COUNT + V.E.VALUE > 5"


@pytest.fixture(scope="module")
def session() -> Iterator[Session]:
    with Session(NcText("part.nc", PROGRAM)) as own:
        own.step(2000)
        yield own


def interrupting(session: Session, method: Callable[..., Any], patch: Any, owner: Any) -> None:
    """Let a method of the session's inside interrupt it when it has been called."""

    def called(*words: Any, **keywords: Any) -> Any:
        result = method(*words, **keywords)
        session.interrupt()
        return result

    patch.setattr(timeline, "PART_TICKS", 100)
    patch.setattr(owner, method.__name__, called)


def test_a_search_backward_leaves_the_session_where_it_was(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    tick = session.tick
    with monkeypatch.context() as patch:
        interrupting(session, RemoteEngine.last_hit, patch, RemoteEngine)
        with pytest.raises(Failure) as failed:
            session.back_to(AGAIN)
    assert failed.value.diagnostics[0].id == 901474
    assert session.tick == tick
    assert session.back_to(AGAIN) is None


def test_travel_that_is_interrupted_leaves_the_session_where_it_was(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    tick = session.tick
    with monkeypatch.context() as patch:
        interrupting(session, RemoteEngine.run, patch, RemoteEngine)
        with pytest.raises(Failure):
            session.why()
    session.go_to(0)
    with monkeypatch.context() as patch:
        interrupting(session, RemoteEngine.run, patch, RemoteEngine)
        with pytest.raises(Failure):
            session.go_to(1500)
    assert session.tick == session.latest.tick == 0
    assert session.progress is None
    session.go_to(tick)
    assert session.tick == tick
    assert session.why().select("1", None).render("en")


def test_travel_tells_how_far_it_has_come(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(timeline, "PART_TICKS", 100)
    reported: list[tuple[int, int]] = []
    session.on_travel = lambda done, whole: reported.append((done, whole))
    assert session.back_to(AGAIN) is None
    session.on_travel = None
    assert len(reported) > 10
    assert {whole for _, whole in reported} == {session.tick - 1}
    assert [done for done, _ in reported] == sorted(done for done, _ in reported)
    assert session.progress is None


def test_a_step_of_many_ticks_ends_between_two_slices(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    tick = session.tick
    with monkeypatch.context() as patch:
        interrupting(session, SessionCore.run, patch, SessionCore)
        done = session.step(1_000_000)
    assert tick < done.tick < tick + 1_000_000
    assert session.step(3).tick == done.tick + 3


@pytest.mark.skipif(os.name != "posix", reason="signals are sent in another way there")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_controller_that_starts_leaves_signals_to_its_session(
    number: signal.Signals, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """Ctrl-C goes to all processes of a terminal, also to one that still imports modules."""

    class Interrupted(subprocess.Popen[bytes]):
        def __init__(self, *words: Any, **keywords: Any) -> None:
            super().__init__(*words, **keywords)
            self.send_signal(number)

    monkeypatch.setattr(subprocess, "Popen", Interrupted)
    with Session(NcText("part.nc", "G01 X10 F600\nM30\n")) as session:
        session.run("5 ticks")
        assert session.tick == 5
    assert not capfd.readouterr().err
