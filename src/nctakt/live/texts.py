# SPDX-License-Identifier: MIT
"""The words of the live page, in English and German."""

from __future__ import annotations

from nctakt.base.diagnostics import Language

WORDS: dict[str, tuple[str, str]] = {
    # The bar.
    "tick_number": ("Tick", "Takt"),
    "before_first": ("before tick 0", "vor Takt 0"),
    "branch": ("Branch", "Zweig"),
    "running": ("running", "läuft"),
    "standing": ("paused", "angehalten"),
    "ended": ("ended", "beendet"),
    "working": ("searching …", "sucht …"),
    "home": ("Back to the first tick", "Zurück zum ersten Takt"),
    "front": ("To the latest tick", "Zum neuesten Takt"),
    "back_reaction": ("Back to the last reaction", "Zurück zur letzten Reaktion"),
    "back_block": ("Back by a block", "Einen Satz zurück"),
    "back_tick": ("Back by a tick", "Einen Takt zurück"),
    "back_stop": ("Back to where a stop held last", "Zurück zum letzten Haltepunkt"),
    "tick": ("Forward by a tick", "Einen Takt weiter"),
    "block": ("To the next block", "Zum nächsten Satz"),
    "reaction": ("To the next reaction", "Zur nächsten Reaktion"),
    "toggle": ("Run and pause", "Laufen und anhalten"),
    "speed": ("Speed, as a factor of the wall clock", "Tempo, als Faktor der Uhrzeit"),
    "faster": ("Faster", "Schneller"),
    "slower": ("Slower", "Langsamer"),
    "late": ("late slices: {count}", "verspätete Zeitscheiben: {count}"),
    "in_control": ("This browser has control", "Dieser Browser hat die Bedienung"),
    "take_control": ("Take control", "Bedienung übernehmen"),
    "not_in_control": ("Another browser has control.", "Ein anderer Browser hat die Bedienung."),
    "too_fast": (
        "Too many commands at once: some were not carried out.",
        "Zu viele Befehle auf einmal: einige wurden nicht ausgeführt.",
    ),
    "dark": ("Light or dark", "Hell oder dunkel"),
    "help": ("Keys", "Tasten"),
    "close": ("Close", "Schließen"),
    # The program.
    "channel": ("Channel", "Kanal"),
    "edited": ("not saved", "nicht gespeichert"),
    "save": ("Save and run again", "Speichern und neu starten"),
    "save_short": ("Save and run", "Speichern, Neustart"),
    "saved": ("Saved; the program runs again.", "Gespeichert; das Programm läuft neu."),
    "on_disk": ("changed on disk", "auf der Platte geändert"),
    "gone": ("gone from disk", "nicht mehr auf der Platte"),
    "plc_on_disk": ("PLC changed on disk", "SPS auf der Platte geändert"),
    "load": ("Load it", "Neu laden"),
    "long": ("{count} lines, not edited here", "{count} Zeilen, hier nicht geändert"),
    "find": (
        "Go to a line, or to the next one with a text",
        "Zu einer Zeile oder der nächsten mit einem Text",
    ),
    "find_short": ("line or text", "Zeile oder Text"),
    "not_found": ("No line has {request}", "Keine Zeile hat {request}"),
    "uncopied": ("Only lines in view can be copied", "Nur sichtbare Zeilen lassen sich kopieren"),
    "explain": ("Explain the word at the cursor", "Das Wort am Cursor erklären"),
    "finding": ("To the next finding, or the one before", "Zum nächsten Befund oder zum vorigen"),
    "complete": ("Complete what is written", "Geschriebenes vervollständigen"),
    "nothing_known": ("Nothing is known of this word", "Zu diesem Wort ist nichts bekannt"),
    "edit": ("To the editor", "Zum Editor"),
    "leave": ("Leave the field or the editor", "Feld oder Editor verlassen"),
    "toggle_stop": (
        "Set or remove a stop in this line",
        "Haltepunkt in dieser Zeile setzen oder löschen",
    ),
    # The PLC.
    "plc_file": ("PLC:", "SPS:"),
    "plc_into": ("Step into the call", "In den Aufruf hinein"),
    "plc_over": ("To the next statement", "Zur nächsten Anweisung"),
    "plc_out": ("Out of the call", "Aus dem Aufruf heraus"),
    "plc_back_into": ("Back into the call", "Zurück, in den Aufruf hinein"),
    "plc_back_over": ("Back to the last statement", "Zurück zur letzten Anweisung"),
    "plc_back_out": ("Back out of the call", "Zurück, aus dem Aufruf heraus"),
    "plc_next_file": ("Program, or the next file of the PLC", "Programm oder nächste SPS-Datei"),
    "condition": ("Stop with a condition", "Haltepunkt mit Bedingung"),
    "plc_calls": ("Open calls", "Offene Aufrufe"),
    "plc_instance": ("Instance whose values are shown", "Instanz, deren Werte gezeigt werden"),
    "plc_edit": ("Change the text, or show its lines", "Den Text ändern oder seine Zeilen zeigen"),
    "plc_edited": ("Text of the PLC", "Text der SPS"),
    "plc_not_edited": (
        "This text cannot be changed here: its file has changed on disk, or is written otherwise.",
        "Dieser Text lässt sich hier nicht ändern: seine Datei ist auf der Platte geändert oder "
        "anders geschrieben.",
    ),
    "plc_tree": ("What the line names", "Was die Zeile nennt"),
    "plc_standing": (
        "in tick {tick}, before the marked line",
        "in Takt {tick}, vor der markierten Zeile",
    ),
    "plc_no_statement": (
        "No statement of the PLC begins here or below.",
        "Hier und darunter beginnt keine Anweisung der SPS.",
    ),
    "plc_wrote_nothing": (
        "The statement in this line has written nothing yet that the record explains: neither the "
        "interface nor a V.E variable.",
        "Die Anweisung dieser Zeile hat noch nichts geschrieben, was die Aufzeichnung erklärt: "
        "weder die Schnittstelle noch eine V.E-Variable.",
    ),
    "plc_none_after": ("No statement of the PLC follows.", "Es folgt keine Anweisung der SPS."),
    "plc_none_before": (
        "No statement of the PLC comes before.",
        "Davor ist keine Anweisung der SPS.",
    ),
    # Lists.
    "lists": (
        "Findings, messages, events, why, stops, branches",
        "Befunde, Meldungen, Ereignisse, Warum, Haltepunkte, Zweige",
    ),
    "findings": ("Findings", "Befunde"),
    "messages": ("Messages", "Meldungen"),
    "events": ("Events", "Ereignisse"),
    "why": ("Why", "Warum"),
    "stops": ("Stops", "Haltepunkte"),
    "branches": ("Branches", "Zweige"),
    "time": ("Time", "Zeit"),
    "times": (
        "Where the {latest} ticks of this branch went",
        "Wo die {latest} Takte dieses Zweigs blieben",
    ),
    "times_so_far": (
        "Where {tick} of {latest} ticks of this branch went, so far …",
        "Wo {tick} von {latest} Takten dieses Zweigs blieben, bisher …",
    ),
    "branch_name": ("Name", "Name"),
    "branch_origin": ("leaves {branch} at tick {tick}", "verlässt {branch} in Takt {tick}"),
    "branch_end": ("up to tick {tick}", "bis Takt {tick}"),
    "take_up": ("Go on with it", "Hier weitermachen"),
    "compare": ("Compare with the branch shown", "Mit dem gezeigten Zweig vergleichen"),
    "difference": (
        "Branches {one} and {other} are the same before tick {fork}. Signals differ first in tick "
        "{tick}:",
        "Die Zweige {one} und {other} sind vor Takt {fork} gleich. Signale unterscheiden sich "
        "zuerst in Takt {tick}:",
    ),
    "no_difference": (
        "Branches {one} and {other}: no signal differs up to tick {end}, which both have reached.",
        "Zweige {one} und {other}: kein Signal ist verschieden bis Takt {end}, den beide erreicht "
        "haben.",
    ),
    "more_signals": ("and {count} more", "und {count} weitere"),
    "no_findings": ("The check finds nothing.", "Die Prüfung findet nichts."),
    "no_messages": ("No messages.", "Keine Meldungen."),
    "no_events": ("No events.", "Keine Ereignisse."),
    "begins": ("events before tick {tick} left out", "Ereignisse vor Takt {tick} ausgelassen"),
    "left_out": ("{count} older ones left out", "{count} ältere ausgelassen"),
    "older_left_out": ("older ones left out", "ältere ausgelassen"),
    "further": ("{count} further ones", "{count} weitere"),
    "ask_why": (
        "Click the mark beside a condition (or press F8 in its line) to see why it is so.",
        "Auf den Text neben einer Bedingung klicken (oder F8 in ihrer Zeile): hier steht, warum.",
    ),
    "explaining": (
        "The run so far is worked out again …",
        "Der bisherige Lauf wird nachgerechnet …",
    ),
    "not_run": ("No tick has run yet.", "Noch kein Takt ist gelaufen."),
    "history": ("So far:", "Bisher:"),
    "new_stop": (
        "line 12 · fires 6 · V.E.COUNT > 3 · changes V.E.X · M100 · error",
        "line 12 · fires 6 · V.E.COUNT > 3 · changes V.E.X · M100 · error",
    ),
    "add": ("Add", "Hinzufügen"),
    "remove": ("Remove", "Entfernen"),
    "stopped": ("Stopped: {stops}", "Angehalten: {stops}"),
    "no_stops": (
        "A click on a line number sets a stop, too.",
        "Ein Klick auf eine Zeilennummer setzt auch einen.",
    ),
    "never": ("That has not happened yet.", "Das ist noch nicht vorgekommen."),
    "line": ("line", "Zeile"),
    # Charts.
    "scope_name": (
        "Curves over time; arrow keys zoom and scroll, full stop and comma go by a tick",
        "Kurven über der Zeit; Pfeile zoomen und schieben, Punkt und Komma gehen um einen Takt",
    ),
    "path_name": (
        "Path of the tool; its positions are in the list of positions",
        "Bahn des Werkzeugs; seine Positionen stehen in der Liste der Positionen",
    ),
    "scope": ("Scope", "Oszilloskop"),
    "signals": ("Signals", "Signale"),
    "save_run": ("Save the run of this branch", "Den Lauf dieses Zweigs speichern"),
    "save_svg": ("Picture (SVG)", "Bild (SVG)"),
    "save_png": ("Picture (PNG)", "Bild (PNG)"),
    "save_html": ("Picture to explore (HTML)", "Bild zum Erkunden (HTML)"),
    "save_csv": ("Trace (CSV)", "Aufzeichnung (CSV)"),
    "save_parquet": ("Trace (Parquet)", "Aufzeichnung (Parquet)"),
    "save_vcd": ("For GTKWave (VCD)", "Für GTKWave (VCD)"),
    "save_json": ("For Perfetto (JSON)", "Für Perfetto (JSON)"),
    "save_tape": ("Tape for nctakt replay", "Band für nctakt replay"),
    "saving": ("The run is made once more for the file …", "Für die Datei läuft es noch einmal …"),
    "path": ("Path", "Bahn"),
    "travel": ("Click to go there", "Ein Klick springt dorthin"),
    "zoom_in": ("Larger", "Größer"),
    "zoom_out": ("Smaller", "Kleiner"),
    "scope_fit": ("Show all", "Alles zeigen"),
    "scope_left": ("Scroll the scope back", "Oszilloskop zurückschieben"),
    "scope_right": ("Scroll the scope forward", "Oszilloskop weiterschieben"),
    "lanes_up": ("The conditions before, in the scope", "Vorherige Bedingungen im Oszilloskop"),
    "lanes_down": ("Further conditions in the scope", "Weitere Bedingungen im Oszilloskop"),
    "filter_lanes": (
        'Filter the conditions: 12, 12-20 (lines), #3 (cycle), a text, "12" (a text)',
        'Bedingungen filtern: 12, 12-20 (Zeilen), #3 (Zyklus), ein Text, "12" (ein Text)',
    ),
    "filter_short": ("Conditions", "Bedingungen"),
    "scope_mark": (
        "Compare with this tick (Shift and a click, Shift and drag in the scope)",
        "Mit diesem Takt vergleichen (Umschalt und Klick oder Ziehen im Oszilloskop)",
    ),
    "scope_in": ("Zoom the scope in", "Oszilloskop vergrößern"),
    "scope_out": ("Zoom the scope out", "Oszilloskop verkleinern"),
    "turn_view": ("Another view of the path", "Andere Ansicht der Bahn"),
    "machine_axes": ("Axes, not the tool's tip", "Achsen statt Werkzeugspitze"),
    "machine_axes_short": ("axes", "Achsen"),
    "view_space": ("In space", "Räumlich"),
    "view_top": ("From above", "Von oben"),
    "view_front": ("From the front", "Von vorn"),
    "view_side": ("From the side", "Von der Seite"),
    "future_line": ("to come", "kommt noch"),
    "future_over": ("", ""),
    "future_error": ("ends with error {causes}", "endet mit Fehler {causes}"),
    "future_wait": ("then waits for {causes}", "wartet dann auf {causes}"),
    "future_later": ("continues after that", "geht danach weiter"),
    "future_unknown": (
        "What comes is not known: it depends on a PLC or a model outside.",
        "Was kommt, ist nicht bekannt: Es hängt von einer SPS oder einem Modell außerhalb ab.",
    ),
    "feed_line": ("feed", "Vorschub"),
    "rapid_line": ("rapid", "Eilgang"),
    "fired_mark": ("reaction", "Reaktion"),
    # The right side.
    "positions": ("Positions", "Positionen"),
    "to_go": ("to go", "Restweg"),
    "feed": ("Path speed", "Bahngeschwindigkeit"),
    "panel": ("Operator's panel", "Bedientafel"),
    "program": ("Program", "Programm"),
    "all_programs": ("all, in their order", "alle der Reihe nach"),
    "start": ("START", "START"),
    "reset": ("RESET", "RESET"),
    "hold": ("Feed hold", "Vorschubhalt"),
    "single": ("Single block", "Einzelsatz"),
    "backward": ("Backward", "Rückwärts"),
    "no_history": (
        "The machine keeps no history of the path (P-STUP-00033 is 0).",
        "Die Maschine speichert keine Historie der Bahn (P-STUP-00033 ist 0).",
    ),
    "override": ("Override", "Override"),
    "override_up": ("Override up by 5 %", "Override 5 % höher"),
    "override_down": ("Override down by 5 %", "Override 5 % tiefer"),
    "armed": ("waits for START", "wartet auf START"),
    "waits": ("waits for", "wartet auf"),
    "machine_error": ("error", "Fehler"),
    "variables": ("V.E variables", "V.E-Variablen"),
    "search": ("Search", "Suchen"),
    "search_events": (
        "Search all events of the branch, and signals",
        "Alle Ereignisse des Zweigs und Signale durchsuchen",
    ),
    "previous_match": ("To the previous match", "Zum vorigen Treffer"),
    "next_match": ("To the next match", "Zum nächsten Treffer"),
    "older_matches": ("List older matches", "Ältere Treffer listen"),
    "newer_matches": ("List newer matches", "Neuere Treffer listen"),
    "matches": ("matches: {count}", "Treffer: {count}"),
    "matches_newest": (
        "matches listed: {count}, from tick {tick} on",
        "gelistete Treffer: {count}, ab Takt {tick}",
    ),
    "matches_so_far": (
        "matches so far: {count}; searched back to tick {tick} …",
        "Treffer bisher: {count}; durchsucht zurück bis Takt {tick} …",
    ),
    "found": ("Found: {count}", "Gefunden: {count}"),
    "none_found": ("No event contains this.", "Kein Ereignis enthält das."),
    "no_earlier_match": ("No match before this tick.", "Kein Treffer vor diesem Takt."),
    "no_later_match": ("No match after this tick.", "Kein Treffer nach diesem Takt."),
    "match_in_tick": ("Match in tick {tick}.", "Treffer in Takt {tick}."),
    "to_scope": ("Show in the scope", "Im Oszilloskop zeigen"),
    "search_variable": ("Search a V.E variable", "V.E-Variable suchen"),
    "no_variable": ("No variable has that name.", "Keine Variable heißt so."),
    "no_variables": ("This channel has no V.E variables.", "Dieser Kanal hat keine V.E-Variablen."),
    "more_variables": ("{count} more: search", "{count} weitere: suchen"),
    "next_tick": ("Acts from the next tick on.", "Wirkt ab dem nächsten Takt."),
    "waiting": ("Functions for the PLC", "Funktionen an die SPS"),
    "acknowledging": ("Who acknowledges functions", "Wer Funktionen quittiert"),
    "none_waits": ("None waits.", "Keine wartet."),
    "acknowledge": ("Acknowledge", "Quittieren"),
    "by_cnc": ("at once", "sofort"),
    "by_hand": ("by hand", "von Hand"),
    "automatic": ("automatic", "automatisch"),
    "delay": ("ticks", "Takte"),
    "logged": ("log", "Aufz."),
    "delay_help": (
        "Ticks from its appearance to its acknowledgement",
        "Takte vom Erscheinen bis zur Quittung",
    ),
    # Conditions.
    "true": ("true", "wahr"),
    "ran": ("ran", "lief"),
    "false": ("false", "falsch"),
    "unknown": ("not evaluated yet", "noch nicht ausgewertet"),
    "no_result": ("no result", "ohne Ergebnis"),
    "in_tick": ("in tick {tick}", "in Takt {tick}"),
    "now": ("now", "jetzt"),
    "undefined": ("not defined", "nicht definiert"),
    "earlier_answer": (
        "Of an earlier moment; click again for the tick that is shown.",
        "Von einem anderen Zeitpunkt; für den gezeigten Takt noch einmal klicken.",
    ),
    # The tour of the demo cell.
    "tour": ("Guided tour", "Rundgang"),
    "tour_next": ("Next", "Weiter"),
    "tour_back": ("Back", "Zurück"),
    "tour_again": ("Begin again", "Von vorn"),
    "tour_end": ("End the tour", "Rundgang beenden"),
    "tour_lost": (
        "This is not the run of the tour: a value or the program was changed.",
        "Dieser Lauf ist nicht der des Rundgangs: Jemand hat einen Wert oder das Programm "
        "geändert.",
    ),
    "tour_cell_title": ("A cell", "Eine Zelle"),
    "tour_cell": (
        "Channel 1 mills a part with five axes and a spindle. Then a gate opens, and the loader of "
        "channel 2 brings the next part. A PLC moves the gate. Next (Enter): it runs.",
        "Kanal 1 fräst ein Teil mit fünf Achsen und einer Spindel. Dann öffnet ein Tor, und der "
        "Lader in Kanal 2 bringt das nächste Teil. Eine SPS bewegt das Tor. Weiter (Eingabe): es "
        "läuft.",
    ),
    "tour_run_title": ("It runs", "Sie läuft"),
    "tour_run": (
        "Once the tool is up, the realtime cycle above N10 asks the PLC to open the gate (M100). "
        "Go on when nothing moves any more.",
        "Sobald das Werkzeug oben ist, fordert der Echtzeit-Zyklus über N10 die SPS auf, das Tor "
        "zu öffnen (M100). Weiter, wenn sich nichts mehr bewegt.",
    ),
    "tour_still_title": ("It stops", "Sie steht"),
    "tour_still": (
        "The mill waits for M8, which the PLC acknowledges once the gate is open: it is listed on "
        "the right. The loader waits for the mill. Why did the gate not open?",
        "Die Fräse wartet auf M8, das die SPS quittiert, sobald das Tor offen ist: Es steht "
        "rechts in der Liste. Der Lader wartet auf die Fräse. Warum ging das Tor nicht auf?",
    ),
    "tour_why_title": ("Why?", "Warum?"),
    "tour_why": (
        "The list below answers for line {line}: the condition was evaluated once, in tick {tick}, "
        "and compared 0 == 1. Someone was at the gate then, and it is not evaluated again.",
        "Die Liste unten antwortet für Zeile {line}: Die Bedingung wurde einmal ausgewertet, in "
        "Takt {tick}, und verglich 0 == 1. In diesem Takt war jemand am Tor, und sie wird nicht "
        "noch einmal ausgewertet.",
    ),
    "tour_past_title": ("Back in time", "Zurück in der Zeit"),
    "tour_past": (
        "This is tick {tick}: program, positions, scope and path show it as it was. "
        "V.E.AREA_FREE is off, on the right and in the scope. What if the area had been free?",
        "Das ist Takt {tick}: Programm, Positionen, Oszilloskop und Bahn zeigen ihn, wie er war. "
        "V.E.AREA_FREE ist aus, rechts und im Oszilloskop. Und wenn der Bereich frei gewesen wäre?",
    ),
    "tour_change_title": ("Another past", "Eine andere Vergangenheit"),
    "tour_change": (
        "V.E.AREA_FREE is now 1 in tick {tick}, and a second branch runs from there: the gate "
        "opens, the loader comes. The first one is still there: compare the two in the list below.",
        "V.E.AREA_FREE ist jetzt 1 in Takt {tick}, und von dort läuft ein zweiter Zweig: Das Tor "
        "öffnet, der Lader kommt. Den ersten gibt es noch: In der Liste unten lassen sich beide "
        "vergleichen.",
    ),
    # Headings of the help, and lists.
    "keys_run": ("Run", "Lauf"),
    "keys_panel": ("Operator's panel", "Bedientafel"),
    "keys_program": ("Program", "Programm"),
    "keys_plc": ("PLC", "SPS"),
    "keys_view": ("View", "Ansicht"),
    "tab_findings": ("Findings", "Befunde"),
    "tab_messages": ("Messages", "Meldungen"),
    "tab_events": ("Events", "Ereignisse"),
    "tab_why": ("Why", "Warum"),
    "tab_stops": ("Stops", "Haltepunkte"),
    "tab_branches": ("Branches", "Zweige"),
    "tab_time": ("Time", "Zeit"),
    "too_many": (
        "503: too many browsers look at this page already ({count}). Close one of them.",
        "503: zu viele Browser zeigen diese Seite schon ({count}). Einen davon schließen.",
    ),
}


