# SPDX-License-Identifier: MIT
"""What the live page shows of a run, read from it, and the same of a session beside it."""

import json
import math
import random
import re
from collections.abc import Callable
from typing import Any

from nctakt import Session
from nctakt.base.diagnostics import Language
from nctakt.live import view
from nctakt.live.parts.explaining import bars_of
from nctakt.live.texts import Texts
from nctakt.live.track import MAX_MARKS, blocks_of, marks_of
from nctakt.session.core import MAX_ROWS as LOOKED_AT

ENGLISH: Language = "en"
TEXTS = Texts(ENGLISH)

#: How long the page may take to show something, in seconds.
PATIENCE_S = 30.0

#: Rows that the list of events shows.
MAX_ROWS = 80

#: Whether the page is there.
LOADED = """globalThis.nctaktRun && document.querySelector(".cm-line")
  && document.querySelector("[data-testid=clock]")?.textContent"""

#: All that is on the page, in one look; texts of the scope are those of a new drawing.
READ = """async () => {
  const text = (name) => document.querySelector(`[data-testid="${name}"]`)?.textContent ?? null;
  const named = (name) => [...document.querySelectorAll(`[data-testid^="${name}"]`)];
  const all = (name) => Object.fromEntries(named(name)
    .map((one) => [one.dataset.testid.slice(name.length), one.value ?? one.textContent]));
  const content = document.querySelector(".cm-content");
  const editor = (content.cmTile ?? content.cmView).view;
  const numberOf = (element) => editor.state.doc.lineAt(editor.posAtDOM(element)).number;
  const beside = [...document.querySelectorAll(".cm-line .nc-inline")]
    .map((one) => [numberOf(one.closest(".cm-line")), one.textContent]);
  const block = [...document.querySelectorAll(".cm-line.nc-block")].map(numberOf);
  const { visibleRanges } = editor;
  const inView = [editor.state.doc.lineAt(visibleRanges[0].from).number,
    editor.state.doc.lineAt(visibleRanges.at(-1).to).number];
  const drawn = [], pen = CanvasRenderingContext2D.prototype, { fillText } = pen;
  const canvas = document.querySelector("[data-testid=scope] canvas");
  pen.fillText = function (words, ...rest) {
    if (this.canvas === canvas) drawn.push(words);
    return fillText.call(this, words, ...rest);
  };
  nctaktRun.changed();
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  pen.fillText = fillText;
  const rows = [...document.querySelectorAll(
    "[data-testid=events] .nc-finding > .nc-rows > :first-child")].map((one) => one.textContent);
  const branches = [...document.querySelectorAll('[data-testid^="branch-"]')]
    .map((one) => one.textContent);
  const { run } = nctaktRun;
  return {
    clock: text("clock"), state: text("state"), speed: text("path-speed"),
    percent: text("percent"), axes: all("axis-"), rests: all("rest-"), beside, block, inView,
    variables: all("variable-V.E."), drawn, rows, branches, tick: run.tick,
    latest: run.latest, names: run.names, units: run.units, booleans: run.booleans,
    hidden: run.hidden, now: run.now, cursor: run.cursor, anchor: run.anchor, line: run.block,
    ticks: run.ticks, columns: run.columns, detail: run.detail, marks: run.marks,
    blocks: run.blocks, conditions: run.conditions, lanes: run.lanes, bars: run.bars,
    tool: run.drawn?.tool ?? null, toolTick: run.drawn?.tick ?? null,
  };
}"""

#: Whether it plays, or has found that the run is over.
_HAS_BEGUN = """(before) => document.querySelector("[data-testid=clock]").textContent !== before
  || document.querySelector("[data-testid=state]").textContent.startsWith("ended")"""

_BAR = """() => ["clock", "state"]
  .map((name) => document.querySelector(`[data-testid=${name}]`).textContent)"""


def place_of(shown: dict[str, Any]) -> tuple[int, int]:
    """Return how many ticks of which branch the bar says."""
    found = re.match(r"(?:Tick (\d+) · ([\d.]+) ms|before tick 0) · Branch (\d+)", shown["clock"])
    assert found is not None, shown["clock"]
    return (0 if found[1] is None else int(found[1]) + 1), int(found[3])


def number_text(value: float) -> str:
    """Return a number of the scope's legend: that of ``short`` in JavaScript."""
    if value.is_integer():  # from 1e21 on JavaScript writes whole numbers with an exponent
        return str(int(value)) if abs(value) < 1e21 else script_number(value)
    return script_number(float(f"{value:.6g}"))


