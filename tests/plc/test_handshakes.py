# SPDX-License-Identifier: MIT
"""The examples of docs/plc-handshakes.md and docs/ads-handshakes.md run, and print what is there.

The text in a fence after an example is what it prints.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from support.ads_server import Server

ROOT = Path(__file__).parents[2]
#: The program of docs/ads-handshakes.md.
PART = "N10 M40\nN20 G01 X100 F6000\nN30 G01 X0\nN40 M30\n"

_EXAMPLE = re.compile(r"^## (.*?)$.*?^```python\n(.*?)^```\n\n```\n(.*?)^```", re.M | re.S)


def examples(page: str) -> list[tuple[str, str, str]]:
    """Title, Python and output of each example of a page."""
    found = _EXAMPLE.findall((ROOT / "docs" / page).read_text("utf-8"))
    assert found
    return found


@pytest.mark.parametrize(("title", "code", "expected"), examples("plc-handshakes.md"))
def test_a_plc_in_python(
    title: str, code: str, expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """As it is."""
    exec(compile(code, f"{title}.py", "exec"), {"__name__": "example"})
    assert capsys.readouterr().out == expected


@pytest.mark.slow
def test_hmi_and_plc_by_ads(tmp_path: Path) -> None:
    """One after another, in their own process, against their own controller."""
    pytest.importorskip("pyads", reason="pyads needs a compiler, which is missing here")
    server = Server(tmp_path, "--wait-for-start", text=PART)
    codes, outputs = zip(*[found[1:] for found in examples("ads-handshakes.md")], strict=True)
    text = "".join(codes).replace('"127.0.0.1")', f'"{server.address}")')
    script = tmp_path / "client.py"
    script.write_text(text.replace("127.0.0.1.1.1", server.net_id), "utf-8")
    try:
        done = subprocess.run(
            [sys.executable, str(script)], capture_output=True, text=True, timeout=60, check=False
        )
        assert done.stdout.splitlines() == "".join(outputs).splitlines(), done.stderr
    finally:
        server.end()
