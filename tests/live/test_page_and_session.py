# SPDX-License-Identifier: MIT
"""What is on the page at a tick is what the engine had after it: walks on the page, compared.

Beside the page a session of the same program is at the same tick.
"""

import random
import re
from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, chromium, opened, served
from support.random_seeds import seeds_in_parts

from nctakt import Session
from nctakt.live import view
from nctakt.live.parts.explaining import bars_of
from nctakt.live.texts import Texts
from nctakt.live.track import marks_of

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = BROWSER

PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5 && V.E.VALUE < 0.5
    V.E.COUNT += 1
  $ENDIF
  $IF V.RTA.ACS.ACT_POS.Y >= 2
    V.E.VALUE = 0.25
  $ELSE
    V.E.FLAG = 1
  $ENDIF
#RT CYCLE END
G01 X10 F6000
Y4
X0 Y0
X8
M30
"""
LINES = PROGRAM.split("\n")
TEXTS = Texts("en")

#: What a walk does: keys of the page.
STEPS = [".", ",", "b", "B", "r", "R", "."]


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


@pytest.fixture(scope="module")
def walk(
    browser: Any, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[tuple[Any, Session, str]]:
    """A page, and a session of its program."""
    path = tmp_path_factory.mktemp("walk") / "walk.nc"
    path.write_text(PROGRAM, "utf-8")
    with served(str(path)) as address, Session(path) as session:
        page = opened(browser, address)
        yield page, session, str(path)
        page.close()


def shown_tick(page: Any) -> int:
    """Return the tick that the bar names, -1 before the first."""
    found = re.match(r"Tick (\d+) ", page.get_by_test_id("clock").inner_text())
    return int(found[1]) if found else -1


def on_the_page(page: Any) -> list[Any]:
    """Return what the page shows: tick of bar and scope, texts beside conditions, values."""
    tick, names, now = page.evaluate("[nctaktRun.run.tick, nctaktRun.run.names, nctaktRun.run.now]")
    axes = [page.get_by_test_id(f"axis-{axis}").inner_text() for axis in "XY"]
    beside = page.locator(".nc-inline").all_inner_texts()
    return [shown_tick(page), tick, beside, dict(zip(names, now, strict=True)), axes]


def in_the_session(session: Session, tick: int, names: Sequence[str], file: str) -> list[Any]:
    """Return the same of the session after a tick."""
    if session.branches[1] <= tick:
        session.step(tick + 1 - session.branches[1])
    session.go_to(tick + 1)
    state_view = session.state_view()
    branches = view.branches_in([*state_view.ended, *state_view.cycles], file)
    beside = [
        view.branch_text(branch, LINES[line - 1], TEXTS, has_ended=cycle.state == "ended")
        for line, (cycle, branch) in sorted(branches.items())
    ]
    values = [view.rounded(float(value)) for value in session.read(*names)]
    now = dict(zip(names, values, strict=True))
    axes = [f"{value:.3f}" for value in session.read("X.ACS.ACT_POS", "Y.ACS.ACT_POS")]
    return [tick, tick, beside, now, axes]


def compare(page: Any, session: Session, file: str) -> int:
    """Wait until all that the page shows is as the session has it at the same tick; return it."""
    for _ in range(100):
        shown = on_the_page(page)
        expected = in_the_session(session, shown[0], shown[3].keys(), file)
        if shown == expected:
            return int(shown[0])
        page.wait_for_timeout(200)
    assert shown == expected
    return -1


@pytest.mark.nightly
@pytest.mark.parametrize("seed", [1])
def test_a_walk(walk: tuple[Any, Session, str], seed: int) -> None:
    """By keys and clicks, forward and back: values, conditions, events are those of the tick."""
    page, session, file = walk
    choice = random.Random(seed)
    page.get_by_test_id("tab-events").click()
    for _ in range(12):
        if choice.random() < 0.3 and page.evaluate("nctaktRun.run.latest") > 20:
            scope = page.get_by_test_id("scope").bounding_box()
            x = scope["x"] + 60 + choice.random() * (scope["width"] - 80)
            page.mouse.click(x, scope["y"] + scope["height"] / 2)
        else:
            page.keyboard.press(choice.choice(STEPS))
        page.wait_for_timeout(300)  # until the command has come
        tick = compare(page, session, file)
    rows = page.get_by_test_id("events").locator(".nc-finding > .nc-rows > :first-child")
    expected = [view.event_row(one, "en").text for one in session.events(0, tick + 1)[0]]
    expect(rows).to_have_text(expected[::-1][:80])


def act_beside(page: Any, session: Session, choice: random.Random) -> None:
    """Do the same on the page and, as far as it makes another past, in the session."""
    others = [branch for branch in session.branches if branch != session.branch]
    match choice.randrange(7):
        case 0:
            value = f"{choice.random():.3f}"  # the page sends no value that is there already
            page.get_by_test_id("variable-V.E.VALUE").fill(value)
            page.get_by_test_id("variable-V.E.VALUE").press("Enter")
            page.keyboard.press("Escape")
            session.write({"V.E.VALUE": float(value)}, "page")
        case 1 if others:
            page.keyboard.press("6")
            page.get_by_test_id(f"take_up-{choice.choice(others)}").click()
            page.get_by_test_id("tab-events").click()
        case 2 if session.tick > 0:
            scope = page.get_by_test_id("scope").bounding_box()
            x = scope["x"] + 60 + choice.random() * (scope["width"] - 80)
            page.mouse.click(x, scope["y"] + scope["height"] / 2)
        case 3 if choice.random() < 0.3:
            page.keyboard.press("Space")  # to the end of the program
            page.wait_for_function("nctaktRun.run.bars.end > nctaktRun.run.tick")
        case _:
            page.keyboard.press(choice.choice(STEPS))


def follow(page: Any, session: Session, file: str) -> tuple[int, int, int]:
    """Wait until the page shows the session's past at its tick: events, curves, marks, lanes.

    Returns of how many ticks there are curves, how many marks, and how many samples of lanes.
    """
    rows = page.get_by_test_id("events").locator(".nc-finding > .nc-rows > :first-child")
    for _ in range(20):
        ticks, branch = settled(page)
        if (ticks, branch) != (session.tick, session.branch):
            lived = session.branches.get(branch, 0)
            session.go_to(min(ticks, lived), branch)
            session.step(max(ticks - lived, 0))
        events = session.happened(0, ticks).events
        expected = [" ".join(view.event_row(one, "en").text.split()) for one in events]
        shown = [" ".join(text.split()) for text in rows.all_inner_texts()]
        drawn = page.evaluate(_DRAWN)
        own = of_the_branch(session, drawn, file)
        if (shown, drawn) == (expected[::-1][:80], own):
            break
    assert shown == expected[::-1][:80]
    assert drawn == own
    return len(drawn["ticks"]), len(drawn["marks"]), len(drawn["lanes"])


#: What the scope draws: curves, marks, and lanes as far as they are exact.
_DRAWN = """() => {
  const { names, ticks, columns, marks, bars, lanes, conditions } = nctaktRun.run;
  const lines = bars.lines.map(({ line, bars: found }) => (
    [line, found.filter(([begin]) => begin < bars.end)
      .map(([begin, end]) => [begin, Math.min(end, bars.end)])]));
  const truths = lanes.map(([tick, ...states]) => [tick, states.map((state) => state > 0)]);
  return { names, ticks, columns, marks, conditions, lanes: truths, end: bars.end, lines };
}"""


def of_the_branch(session: Session, drawn: dict[str, Any], file: str) -> dict[str, Any]:
    """Return the same of the branch that the session is in, for the ticks and up to the marks."""
    latest, names, end = session.branches[session.branch], drawn["names"], drawn["end"]
    ticks = [tick for tick in drawn["ticks"] if tick < latest]
    _, cells = session.look(0, latest, names, latest) if latest else (1, memoryview(b""))
    rows = [cells[tick * len(names) : (tick + 1) * len(names)].tolist() for tick in ticks]
    columns = [[view.rounded(row[column]) for row in rows] for column in range(len(names))]
    marks = [list(mark) for mark in marks_of(session.events(0, latest)[0], file)]
    reaches = max((mark[0] for mark in drawn["marks"]), default=-1)
    whole = bars_of(session.why(latest, session.branch), file) if latest else []
    of_line = {one["line"]: one["bars"] for one in whole}
    bars = [of_line.get(line, []) for line in drawn["conditions"]]
    shown = bars_of(session.why(min(end, latest), session.branch), file) if end else []
    return {
        "names": names,
        "ticks": ticks,
        "columns": columns,
        "marks": [mark for mark in marks if mark[0] <= reaches],
        "conditions": drawn["conditions"],
        "end": min(end, latest),
        "lanes": [
            [tick, [any(first <= tick < last for first, last in own) for own in bars]]
            for tick, _ in drawn["lanes"]
            if tick < latest
        ],
        "lines": [
            [one["line"], [[first, min(last, end)] for first, last in one["bars"] if first < end]]
            for one in shown
        ],
    }


def settled(page: Any) -> tuple[int, int]:
    """Return how many ticks of which branch the bar shows, once it has shown the same for 2 s."""
    seen: list[str] = []
    while len(seen) < 8 or len(set(seen[-8:])) > 1:
        seen.append(page.get_by_test_id("clock").inner_text())
        page.wait_for_timeout(250)
    branch = re.search(r"Branch (\d+)", seen[-1])
    assert branch is not None
    return shown_tick(page) + 1, int(branch[1])


@pytest.mark.nightly
@seeds_in_parts(1, 1, 1)
def test_events_are_those_of_the_branch(browser: Any, tmp_path: Path, seeds: range) -> None:
    """Travel, inputs in the past, other branches: each event of the shown past once, no other.

    Curves, marks and the exact part of lanes are those of the shown branch, too.
    """
    path = tmp_path / "branches.nc"
    path.write_text(PROGRAM, "utf-8")
    for seed in seeds:
        choice = random.Random(seed)
        with served(str(path)) as address, Session(path) as session:
            page = opened(browser, address)
            page.get_by_test_id("tab-events").click()
            compared = []
            for _ in range(16):
                act_beside(page, session, choice)
                compared.append(follow(page, session, str(path)))
            assert all(max(one) > 0 for one in zip(*compared, strict=True)), compared
            page.close()


@pytest.mark.nightly
def test_lanes_and_answers(walk: tuple[Any, Session, str]) -> None:
    """Lanes are there when the run stops, become exact, and stay in the past; so does the answer.

    When the program has ended, the answer is that of the last tick of the cycle.
    """
    page, session, file = walk
    page.keyboard.press("End")
    page.get_by_test_id("speed").click()
    page.get_by_role("option", name="max").click()
    page.get_by_test_id("toggle").click()
    expect(page.get_by_test_id("state")).to_have_text(re.compile("^ended"))
    session.run()
    exact = bars_of(session.why(), file)
    page.wait_for_function("nctaktRun.run.bars.end === nctaktRun.run.latest + 1")
    assert page.evaluate("nctaktRun.run.bars.lines") == exact
    compare(page, session, file)
    page.locator(".nc-inline").first.click()
    answer = page.get_by_test_id("why")
    expect(answer).to_contain_text("the last one of its cycle")
    assert answer.inner_text().splitlines()[0].startswith("line 2: ")

    page.keyboard.press("Home")
    for _ in range(3):
        page.keyboard.press("b")
        page.wait_for_timeout(300)
    settled(page)
    tick = compare(page, session, file)
    expect(answer).to_contain_text(f"in tick {tick} (")
    assert page.evaluate("nctaktRun.run.bars.lines") == exact
    compare(page, session, file)


@pytest.mark.nightly
def test_lanes_of_branches(browser: Any, tmp_path: Path) -> None:
    """Travel, an input in the past, the first branch again: lanes are there at once, and exact."""
    path = tmp_path / "lanes.nc"
    path.write_text(PROGRAM, "utf-8")
    bars = "nctaktRun.run.conditions.map((line, row) => nctaktRun.laneBars(line, row))"
    with served(str(path)) as address, Session(path) as session:
        page = opened(browser, address)
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max").click()
        page.get_by_test_id("toggle").click()
        expect(page.get_by_test_id("state")).to_have_text(re.compile("^ended"))
        session.run()
        page.wait_for_function("nctaktRun.run.bars.end === nctaktRun.run.latest + 1")
        page.keyboard.press("R")
        expect(page.get_by_test_id("state")).to_have_text(re.compile("^paused"))
        tick = shown_tick(page)
        page.get_by_test_id("variable-V.E.VALUE").fill("0.75")
        page.get_by_test_id("variable-V.E.VALUE").press("Enter")
        page.keyboard.press("Escape")
        expect(page.get_by_test_id("clock")).to_contain_text("Branch 2")
        # what both branches share is exact at once; of the first one's future nothing is left
        shared = page.evaluate("nctaktRun.run.bars.end")
        assert shared == tick + 1
        drawn = page.evaluate(bars)
        assert max(end for line in drawn for _, end, _ in line) <= shared
        assert all(is_exact for line in drawn for *_, is_exact in line)

        page.keyboard.press("6")
        page.get_by_test_id("take_up-1").click()
        expect(page.get_by_test_id("clock")).to_contain_text("Branch 1")
        page.wait_for_function("nctaktRun.run.bars.end === nctaktRun.run.latest + 1")
        assert page.evaluate("nctaktRun.run.bars.lines") == bars_of(session.why(), str(path))
        page.close()


#: Where the current block is in the editor: whether it is in view.
_IN_VIEW = """() => {
  const room = document.querySelector(".cm-scroller").getBoundingClientRect();
  const block = document.querySelector(".cm-line.nc-block")?.getBoundingClientRect();
  return Boolean(block && block.top >= room.top - 1 && block.bottom <= room.bottom + 1);
}"""


@pytest.mark.nightly
def test_the_block_is_in_view_and_the_focus_stays(browser: Any, tmp_path: Path) -> None:
    """While it plays and after travel, in 2,000 lines; stops in the gutter."""
    path = tmp_path / "long.nc"
    lines = [PROGRAM[: PROGRAM.index("G01")].rstrip()]
    lines += [f"G01 X{number % 7} Y{number % 5} F60000" for number in range(2000)]
    path.write_text("\n".join([*lines, "M30", ""]), "utf-8")
    with served(str(path)) as address, Session(path) as session:
        page = opened(browser, address)
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="×10", exact=True).click()
        page.get_by_test_id("toggle").click()
        page.wait_for_function("nctaktRun.run.block > 60 && nctaktRun.run.isPlaying")
        page.wait_for_function(_IN_VIEW)
        page.keyboard.press("Space")
        page.wait_for_function("!nctaktRun.run.isPlaying && nctaktRun.run.latest > 100")
        scope = page.get_by_test_id("scope").bounding_box()
        page.mouse.click(scope["x"] + scope["width"] / 3, scope["y"] + scope["height"] / 2)
        page.wait_for_function("nctaktRun.run.tick < nctaktRun.run.latest")
        page.wait_for_function(_IN_VIEW)
        tick, line = page.evaluate("[nctaktRun.run.tick, nctaktRun.run.block]")
        session.step(tick + 1)
        assert session.latest.blocks[1].line == line
        expect(page.locator(".cm-line.nc-block")).to_have_text(
            path.read_text().split("\n")[line - 1]
        )

        numbers = page.locator(".cm-lineNumbers .cm-gutterElement")
        numbers.get_by_text(str(line), exact=True).click()
        expect(page.locator(".cm-lineNumbers .nc-stopped")).to_have_text(str(line))
        assert page.evaluate("document.activeElement.closest('.cm-editor')") is None
        page.close()
