# SPDX-License-Identifier: MIT
"""The branches of the tape on the page: named, taken up again, compared.

In: a shared session. Out: rows of NiceGUI, one for each branch.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from nicegui import ui

from nctakt.live.parts.commander import Commander
from nctakt.live.parts.naming import explained, named
from nctakt.live.view import plain_number
from nctakt.session.history.comparing import BranchDifference

#: Characters of a name, and differing signals that are listed.
_MAX_NAME, _MAX_SIGNALS = 40, 8


class BranchList:
    """The branches of the session, for one browser; built where it is created."""

    def __init__(self, commander: Commander) -> None:
        self._commander = commander
        self._shared = commander.shared
        self._texts = commander.texts
        self._subject: object = None
        self._names: dict[int, str] = {}
        self._rows = ui.element("div")
        self._answer = ui.label().classes("nc-why").props("role=status data-testid=difference")

    def show(self) -> None:
        """Show new data."""
        shared, session = self._shared, self._shared.session
        ends, names = session.branches, dict(shared.branch_names)
        subject = shared.snapshot.serial, session.branch, tuple(ends)
        if self._subject != subject:
            self._subject = subject
            self._answer.set_text("")
            self._build(session.origins, session.branch, names)
        for number, field in self._fields.items():
            if self._names.get(number) != names.get(number):  # another browser has named it
                field.set_value(names.get(number, ""))
        self._names = names
        for number, end in ends.items():
            label = self._ends.get(number)
            text = self._texts["branch_end"].format(tick=end - 1) if end else ""
            if label is not None and label.text != text:
                label.set_text(text)

    def _build(
        self, origins: dict[int, tuple[int, int]], present: int, names: dict[int, str]
    ) -> None:
        texts, self._ends = self._texts, dict[int, ui.label]()
        self._fields, self._names = dict[int, ui.input](), names
        self._rows.clear()
        with self._rows:
            for number, (parent, first) in origins.items():
                marked = " message" if number == present else ""
                row = ui.element("div").classes(f"nc-row nc-branch nc-finding{marked}")
                with row.props(f"data-testid=branch-{number}"):
                    ui.label(f"{texts['branch']} {number}").classes("nc-number")
                    name = ui.input(value=names.get(number, ""), placeholder=texts["branch_name"])
                    name.props(f"dense borderless maxlength={_MAX_NAME}")
                    named(name, f"{texts['branch_name']}: {number}")
                    name.on("change", partial(self._rename, number, name))
                    self._fields[number] = name
                    if parent:
                        begin = texts["branch_origin"].format(branch=parent, tick=first)
                        ui.label(begin).classes("nc-soft ellipsis")
                    self._ends[number] = ui.label().classes("nc-soft ellipsis")
                    if number != present:
                        self._add_button("compare", "difference", number, self._compare)
                        self._add_button("take_up", "login", number, self._take_up)

    def _add_button(self, name: str, icon: str, number: int, act: Any) -> None:
        button = ui.button(icon=icon, on_click=partial(act, number))
        button.props(f"dense flat size=xs data-testid={name}-{number}")
        explained(button, f"{self._texts[name]}: {self._texts['branch']} {number}")

    def _rename(self, number: int, field: ui.input, _: Any) -> None:
        if self._commander.may():
            self._shared.name_branch(number, str(field.value or "")[:_MAX_NAME])

    async def _take_up(self, number: int) -> None:
        """Go to the end of a branch."""
        await self._commander.do(lambda session: session.go_to(session.branches[number], number))

    async def _compare(self, number: int) -> None:
        """Show where a branch first differs from the one shown."""
        found: list[BranchDifference] = []
        own = self._shared.session.branch
        if await self._commander.do(
            lambda session: found.append(session.compare_branches(own, number))
        ):
            self._answer.set_text(self._difference(own, number, found[0]))

    def _difference(self, one: int, other: int, found: BranchDifference) -> str:
        texts = self._texts
        words = {"one": one, "other": other, "fork": found.fork, "end": found.end - 1}
        if found.tick is None:
            return texts["no_difference"].format(**words)
        lines = [texts["difference"].format(**words, tick=found.tick)]
        lines += [
            f"{name}: {plain_number(first)} / {plain_number(second)}"
            for name, first, second in found.signals[:_MAX_SIGNALS]
        ]
        if len(found.signals) > _MAX_SIGNALS:
            lines.append(texts["more_signals"].format(count=len(found.signals) - _MAX_SIGNALS))
        return "\n".join(lines)
