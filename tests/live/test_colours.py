# SPDX-License-Identifier: MIT
"""Colours mean the same on the live page and in pictures of runs, as docs/traces.md says."""

import re
from pathlib import Path

from nctakt.plots import style

ROOT = Path(__file__).parents[2]
LIVE = ROOT / "src" / "nctakt" / "live"


def test_page_and_pictures_have_the_colours_of_the_table() -> None:
    """Feed, also of further channels, rapid traverse, and the kinds of marks."""
    table = re.findall(r"^\| \w+ `(#\w{6})` \|", (ROOT / "docs/traces.md").read_text("utf-8"), re.M)
    (row,) = re.findall(r"^\| pink .*", (ROOT / "docs/traces.md").read_text("utf-8"), re.M)
    lanes = style.LANE_COLOURS
    kinds = ("condition", "reaction", "function", "message", "error")
    assert table == [style.FEED, style.RAPID, *(lanes[kind] for kind in kinds)]
    scope = (LIVE / "scope.js").read_text("utf-8")
    marks = re.search(r"const MARKS = \{(.*)\}", scope)
    assert marks is not None
    found = dict(re.findall(r'(\w+): "(#\w{6})"', marks[1]))
    assert [found[name] for name in ("fired", "M", "message", "error")] == table[3:]
    assert {found["H"], found["output"]} == {found["M"]}
    assert f'pen.fillStyle = "{lanes["condition"]}"' in scope
    path = (LIVE / "path.js").read_text("utf-8")
    names = f'FEED = "{style.FEED}", RAPID = "{style.RAPID}", FIRED = "{lanes["reaction"]}"'
    assert names in path
    channels = re.search(r"const CHANNELS = \[FEED, (.*)\];", path)
    page = (LIVE / "page.css").read_text("utf-8")
    assert channels is not None
    assert re.findall(r"#\w{6}", channels[1]) == re.findall(r"#\w{6}", row)
    assert re.findall(r"--nc-channel-\d: (#\w{6})", page) == [
        style.FEED,
        *re.findall(r"#\w{6}", row),
    ]