def script_number(value: float) -> str:
    """Return a number as JavaScript writes it."""
    text = repr(value)
    if "e" in text:
        mantissa, exponent = text.split("e")
        if -7 <= int(exponent) < 0:
            return (
                f"{value:.{-int(exponent) + len(mantissa.replace('-', '').replace('.', '')) - 1}f}"
            )
        return f"{mantissa}e{int(exponent):+d}"
    return text.removesuffix(".0")


class Beside:
    """A session at the place that the page shows, and what the page has to show of it."""

    def __init__(self, session: Session, file: str, lines: list[str]) -> None:
        self.session = session
        self.file = file
        self.lines = lines
        self._known: dict[tuple[object, ...], Any] = {}

    def _once(self, what: str, of: Callable[[], Any], *words: object) -> Any:
        """Return what the past of this place answers, asked once."""
        session = self.session
        here = session.tick, session.branch, tuple(session.branches.items())
        if self._known.get(("here",)) != here:
            self._known = {("here",): here}
        if (what, *words) not in self._known:
            self._known[what, *words] = of()
        return self._known[what, *words]

    def stand(self, ticks: int, branch: int) -> None:
        """Go to the place of the page; ticks that have not run yet are run."""
        session = self.session
        lived = session.branches.get(branch, 0)
        if (session.tick, session.branch) != (min(ticks, lived), branch):
            session.go_to(min(ticks, lived), branch)
        if ticks > lived:
            session.step(ticks - lived)

    def differences(self, shown: dict[str, Any]) -> list[str]:
        """Return in what the page differs; the session is where the page says it does."""
        ticks, branch = place_of(shown)
        self.stand(ticks, branch)
        found = []
        for name, expected, there in (
            *self._readings(shown, ticks),
            *self._program(shown),
            *self._past(shown, ticks),
            *self._curves(shown),
        ):
            if expected != there:
                found.append(
                    f"{name}: {json.dumps(there)[:1500]} instead of {json.dumps(expected)[:1500]}"
                )
        return found

    def _readings(self, shown: dict[str, Any], ticks: int) -> list[tuple[str, Any, Any]]:
        session, names = self.session, shown["names"]
        values = dict(zip(names, session.read(*names), strict=True))
        axes = list(shown["axes"])
        places = session.read(*(f"{one}.ACS.ACT_POS" for one in axes))
        rests = session.read(*(f"{one}.PCS.DIST_TO_GO" for one in axes))
        speed, percent = session.read("PATH.SPEED", "HLI.OVERRIDE")
        variables = {one: float(value) for one, value in shown["variables"].items() if value}
        known = session.read(*(f"V.E.{one}" for one in variables))
        return [
            ("tick of scope and path", [ticks - 1] * 2, [shown["tick"], shown["toolTick"]]),
            ("latest", session.branches[session.branch] - 1, shown["latest"]),
            ("now", [view.rounded(float(values[one])) for one in names], shown["now"]),
            ("axes", [f"{value:.3f}" for value in places], list(shown["axes"].values())),
            ("rests", [f"{value:.3f}" for value in rests], list(shown["rests"].values())),
            (
                "speed",
                [f"{speed * 60:.0f}", f"{percent:.0f} %"],
                [shown["speed"], shown["percent"]],
            ),
            ("variables", dict(zip(variables, map(float, known), strict=True)), variables),
            ("legend", *self._legend(shown, ticks)),
        ]

    def _legend(self, shown: dict[str, Any], ticks: int) -> tuple[list[str], list[str]]:
        """Return what the legend says at the cursor, or at the session's tick; and what it has."""
        names = shown["names"][: len(shown["names"]) - shown["hidden"]]
        cursor = shown["cursor"]
        if shown["anchor"] is not None:
            return [], []
        if cursor is None or cursor == shown["tick"]:
            row = [float(value) for value in self.session.read(*names)]
        else:
            cells = self.session.look(cursor, cursor + 1, names)[1]
            row = [float(cell) for cell in cells] or [math.nan] * len(names)
        expected = []
        for name, unit, is_boolean, value in zip(
            names, shown["units"], shown["booleans"], row, strict=False
        ):
            factor = 60 if unit == "mm/s" else 1
            number = float(view.rounded(float(value)) or 0.0)
            text = ("TRUE" if number > 0 else "FALSE") if is_boolean else None
            text = text or number_text(number * factor)
            expected.append(f"{name.replace('.ACS.ACT_POS', '')} {text}")
        starts = [name.replace(".ACS.ACT_POS", "") + " " for name in names]
        there = [one for one in shown["drawn"] if any(one.startswith(name) for name in starts)]
        for one in [one for one in there if one.endswith("…")]:  # there is no room for all of it
            whole = [text for text in expected if text.startswith(one[:-1])]
            there = [*(text for text in there if text != one), *(whole[:1] or [one])]
        if len(there) < len(names):
            expected = [one for one in expected if one in there]
        return sorted(expected), sorted(there)

    def _program(self, shown: dict[str, Any]) -> list[tuple[str, Any, Any]]:
        state = self.session.state_view()
        branches = view.branches_in([*state.ended, *state.cycles], self.file)
        first, last = shown["inView"]
        beside = [
            [line, view.branch_text(
                branch, self.lines[line - 1], TEXTS, has_ended=cycle.state == "ended")]
            for line, (cycle, branch) in sorted(branches.items())
        ]  # fmt: skip
        span = self.session.latest.blocks.get(1)
        line = span.line if span is not None and span.file == self.file else 0
        is_seen = first <= line <= last
        return [
            ("beside", [one for one in beside if first <= one[0] <= last],
             [one for one in shown["beside"] if first <= one[0] <= last]),
            ("block", line, shown["line"]),
            ("marked block", [line] if is_seen else [],
             [one for one in shown["block"] if first <= one <= last]),
        ]  # fmt: skip

    def _past(self, shown: dict[str, Any], ticks: int) -> list[tuple[str, Any, Any]]:
        """Compare events, marks and blocks: those of the branch shown, each once."""
        session = self.session
        done = self._once("happened", lambda: session.happened(0, ticks))
        rows = [" ".join(view.event_row(one, ENGLISH).text.split()) for one in done.events]
        there = [" ".join(one.split()) for one in shown["rows"]]
        count = len(rows) + done.left_out
        notes = [one for one in there if one.endswith("left out")]
        there = [one for one in there if one not in notes]
        hidden = [f"{count - len(there)} older ones left out"] if count > len(there) else []
        latest = session.branches[session.branch]
        events, left_out = self._once("events", lambda: session.events(0, latest))
        marks = [list(one) for one in marks_of(events, self.file)][-MAX_MARKS:]
        blocks = [list(one) for one in blocks_of(events, 1, self.file)]
        if left_out:  # only those that have come while it played
            marks = shown["marks"]
            blocks = shown["blocks"]
        return [
            *([("events", rows[::-1][:MAX_ROWS], there)] if shown["rows"] else []),
            *([("left out", hidden, notes)] if shown["rows"] else []),
            ("marks", marks, shown["marks"]),
            ("blocks", blocks, shown["blocks"]),
            ("branches", self._branches(), shown["branches"] or self._branches()),
        ]

    def _branches(self) -> list[str]:
        session = self.session
        found = []
        for number, (parent, first) in session.origins.items():
            end = session.branches[number]
            text = f"Branch {number}"
            text += f"leaves {parent} at tick {first}" if parent else ""
            text += f"up to tick {end - 1}" if end else ""
            text += "" if number == session.branch else "differencelogin"
            found.append(text)
        return found

    def _looked_at(self, latest: int, names: list[str]) -> list[float]:
        """Return the signals after all ticks of the branch."""
        cells: list[float] = []
        for first in range(0, latest, LOOKED_AT):
            end = min(latest, first + LOOKED_AT)
            cells += self.session.look(first, end, names, LOOKED_AT)[1].tolist()
        return cells

    def _curves(self, shown: dict[str, Any]) -> list[tuple[str, Any, Any]]:
        session, names = self.session, shown["names"]
        latest = session.branches[session.branch]
        found: list[tuple[str, Any, Any]] = []
        width = len(names)
        whole = self._once("look", lambda: self._looked_at(latest, names), *names)
        parts = {"curves": shown, "detail": shown["detail"] or {"ticks": [], "columns": []}}
        for name, part in parts.items():
            if name == "detail" and shown["detail"] and part["names"] != names:
                continue
            rows = [whole[tick * width : (tick + 1) * width] for tick in part["ticks"]]
            columns = [
                [view.rounded(row[column]) for row in rows if row] for column in range(width)
            ]
            found.append((name, columns, part["columns"] or [[] for _ in names]))
        end = min(shown["bars"]["end"], latest)
        bars = []
        if end:
            report = self._once("why", lambda: session.why(end, session.branch), end)
            bars = bars_of(report, self.file)
        cut = [
            [one["line"], [[a, min(b, end)] for a, b in one["bars"] if a < end]]
            for one in shown["bars"]["lines"]
        ]
        expected = [
            [one["line"], [[a, min(b, end)] for a, b in one["bars"] if a < end]] for one in bars
        ]
        is_known = {line for line, _ in expected}
        found.append(
            ("exact lanes", expected, [one for one in cut if one[1] or one[0] in is_known])
        )
        return found


