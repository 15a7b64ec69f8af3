# SPDX-License-Identifier: MIT
"""Sessions show which programs are open: where the path is, and where the decoder is."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from nctakt import NcText
from nctakt.session import Session, StopAt
from nctakt.session.engine import StepResult

PROGRAM = """\
%L DEEP
  #VAR
    V.L.OWN = 3
  #ENDVAR
  G01 X20 F60000
  M17
%L SUB
  V.P.A = V.P.A + 1
  G01 X10 F60000
  LL DEEP
  G01 Y10
  M17
%MAIN
P5 = 7
V.P.A = 0
V.E.COUNT = 4
#RT CYCLE [ID=3 SCOPE=PROG]
  V.E.VALUE = 1
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT = 4
  $ENDIF
#RT CYCLE END
LL SUB
G01 X30
LL SUB
M30
"""


@pytest.fixture(scope="module")
def shared() -> Iterator[Session]:
    with Session(NcText("p.nc", PROGRAM)) as session:
        yield session


@pytest.fixture
def session(shared: Session) -> Session:
    shared.go_to(0)
    shared.set_stops()
    return shared


def calls(done: StepResult) -> list[tuple[str, int]]:
    """The open programs, the innermost first, each with the line in which it is."""
    inner = done.blocks[1]
    lines = [inner.line if call.span is None else call.span.line for call in done.calls[1]]
    return [(call.name, line) for call, line in zip(done.calls[1], lines, strict=True)][::-1]


def test_the_programs_that_are_open_are_those_of_the_current_block(session: Session) -> None:
    """The decoder has gone on to the second call by then."""
    done = session.run(until="line 5")
    assert calls(done) == [("DEEP", 5), ("SUB", 10), ("MAIN", 23)]
    assert session.decoders()[0].frames[0].name == "MAIN"
    assert calls(session.run(until="line 24")) == [("MAIN", 24)]
    assert calls(session.run(until="line 5")) == [("DEEP", 5), ("SUB", 10), ("MAIN", 25)]
    session.back(1)
    session.previous_block()
    assert calls(session.latest)[0][0] in ("SUB", "DEEP")


def test_a_block_can_be_wanted_up_to_a_depth(session: Session) -> None:
    """A step over a call ends after it: in the tick of the call its first block is current."""
    session.run(until="line 9")
    stop = StopAt("block", max_depth=2, is_of_channel=True)
    assert [session.run(until=stop).blocks[1].line for _ in range(2)] == [11, 24]
    session.run(until="line 5")
    assert session.run(until=StopAt("block", max_depth=1)).blocks[1].line == 26


def test_what_the_decoder_knows_can_be_seen(session: Session) -> None:
    session.run(until="line 11")
    (decoder,) = session.decoders()
    assert decoder.channel == 1
    assert {one.name: one.values for one in decoder.program} == {"V.P.A": (2.0,)}
    assert decoder.parameters == {5: 7.0}


def test_a_realtime_cycle_stops_in_each_tick_in_which_it_runs(session: Session) -> None:
    first = session.run(until="cycle 17").tick
    assert session.run(until="cycle 17").tick == first + 1


def test_a_value_from_outside_is_a_change_that_no_cycle_has_written(session: Session) -> None:
    session.run(until="line 9")
    session.write({"V.E.COUNT": 9})
    changed = session.run(until=["changes V.E.COUNT", "written V.E.COUNT"])
    assert changed.hits == (0,)
    assert session.run(until=["changes V.E.COUNT", "written V.E.COUNT"]).hits == (0, 1)
    session.go_to(0, 1)


def test_system_variables_are_those_of_the_decoder() -> None:
    """V.G and V.A as a program would read them where its decoder is, in the program's unit."""
    program = NcText("part.nc", "G92 X5\nG01 X25.4 F600\nG70\nG01 X2 F10\n#FLUSH WAIT\nM30")
    with Session(program) as session:
        session.step(2)
        (state,) = session.decoders()
        system = {one.name: one.values[0] for one in state.system}
        assert system["V.G.MASS_MM"] == 1.0
        assert system["V.A.PROG.X"] == pytest.approx(2.0)
        assert system["V.A.BZP.X"] == pytest.approx(5.0 / 25.4)
        assert {"V.A.+SWE.X", "V.A.ACS.ABS.Y", "V.G.NP_AKT.V.Z"} <= system.keys()
        session.run()
        assert session.decoders() == []
