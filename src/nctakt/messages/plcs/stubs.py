# SPDX-License-Identifier: MIT
"""Messages about blocks of Structured Text that are replaced by classes in Python."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

_BLOCK = ("the function block", "der Funktionsbaustein")
_CLASS = ("the class in Python", "die Klasse in Python")
_FILE = ("the file of the class", "die Datei der Klasse")

STUB_CLASS_MISSING = error(
    902972,
    en="{file} has no class {name} for {block}",
    de="{file} hat keine Klasse {name} für {block}",
    remedy_en="Did you mean {nearest}? Define it at the top level of the file.",
    remedy_de="War {nearest} gemeint? Sie auf der obersten Ebene der Datei definieren.",
    file=_FILE,
    name=_CLASS,
    block=_BLOCK,
    nearest=("the nearest class, or –", "die ähnlichste Klasse, oder –"),
)
STUB_NOT_PYTHON = error(
    902973,
    en="{file} is not Python: {reason}",
    de="{file} ist kein Python: {reason}",
    remedy_en="Correct the file at this line.",
    remedy_de="Die Datei an dieser Zeile berichtigen.",
    file=_FILE,
    reason=("what Python says", "was Python sagt"),
)
STUB_UNDECLARED = error(
    902974,
    en="class {name} does not declare the variables of {block} as a text",
    de="die Klasse {name} deklariert die Variablen von {block} nicht als Text",
    remedy_en="Write them as in Structured Text: "
    'declaration = "VAR_INPUT bExecute : BOOL; END_VAR"',
    remedy_de="Sie wie in Strukturiertem Text schreiben: "
    'declaration = "VAR_INPUT bExecute : BOOL; END_VAR"',
    cause_en="The text is read without running the file, so it must be a literal.",
    cause_de="Der Text wird gelesen, ohne die Datei auszuführen; er muss deshalb ein Literal sein.",
    name=_CLASS,
    block=_BLOCK,
)
STUB_WITHOUT_CYCLE = error(
    902975,
    en="class {name} has no method cycle(self, block, hli)",
    de="die Klasse {name} hat keine Methode cycle(self, block, hli)",
    remedy_en="Define it; it is called after each tick, for each instance of the block.",
    remedy_de="Sie definieren; sie wird nach jedem Takt für jede Instanz des Bausteins aufgerufen.",
    name=_CLASS,
)
STUB_NAME_TAKEN = error(
    902976,
    en="{name} cannot get a stub: {owner} declares it",
    de="{name} kann keinen Ersatz bekommen: {owner} deklariert ihn",
    remedy_en="Remove the entry; to replace the block of a library, name that library: {example}",
    remedy_de="Den Eintrag entfernen; soll er den Baustein einer Bibliothek ersetzen, diese "
    "nennen: {example}",
    name=_BLOCK,
    owner=("the project, or a library", "das Projekt oder eine Bibliothek"),
    example=("an entry with the name of a library", "ein Eintrag mit dem Namen einer Bibliothek"),
)
STUB_SETS_NO_OUTPUT = error(
    902977,
    en="{name} is not an output of {block}",
    de="{name} ist kein Ausgang von {block}",
    remedy_en="A stub sets variables in VAR_OUTPUT only; keep other values in the object itself.",
    remedy_de="Ein Ersatz setzt nur Variablen in VAR_OUTPUT; andere Werte im Objekt selbst halten.",
    name=("the variable", "die Variable"),
    block=_BLOCK,
)
STUB_FAILED = error(
    902978,
    en="the stub of {path} failed after tick {tick}: {reason}\n{traceback}",
    de="der Ersatz von {path} ist nach Takt {tick} gescheitert: {reason}\n{traceback}",
    remedy_en="Correct its class at the last line shown.",
    remedy_de="Seine Klasse an der zuletzt gezeigten Zeile berichtigen.",
    path=("the path of the instance", "der Pfad der Instanz"),
    tick=("the last tick that was run", "der zuletzt gelaufene Takt"),
    reason=("the exception", "die Ausnahme"),
    traceback=(
        "the calls that led there, in the user's files",
        "die Aufrufe bis dorthin, in den Dateien des Anwenders",
    ),
)
STUB_WITHOUT_OBJECT = warning(
    902980,
    en="{path} has no object of {name}: its outputs keep their initial values",
    de="{path} hat kein Objekt von {name}: seine Ausgänge behalten ihre Anfangswerte",
    remedy_en="Declare the instance in a program, a list, or a block that is declared in one.",
    remedy_de="Die Instanz in einem Programm, einer Liste oder einem dort deklarierten Baustein "
    "anlegen.",
    cause_en="Variables of functions and methods, VAR_TEMP, VAR_STAT and VAR_INST have no path.",
    cause_de="Variablen von Funktionen und Methoden, VAR_TEMP, VAR_STAT und VAR_INST haben keinen "
    "Pfad.",
    path=("the variable", "die Variable"),
    name=_CLASS,
)
