# SPDX-License-Identifier: MIT
"""Messages about execution times that are learnt from a recording."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INVALID_RECORDING = error(
    900641,
    en="{file} is not a recording of trace bits: {reason}",
    de="{file} ist keine Aufzeichnung von Trace-Bits: {reason}",
    remedy_en="Give a VCD file, a CSV file with time_us and bit1 … bit7, or the table of "
    "nctakt schedule simulate --csv.",
    remedy_de="VCD, CSV mit time_us und bit1 … bit7 oder die Tabelle von schedule simulate --csv "
    "angeben.",
    reason=("what is wrong with it", "was an ihr falsch ist"),
)
NOTHING_LEARNT = error(
    900642,
    en="{file}: no call of a function of the list was recorded from beginning to end",
    de="{file}: kein Aufruf einer Funktion der Liste ist von Anfang bis Ende aufgezeichnet",
    remedy_en="Set trace_bit in the list as it was during the recording.",
    remedy_de="trace_bit in der Liste so setzen, wie es bei der Aufzeichnung war.",
    file=("the recording", "die Aufzeichnung"),
)
SHARED_BIT_NOT_LEARNT = warning(
    900643,
    en="trace bit {bit} belongs to several functions ({names}); none of them is learnt",
    de="das Trace-Bit {bit} gehört mehreren Funktionen ({names}); keine davon wird gelernt",
    remedy_en="Give each function a separate bit and record again.",
    remedy_de="Jeder Funktion ein eigenes Bit geben und neu aufzeichnen.",
    bit=("the trace bit", "das Trace-Bit"),
    names=("its functions", "seine Funktionen"),
)
FUNCTIONS_NOT_LEARNT = note(
    900644,
    en="not learnt, since nothing of them was recorded: {names}",
    de="nicht gelernt, da von ihnen nichts aufgezeichnet ist: {names}",
    remedy_en="Give them trace bits, or add their times to the load.",
    remedy_de="Ihnen Trace-Bits geben oder ihre Zeiten in der Last ergänzen.",
    names=("functions and external threads", "Funktionen und externe Threads"),
)
INTERRUPTIONS_ESTIMATED = note(
    900645,
    en="interruptions were worked out from the other trace bits: anything without a bit counts as "
    "work",
    de="Unterbrechungen sind aus den anderen Trace-Bits erschlossen: alles ohne Bit zählt mit",
    remedy_en="Give each thread a trace bit before recording.",
    remedy_de="Vor dem Aufzeichnen jedem Thread ein Trace-Bit geben.",
)
SUSPENSIONS_UNKNOWN = warning(
    900646,
    en="the recording does not show when threads are suspended: that time counts as work",
    de="die Aufzeichnung zeigt nicht, wann Threads suspendiert sind: diese Zeit zählt mit",
    remedy_en="Record with windows_time 0, or with the timer as interrupt source.",
    remedy_de="Mit windows_time 0 oder mit dem Timer als Interruptquelle aufzeichnen.",
)
