# SPDX-License-Identifier: MIT
"""The account of a branch is that of a run with the same inputs, while the session lives on."""

from __future__ import annotations

import random
from collections.abc import Iterator

import pytest

from nctakt import Controller, NcText, Session
from nctakt.session.history.rerun import PastAccount
from nctakt.timing.account import account_for
from nctakt.timing.table import TitledTables, time_tables

#: Feed, rapid, a dwell, an override by a cycle, functions that are awaited, a subprogram.
PROGRAM = """%L part
N200 G01 X0
N210 G00 X5
M17
%main
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 5
    V.RTG.OVERRIDE.VEL.CYCLE = 50
  $ENDIF
  $IF EDGE V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 6, 1
  N10 G01 X10 Y3 F6000
  LL part
  G04 0.02
  M7
$ENDFOR
M30
"""


@pytest.fixture
def session() -> Iterator[Session]:
    with Session(NcText("part.nc", PROGRAM)) as session:
        yield session


def whole(account: PastAccount, count: int = 700) -> TitledTables:
    """The tables once all ticks are accounted for."""
    while account.advance(count):
        pass
    assert account.tick == account.latest
    return account.tables("en")


def of_run(ticks: int | None = None, at: tuple[tuple[str, str, float], ...] = ()) -> TitledTables:
    """The tables of a run by itself."""
    text = NcText("part.nc", PROGRAM)
    account = account_for(Controller(), {1: [text]}, at=at, ticks=ticks)
    return time_tables(account, "en")


def test_account_of_a_whole_session_is_that_of_the_run(session: Session) -> None:
    """All tables are those of ``nctakt time``, whatever parts the ticks are rerun in."""
    session.run()
    account = session.time_account()
    expected = of_run()
    assert whole(account) == expected
    assert account.tick == session.tick
    assert len(expected[0][1]) == 4  # kinds, limits, programs, blocks
    account.close()
    other = session.time_account()
    assert whole(other, 41) == expected
    other.close()


def test_account_follows_a_session_that_goes_on(session: Session) -> None:
    """It is at the latest tick again and again; nothing is accounted for before the first one."""
    account = session.time_account()
    assert not account.advance(100)
    assert account.tables("en") == []
    for end in (300, 301, 777):
        session.step(end - session.tick)
        assert whole(account) == of_run(end)
    account.close()


def test_account_of_a_branch_has_its_inputs(session: Session) -> None:
    """A value that is written in the past begins a branch; both have their own account."""
    session.step(500)
    session.go_to(200)
    session.write({"HLI.OVERRIDE": 50})
    session.step(400)
    first, second = session.time_account(1), session.time_account()
    assert (first.branch, second.branch) == (1, 2)
    assert whole(first) == of_run(500)
    assert whole(second) == of_run(600, (("200 ms", "HLI.OVERRIDE", 50),))
    first.close()
    second.close()


def test_account_while_the_session_travels(session: Session) -> None:
    """Wherever the session is, its branch is accounted for from the first tick to the latest."""
    session.run()
    chance, account = random.Random(36), session.time_account()
    while account.advance(97):
        session.go_to(chance.randrange(session.branches[1]))
    assert account.tables("en") == of_run()
    account.close()
