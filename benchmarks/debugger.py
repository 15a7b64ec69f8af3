# SPDX-License-Identifier: MIT
"""``python -m benchmarks.debugger``: how long an editor waits for the debugger.

Over the protocol, from the request to the event that it stops:

- continue up to a breakpoint 10,000 ticks further: at most 50 ms;
- a step back by a block, and by a tick, there: at most 100 ms;
- from the start of the process to the answer to ``launch``.
"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from nctakt.ports.framing import MessageReader

TICKS = 10_000
REPEATS = 20

_HEAD = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 50
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
"""


class Client:
    """A debugger in its own process."""

    def __init__(self) -> None:
        words = [sys.executable, "-m", "nctakt", "dap"]
        self._process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        assert self._process.stdout is not None
        self._reader = MessageReader(self._process.stdout, is_strict=True)
        self._count = 0

    def send(self, command: str, **arguments: Any) -> None:
        """Send a request."""
        self._count += 1
        request = {"seq": self._count, "type": "request", "command": command}
        body = json.dumps({**request, "arguments": arguments}).encode()
        assert self._process.stdin is not None
        self._process.stdin.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
        self._process.stdin.flush()

    def await_(self, name: str) -> dict[str, Any]:
        """Return the next event, or answer, of a name."""
        while True:
            message = self._reader.read()
            assert message is not None
            if name in (message.get("event"), message.get("command")):
                return message

    def travel(self, tick: int) -> None:
        """Take the session to before a tick."""
        self.send("evaluate", expression=f"tick {tick}", context="repl")
        self.await_("stopped")

    def line_at(self, tick: int) -> int:
        """Return the line of the block that is current at a tick; the session is there."""
        self.travel(tick)
        self.send("stackTrace", threadId=1)
        return int(self.await_("stackTrace")["body"]["stackFrames"][0]["line"])

    def close(self) -> None:
        """End the process."""
        self.send("disconnect")
        self.await_("disconnect")
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()


def waited_ms(client: Client, command: str, **arguments: Any) -> float:
    """Return how long it takes from a request to the stop, in ms."""
    begin = time.perf_counter()
    client.send(command, threadId=1, **arguments)
    client.await_("stopped")
    return 1000.0 * (time.perf_counter() - begin)


def show(what: str, times_ms: list[float], limit_ms: float) -> None:
    """Print median and maximum with their goals."""
    median, worst = statistics.median(times_ms), max(times_ms)
    print(f"{what:<44}{median:8.1f} ms, at most {worst:.1f} ms (limit {limit_ms:.0f} ms)")


def main() -> None:
    """Measure and print."""
    blocks = [f"G01 X{100 * (number % 2)} F100000" for number in range(20_000)]
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "part.nc"
        program.write_text(f"{_HEAD}{chr(10).join(blocks)}\nM30\n", "utf-8")
        begin = time.perf_counter()
        client = Client()
        client.send("initialize")
        client.send("launch", program=str(program), stopOnEntry=True)
        client.await_("launch")
        print(f"{'start up to the answer to launch':<44}{time.perf_counter() - begin:8.2f} s")
        client.send("configurationDone")
        client.await_("stopped")
        times: dict[str, list[float]] = {"continue": [], "block": [], "tick": []}
        for number in range(REPEATS):
            line = client.line_at((number + 1) * TICKS)
            client.travel(number * TICKS)
            stop = {"source": {"path": str(program)}, "breakpoints": [{"line": line}]}
            client.send("setBreakpoints", **stop)
            client.await_("setBreakpoints")
            times["continue"].append(waited_ms(client, "continue"))
            times["block"].append(waited_ms(client, "stepBack"))
            times["tick"].append(waited_ms(client, "stepBack", granularity="instruction"))
        client.close()
    show("continue to a breakpoint after 10,000 ticks", times["continue"], 50)
    show("step back by a block", times["block"], 100)
    show("step back by a tick", times["tick"], 100)


if __name__ == "__main__":
    main()
