# SPDX-License-Identifier: MIT
"""The tab of times shows what ``nctakt time`` says of the branch that is shown."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, axe_source, chromium, opened, serious, served

from nctakt import Controller
from nctakt.base.diagnostics import Language
from nctakt.timing.account import account_for
from nctakt.timing.table import time_tables

pytestmark = BROWSER

PROGRAM = (
    """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 50
    V.RTG.OVERRIDE.VEL.CYCLE = 50
  $ENDIF
#RT CYCLE END
N10 G01 X100 F6000
N20 G04 0.2
N30 G00 Y50
"""
    + "; far away\n" * 300
    + "N40 G01 X0 Y0\nM30\n"
)


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def cells(page: Any) -> list[list[list[str]]]:
    """The texts of the tables: table, row, cell."""
    return page.evaluate(  # type: ignore[no-any-return]
        "[...document.querySelectorAll('.nc-times')].map(table => [...table.rows].map("
        "row => [...row.cells].map(cell => cell.textContent)))"
    )


def cells_of_run(
    path: Path, language: Language = "en", ticks: int | None = None
) -> list[list[list[str]]]:
    """The cells of the tables of a run of its own."""
    account = account_for(Controller(), {1: [path]}, ticks=ticks)
    [(_, tables)] = time_tables(account, language)
    return [[list(table.heads), *map(list, table.rows)] for table in tables]


def wait_for_state(page: Any, text: str) -> None:
    """Wait until all ticks are accounted for."""
    page.wait_for_function(
        "text => document.querySelector('[data-testid=time-state]')?.textContent === text", arg=text
    )


def test_tab_has_the_tables_of_the_run(browser: Any, tmp_path: Path) -> None:
    """Ticks of the past, then of the whole run; a click on a block shows its line."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    ticks = Controller().run(path).ticks
    with served(str(path)) as address:
        page = opened(browser, address)
        page.get_by_test_id("state").click()
        page.keyboard.press("7")
        wait_for_state(page, "No tick has run yet.")
        for _ in range(3):
            page.get_by_test_id("tick").click()
        wait_for_state(page, "Where the 3 ticks of this branch went")
        assert cells(page) == cells_of_run(path, ticks=3)
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max", exact=True).click()
        page.get_by_test_id("toggle").click()
        wait_for_state(page, f"Where the {ticks} ticks of this branch went")
        assert cells(page) == cells_of_run(path)
        shown = (
            "[...document.querySelectorAll('.cm-line')].some(one => one.textContent.includes('{}'))"
        )
        page.wait_for_function(shown.format("N40"))
        page.locator(".nc-times tr", has_text="7: N20").click()
        page.wait_for_function(shown.format("N20"))
        assert serious(page, axe_source(tmp_path)) == []
        page.close()


def test_tab_in_german(browser: Any, tmp_path: Path) -> None:
    """Heads and causes are those of ``nctakt time --lang de``."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with served(str(path), "--lang", "de") as address:
        page = opened(browser, address)
        page.get_by_test_id("tab-time").click()
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max", exact=True).click()
        page.get_by_test_id("toggle").click()
        ticks = Controller().run(path).ticks
        wait_for_state(page, f"Wo die {ticks} Takte dieses Zweigs blieben")
        assert cells(page) == cells_of_run(path, "de")
        page.close()
