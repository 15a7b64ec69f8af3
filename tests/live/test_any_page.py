# SPDX-License-Identifier: MIT
"""Random walks on the page over random programs: it shows what the engine had at its tick.

Beside the page a session does the same; all that the page shows is compared with it after each
step, and in the end the values and events seen with straight runs of the tapes of all branches.
``NCTAKT_SEEDS=150`` walks as often.
"""

import random
from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support import program_generator
from support.page_driving import BROWSER, chromium, opened, served
from support.page_walking import MAX_ROWS, Beside, act, place_of, settle
from support.random_seeds import seeds_in_parts

from nctakt import Session
from nctakt.live import view
from nctakt.run.access.inputs import Input
from nctakt.run.access.tape import Tape
from nctakt.run.controller import Controller

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")

pytestmark = BROWSER

#: A session after a tick already sees what the decoder has written for the next one.
EARLY = "V.E.ASYNC"

#: What is done in a walk.
STEPS = 16


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def check_straight(session: Session, path: Path, seen: list[dict[str, Any]]) -> None:
    """Compare what was seen with straight runs of the tapes of the branches."""
    for branch, latest in session.branches.items():
        shown = [one for one in seen if place_of(one)[1] == branch and place_of(one)[0]]
        if not shown:
            continue
        session.go_to(latest, branch)
        inputs = tuple(one for one in session.tape() if one.tick < latest)
        names = list(dict.fromkeys(name for one in shown for name in one["names"]))
        tape = Tape({}, {}, False, inputs, {}, 0, "", {})
        run = Controller().run(path, replay=tape, ticks=latest, signals=names)
        assert run.trace is not None
        rows = rows_of(path, inputs, sorted({place_of(one)[0] for one in shown}))
        for one in shown:
            ticks = place_of(one)[0]
            for name, value in zip(one["names"], one["now"], strict=True):
                if name == EARLY:
                    continue
                expected = view.rounded(float(run.trace[name][ticks - 1]))
                assert value == expected, (branch, ticks, name, value, expected, inputs)
            own = [row for row in one["rows"] if not row.endswith("left out")]
            assert not own or own == rows[ticks], (branch, ticks)


def rows_of(path: Path, inputs: Sequence[Input], ends: Sequence[int]) -> dict[int, list[str]]:
    """Return the rows of events before some ticks, of a session that never goes back."""
    found = {}
    with Session(path) as straight:
        latest: list[str] = []
        coming = list(inputs)
        for end in ends:
            while straight.tick < end:
                while coming and coming[0].tick == straight.tick:
                    name, value = coming.pop(0).values
                    straight.write({str(name): value})
                part = min([end, *(one.tick for one in coming)])
                done = straight.step(part - straight.tick)
                latest += [view.event_row(one, "en").text for one in done.events]
                if straight.is_over:
                    break
            found[end] = latest[::-1][:MAX_ROWS]
    return found


def walk(browser: Any, path: Path, seed: int) -> None:
    """Walk over a random program, and compare after each step."""
    choice = random.Random(seed)
    text = program_generator.program(seed)
    path.write_text(text, "utf-8")
    with served(str(path)) as address, Session(path) as session:
        page = opened(browser, address)
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max").click()
        page.evaluate("document.activeElement.blur()")
        page.keyboard.press("3")
        beside, seen = Beside(session, str(path), text.split("\n")), []
        done: list[tuple[str, tuple[int, int] | None]] = []
        for _ in range(STEPS):
            done.append(act(page, session, choice))
            try:
                seen.append(settle(page, beside, done[-1][1]))
            except AssertionError as error:
                raise AssertionError(f"seed {seed} after {done}: {error}") from None
        check_straight(session, path, seen)
        page.close()


@pytest.mark.nightly
@seeds_in_parts(2, 1, 1)
def test_any_walk(browser: Any, tmp_path: Path, seeds: range) -> None:
    """Steps, travel, plays, inputs in the past, branches taken up again, reloaded, zoomed."""
    for seed in seeds:
        walk(browser, tmp_path / f"{seed}.nc", seed)
