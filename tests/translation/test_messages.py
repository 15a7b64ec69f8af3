# SPDX-License-Identifier: MIT
"""Messages that PLC code reports: events of the run (ST-721)."""

from __future__ import annotations

from pathlib import Path

from support.plc_rig import loaded, run


def reported(folder: Path, body: str) -> list[tuple[int, str, int]]:
    """Tick, text and line of each message of ten ticks, with body from line 3 on."""
    variables = "VAR n, i : DINT; r : LREAL := -2.5; s : STRING(255); END_VAR"
    plc = loaded(folder, f"PROGRAM MAIN\n{variables}\n{body}\nEND_PROGRAM\n")
    done = run(plc, 10)
    found = [one for one in done.trace.events if one.kind == "message"]
    assert [one.text for one in found] == [one.text for one in done.messages]
    return [(one.tick, one.text, one.span.line if one.span else 0) for one in found]


def test_messages_are_events_of_their_tick(tmp_path: Path) -> None:
    """ST-721: level, text with the argument, tick and line; what no code asks for is left out."""
    body = """n := n + 1;
IF n = 3 THEN
ADSLOGSTR(ADSLOG_MSGTYPE_HINT OR ADSLOG_MSGTYPE_LOG, 'gate %s is %s', 'A');
ADSLOGDINT(msgCtrlMask := ADSLOG_MSGTYPE_ERROR, msgFmtStr := 'n = %d', dintArg := -n);
n := n + ADSLOGLREAL(ADSLOG_MSGTYPE_WARN, '%f mm', r);
ADSLOGSTR(ADSLOG_MSGTYPE_LOG, '100 % done', 'unused');
END_IF"""
    assert reported(tmp_path, body) == [
        (2, "HINT gate A is %s", 5),
        (2, "ERROR n = -3", 6),
        (2, "WARN -2.5 mm", 7),
        (2, "100 % done", 8),
    ]


def test_messages_of_a_tick_are_bounded(tmp_path: Path) -> None:
    """ST-721: the first 16, then how many there were beside them; 255 bytes of a text."""
    body = """n := n + 1;
FOR i := 1 TO 100 * (n MOD 2) DO ADSLOGDINT(0, '%d', i); END_FOR
IF n = 2 THEN
FOR i := 1 TO 200 DO s := CONCAT(s, 'ab'); END_FOR
ADSLOGSTR(ADSLOG_MSGTYPE_ERROR, '%s', s);
END_IF"""
    found = reported(tmp_path, body)
    first = [(0, str(i), 4) for i in range(1, 17)]
    assert found[:17] == [*first, (0, "84 more messages of this tick", 0)]
    assert found[17] == (1, ("ERROR " + "ab" * 200)[:255], 7)
    assert [tick for tick, _, _ in found[18:]] == [tick for tick in (2, 4, 6, 8) for _ in range(17)]