#: The texts of the library's editor, in German.
EDITOR_PHRASES = {
    "Control character": "Steuerzeichen",
    "Selection deleted": "Auswahl gelöscht",
    "Folded lines": "Eingeklappte Zeilen",
    "Unfolded lines": "Ausgeklappte Zeilen",
    "to": "bis",
    "folded code": "eingeklappter Text",
    "unfold": "ausklappen",
    "Fold line": "Zeile einklappen",
    "Unfold line": "Zeile ausklappen",
    "Go to line": "Zu Zeile",
    "go": "gehen",
    "Find": "Suchen",
    "Replace": "Ersetzen",
    "next": "weiter",
    "previous": "zurück",
    "all": "alle",
    "match case": "Groß/klein",
    "by word": "ganze Wörter",
    "replace": "ersetzen",
    "replace all": "alle ersetzen",
    "close": "schließen",
    "current match": "dieser Treffer",
    "replaced $ matches": "$ Treffer ersetzt",
    "replaced match on line $": "Treffer in Zeile $ ersetzt",
    "on line": "in Zeile",
    "Completions": "Vorschläge",
}


class Texts:
    """The words of the page in one language."""

    def __init__(self, language: Language) -> None:
        self.language = language
        self._index = 1 if language == "de" else 0

    def __getitem__(self, name: str) -> str:
        """Return the word or sentence of this name."""
        return WORDS[name][self._index]