def settle(page: Any, beside: Beside, target: tuple[int, int] | None) -> dict[str, Any]:
    """Wait until the page is at a target, or rests, and shows all of it; return it."""
    passed, before = 0.0, ""
    while True:
        clock, state = page.evaluate(_BAR)
        is_there = place_of({"clock": clock}) == target
        if target is None:
            is_there = state != "running" and clock == before
        before = clock
        wrong = [f"stands at {clock} ({state}) instead of {target}"]
        if is_there:
            shown: dict[str, Any] = page.evaluate(READ)
            wrong = beside.differences(shown)
            if not wrong:
                return shown
        assert passed < PATIENCE_S, "\n".join(wrong)
        page.wait_for_timeout(150)
        passed += 0.15


def press(page: Any, session: Session, key: str) -> tuple[int, int]:
    """Press a key that leads to another tick; return the place to which it leads."""
    page.keyboard.press(key)
    match key:
        case ".":
            session.step(1)
        case ",":
            session.back(1)
        case "b":
            session.next_block()
        case "B":
            session.previous_block()
        case "r":
            session.next_reaction()
        case "R":
            session.previous_reaction()
        case "Home":
            session.go_to(0)
        case "End":
            session.go_to(session.branches[session.branch])
        case "Space":
            session.run()
    return session.tick, session.branch


