# SPDX-License-Identifier: MIT
"""The words of the live page, in English and German."""

from __future__ import annotations

from nctakt.base.diagnostics import Language

_WORDS: dict[str, tuple[str, str]] = {
    "tick_number": ("Tick", "Takt"),
    "branch": ("Branch", "Zweig"),
    "edited": ("not saved", "nicht gespeichert"),
    "next_tick": ("Acts from the next tick on.", "Wirkt ab dem nächsten Takt."),
    "home": ("Back to the first tick (Home)", "Zurück zum ersten Takt (Pos1)"),
    "back_reaction": ("Back to the last reaction (Shift+R)", "Zurück zur letzten Reaktion (⇧R)"),
    "back_block": ("Back by a block (Shift+B)", "Einen Satz zurück (⇧B)"),
    "back_tick": ("Back by a tick (,)", "Einen Takt zurück (,)"),
    "tick": ("Forward by a tick (.)", "Einen Takt weiter (.)"),
    "block": ("To the next block (B)", "Zum nächsten Satz (B)"),
    "reaction": ("To the next reaction (R)", "Zur nächsten Reaktion (R)"),
    "toggle": ("Run and pause (space)", "Laufen und anhalten (Leertaste)"),
    "speed": ("Speed, as a factor of the wall clock", "Tempo, als Faktor der Uhrzeit"),
    "save": ("Save and run again (Ctrl+S)", "Speichern und neu starten (Strg+S)"),
    "findings": ("Findings", "Befunde"),
    "messages": ("Messages", "Meldungen"),
    "events": ("Events", "Ereignisse"),
    "no_findings": ("The check finds nothing.", "Die Prüfung findet nichts."),
    "line": ("line", "Zeile"),
    "scope": ("Scope", "Oszilloskop"),
    "signals": ("Signals", "Signale"),
    "path": ("Path X, Y", "Bahn X, Y"),
    "travel": ("A click travels there", "Ein Klick reist dorthin"),
    "positions": ("Positions", "Positionen"),
    "to_go": ("to go", "Restweg"),
    "feed": ("Path speed", "Bahngeschwindigkeit"),
    "panel": ("Operator's panel", "Bedientafel"),
    "start": ("START", "START"),
    "reset": ("RESET", "RESET"),
    "hold": ("Feed hold", "Vorschub-Halt"),
    "single": ("Single block", "Einzelsatz"),
    "override": ("Override", "Override"),
    "variables": ("V.E variables", "V.E-Variablen"),
    "search": ("Search", "Suchen"),
    "waiting": ("Functions for the PLC", "Funktionen an die SPS"),
    "none_waits": ("None waits.", "Keine wartet."),
    "acknowledge": ("Acknowledge", "Quittieren"),
    "take_pen": ("Take the pen", "Stift nehmen"),
    "no_pen": ("Another browser has the pen.", "Ein anderer Browser hat den Stift."),
    "dark": ("Light or dark", "Hell oder dunkel"),
    "never": ("That has not happened yet.", "Das ist noch nicht vorgekommen."),
    "saved": ("Saved; the program runs again.", "Gespeichert; das Programm läuft neu."),
    "running": ("running", "läuft"),
    "standing": ("paused", "angehalten"),
    "ended": ("ended", "beendet"),
    "true": ("true", "wahr"),
    "false": ("false", "falsch"),
    "unknown": ("not evaluated yet", "noch nicht ausgewertet"),
}


class Texts:
    """The words of the page in one language."""

    def __init__(self, language: Language) -> None:
        self.language = language
        self._index = 1 if language == "de" else 0

    def __getitem__(self, name: str) -> str:
        """Return the word or sentence of this name."""
        return _WORDS[name][self._index]
