# SPDX-License-Identifier: MIT
"""``python -m benchmarks.st``: how fast a project in Structured Text is checked, and starts.

The project is invented: function blocks of about 100 lines with methods, states, arrays and calls,
4.6 tokens a line as in published projects, comments and empty lines among them. The goal is
200,000 lines in 5 s, and 20,000 until the first tick could begin in 1 s.
"""

from __future__ import annotations

import platform
import sys
import tempfile
import time
from pathlib import Path

from nctakt.messages import Collector
from nctakt.plc.structured_text import load_structured
from nctakt.st.inspection import inspect_texts
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources

GOAL_LINES, GOAL_S = 200_000, 5.0
START_LINES, START_S = 20_000, 1.0

_BLOCK = """// Station {n}: moves parts from one place to another.
FUNCTION_BLOCK FB_Station{n} EXTENDS FB_Base
VAR_INPUT
    bStart    : BOOL;           // rising edge begins
    fTarget   : LREAL := 10.5;  // mm
    nParts    : INT;
END_VAR
VAR_OUTPUT
    bDone     : BOOL;
    nErrorId  : UDINT;
END_VAR
VAR
    eState    : E_State;
    aValues   : ARRAY[0..9] OF INT := [1, 2, 8(0)];
    stPart    : ST_Part;
    tonWait   : TON := (PT := T#200MS);
    rtStart   : R_TRIG;
    i         : INT;
END_VAR

rtStart(CLK := bStart);
tonWait(IN := eState = E_State.Wait);

CASE eState OF
    E_State.Idle:
        // Nothing to do before the edge.
        IF rtStart.Q AND NOT bDone THEN
            eState := E_State.Move;
            stPart.nNumber := stPart.nNumber + 1;
        END_IF

    E_State.Move:
        FOR i := 0 TO 9 DO
            aValues[i] := aValues[i] + nParts * 2;
            IF aValues[i] > 1000 THEN
                nErrorId := 16#1000 + INT_TO_UDINT(i);
                EXIT;
            END_IF
        END_FOR

        stPart.fLength := stPart.fLength + fTarget / 2.0;
        eState := E_State.Wait;

    E_State.Wait:
        IF tonWait.Q THEN
            bDone := TRUE;
            eState := E_State.Idle;
        ELSIF nErrorId <> 0 THEN
            SetError(nNumber := nErrorId, sText := CONCAT('station ', INT_TO_STRING(nParts)));
        END_IF
ELSE
    eState := E_State.Idle;
END_CASE

(* The sum of all values,
   for the display. *)
METHOD PUBLIC Sum : DINT
VAR
    k : INT;
END_VAR

Sum := 0;
FOR k := 0 TO 9 DO
    Sum := Sum + aValues[k];
END_FOR
END_METHOD

METHOD PUBLIC Reset : BOOL
// Back to the beginning.
THIS^.eState := E_State.Idle;
nErrorId := 0;
bDone := FALSE;

IF Sum() > 100 AND_THEN stPart.bValid THEN
    stPart.fLength := 0.0;
    stPart.sName := '';
END_IF
Reset := TRUE;
END_METHOD

END_FUNCTION_BLOCK

"""
_COMMON = """TYPE E_State : (Idle, Move, Wait); END_TYPE
TYPE ST_Part :
STRUCT
    nNumber : UDINT;
    fLength : LREAL;
    sName   : STRING(20);
    bValid  : BOOL;
END_STRUCT
END_TYPE
FUNCTION_BLOCK ABSTRACT FB_Base
VAR
    sError : STRING;
END_VAR
METHOD PROTECTED SetError
VAR_INPUT
    nNumber : UDINT;
    sText   : STRING;
END_VAR
sError := sText;
END_METHOD
END_FUNCTION_BLOCK
"""


def project(line_count: int) -> dict[str, bytes]:
    """Return files with at least as many lines."""
    count = line_count // _BLOCK.count("\n") + 1
    instances = "".join(f"    fb{n} : FB_Station{n};\n" for n in range(count))
    calls = "".join(f"fb{n}(bStart := TRUE);\n" for n in range(count))
    files = {f"FB_Station{n}.st": _BLOCK.format(n=n).encode() for n in range(count)}
    files["Common.st"] = _COMMON.encode()
    files["MAIN.st"] = f"PROGRAM MAIN\nVAR\n{instances}END_VAR\n{calls}END_PROGRAM\n".encode()
    return files


def measure(line_count: int) -> tuple[int, float, int]:
    """Check a project; return its lines, the seconds of the processor, and what was reported."""
    files = project(line_count)
    collector = Collector()
    begin = time.process_time()
    inspect_texts("Cell", files, Reporter(Sources(), collector))
    end = time.process_time()
    return (
        sum(text.count(b"\n") for text in files.values()),
        end - begin,
        len(collector.diagnostics),
    )


def start(line_count: int) -> float:
    """Return the seconds of the processor until a project is read, checked and translated."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "cell.st")
        path.write_bytes(b"\n".join(project(line_count).values()))
        begin = time.process_time()
        load_structured(path)
        return time.process_time() - begin


def main() -> int:
    """Print the times; 1 if the goal is missed or the time does not grow with the lines."""
    print(f"{platform.python_implementation()} {platform.python_version()}, {platform.machine()}")
    measure(1_000)
    start_s = start(START_LINES)
    print(f"start of {START_LINES} lines: {start_s:.2f} s")
    seconds = 0.0
    for line_count in (20_000, GOAL_LINES):
        lines, seconds, found = measure(line_count)
        each = seconds / lines * 1e6
        print(f"{lines:>8} lines: {seconds:6.2f} s, {each:5.1f} µs a line, {found} messages")
    return int(seconds > GOAL_S or start_s > START_S)


if __name__ == "__main__":
    sys.exit(main())