def point(page: Any, name: str, choice: random.Random) -> None:
    """Move the pointer to somewhere in a drawing."""
    box = page.get_by_test_id(name).bounding_box()
    x = box["x"] + 60 + choice.random() * (box["width"] - 80)
    page.mouse.move(x, box["y"] + box["height"] * (0.2 + 0.7 * choice.random()))


def write(page: Any, session: Session, choice: random.Random) -> tuple[int, int]:
    """Write a value in a field of the page, in the past a branch begins with it."""
    name = choice.choice(["V.E.VALUE", "V.E.VALUE1", "V.E.COUNT", "V.E.TRIGGER"])
    value = choice.randrange(1, 1000) + (choice.random() if "VALUE" in name else 0)
    field = page.get_by_test_id(f"variable-{name}")
    value = float(f"{value:.3f}")
    if session.read(name) != [value]:
        field.fill(f"{value:g}" if value.is_integer() else f"{value:.3f}")
        field.press("Enter")
        page.keyboard.press("Escape")
        session.write({name: value}, "page")
    return session.tick, session.branch


def travel_by(page: Any, session: Session, name: str, choice: random.Random) -> tuple[int, int]:
    """Click in scope or path; the pointer may stay or leave."""
    point(page, name, choice)
    cursor = page.evaluate(
        "new Promise((done) => requestAnimationFrame(() => done(nctaktRun.run.cursor)))"
    )
    page.mouse.down()
    page.mouse.up()
    latest = session.branches[session.branch]
    if cursor is not None:
        session.go_to(max(0, min(cursor + 1, latest)))
    if choice.random() < 0.6:
        page.mouse.move(5, 5)
    return session.tick, session.branch


def act(page: Any, session: Session, choice: random.Random) -> tuple[str, tuple[int, int] | None]:
    """Do something on the page and in the session; return what, and the place it leads to.

    The place is not known where the page is paused while it plays.
    """
    others = [branch for branch in session.branches if branch != session.branch]
    kind = choice.choice(
        ["key"] * 6
        + ["write"] * 3
        + ["scope"] * 2
        + ["path", "take up", "play", "end", "reload", "zoom", "override"]
    )
    match kind:
        case "write":
            return kind, write(page, session, choice)
        case "scope" | "path" if session.branches[session.branch] > 0:
            return kind, travel_by(page, session, kind, choice)
        case "take up" if others:
            number = choice.choice(others)
            page.keyboard.press("6")
            page.get_by_test_id(f"take_up-{number}").click()
            session.go_to(session.branches[number], number)
            if choice.random() < 0.5:
                page.keyboard.press("3")
        case "play" if not session.is_over:
            before = page.get_by_test_id("clock").inner_text()
            page.keyboard.press("Space")
            page.wait_for_function(_HAS_BEGUN, arg=before)
            page.wait_for_timeout(choice.randrange(400))
            page.get_by_test_id("toggle").click()
            return kind, None
        case "end" if choice.random() < 0.5:
            return kind, press(page, session, "Space")
        case "reload":
            page.reload()
            page.wait_for_function(LOADED)
            page.keyboard.press("3")
        case "zoom":
            point(page, "scope", choice)
            page.mouse.wheel(0, choice.choice([-300, -150, 200]))
            page.mouse.move(5, 5)
        case "override":
            page.keyboard.press("PageDown")
            override = float(session.read("HLI.OVERRIDE")[0])
            if override > 5:
                session.write({"HLI.OVERRIDE": override - 5}, "page")
        case _:
            key = choice.choice([".", ",", "b", "B", "r", "R", "Home", "End"])
            return key, press(page, session, key)
    return kind, (session.tick, session.branch)
