# SPDX-License-Identifier: MIT
"""The keys of the live page: the action of each, and its text in the help."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language


@dataclass(frozen=True, slots=True)
class Key:
    """A key of the page: its name as a browser gives it, the command, how a person names it.

    ``label``: in English and German. ``is_everywhere``: also in fields and the editor.
    """

    key: str
    command: str
    label: tuple[str, str]
    is_everywhere: bool = False


def _same(key: str, command: str, label: str, *, is_everywhere: bool = False) -> Key:
    return Key(key, command, (label, label), is_everywhere)


#: Groups of keys with their headings, in the order of the help.
GROUPS: tuple[tuple[str, tuple[Key, ...]], ...] = (
    (
        "keys_run",
        (
            Key(" ", "toggle", ("Space", "Leertaste")),
            _same(".", "tick", "."),
            _same(",", "back_tick", ","),
            _same("b", "block", "B"),
            Key("B", "back_block", ("Shift+B", "⇧B")),
            _same("r", "reaction", "R"),
            Key("R", "back_reaction", ("Shift+R", "⇧R")),
            Key("C", "back_stop", ("Shift+C", "⇧C")),
            _same("n", "next_match", "N"),
            Key("N", "previous_match", ("Shift+N", "⇧N")),
            Key("Home", "home", ("Home", "Pos1")),
            Key("End", "front", ("End", "Ende")),
            _same("+", "faster", "+"),
            _same("-", "slower", "−"),
        ),
    ),
    (
        "keys_panel",
        (
            _same("s", "start", "S"),
            _same("h", "hold", "H"),
            _same("l", "single", "L"),
            _same("w", "backward", "W"),
            Key("Z", "reset", ("Shift+Z", "⇧Z")),
            Key("PageUp", "override_up", ("Page up", "Bild auf")),
            Key("PageDown", "override_down", ("Page down", "Bild ab")),
            _same("a", "acknowledge", "A"),
        ),
    ),
    (
        "keys_program",
        (
            Key("save", "save", ("Ctrl+S", "Strg+S"), is_everywhere=True),
            _same("F9", "toggle_stop", "F9", is_everywhere=True),
            _same("F8", "why", "F8", is_everywhere=True),
            Key("F1", "explain", ("F1", "F1"), is_everywhere=True),
            Key("F4", "finding", ("F4, Shift+F4", "F4, ⇧F4"), is_everywhere=True),
            Key("complete", "complete", ("Ctrl+Space", "Strg+Leertaste"), is_everywhere=True),
            _same("e", "edit", "E"),
            _same("g", "find", "G"),
            _same("/", "search_variable", "/"),
            Key("Escape", "leave", ("Esc", "Esc"), is_everywhere=True),
        ),
    ),
    (
        "keys_plc",
        (
            _same("i", "plc_into", "I"),
            _same("o", "plc_over", "O"),
            _same("u", "plc_out", "U"),
            Key("I", "plc_back_into", ("Shift+I", "⇧I")),
            Key("O", "plc_back_over", ("Shift+O", "⇧O")),
            Key("U", "plc_back_out", ("Shift+U", "⇧U")),
            _same("t", "plc_next_file", "T"),
            _same("c", "condition", "C"),
            _same("F2", "plc_edit", "F2", is_everywhere=True),
        ),
    ),
    (
        "keys_view",
        (
            _same("ArrowLeft", "scope_left", "←"),
            _same("ArrowRight", "scope_right", "→"),
            _same("ArrowUp", "scope_in", "↑"),
            _same("ArrowDown", "scope_out", "↓"),
            _same("0", "scope_fit", "0"),
            _same("j", "lanes_down", "J"),
            _same("k", "lanes_up", "K"),
            _same("f", "filter_lanes", "F"),
            Key("F", "search_events", ("Shift+F", "⇧F")),
            _same("m", "scope_mark", "M"),
            _same("v", "turn_view", "V"),
            _same("x", "machine_axes", "X"),
            _same("1", "tab_findings", "1"),
            _same("2", "tab_messages", "2"),
            _same("3", "tab_events", "3"),
            _same("4", "tab_why", "4"),
            _same("5", "tab_stops", "5"),
            _same("6", "tab_branches", "6"),
            _same("7", "tab_time", "7"),
            _same("p", "take_control", "P"),
            _same("d", "dark", "D"),
            _same("?", "help", "?"),
        ),
    ),
)

KEYS = {key.key: key for _, keys in GROUPS for key in keys}


def label_of(command: str, language: Language) -> str:
    """Return how a person names the key of a command."""
    key = next(key for key in KEYS.values() if key.command == command)
    return key.label[1 if language == "de" else 0]
