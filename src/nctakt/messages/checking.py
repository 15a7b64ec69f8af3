# SPDX-License-Identifier: MIT
"""Messages of ``nctakt check`` about what it is asked to check (900580 … 900599, 900815)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_FILE = {"file": "the path as it was given"}
_FOLDER = {"folder": "the path as it was given"}

_add(
    900580,
    WARNING,
    "{folder} holds nothing that can be checked",
    "{folder} enthält nichts, was geprüft werden kann",
    remedy_en="Programs in folders end with {suffixes}, lists with .lis; name other files one by "
    "one.",
    remedy_de="Programme in Ordnern enden mit {suffixes}, Listen mit .lis; andere Dateien einzeln "
    "nennen.",
    parameters={**_FOLDER, "suffixes": "the suffixes of programs"},
)
_add(
    900581,
    ERROR,
    "{file} is no text",
    "{file} ist kein Text",
    remedy_en="Name NC programs and ASCII lists.",
    remedy_de="NC-Programme und ASCII-Listen nennen.",
    parameters=_FILE,
)
_add(
    900582,
    NOTE,
    "{file} is encrypted and cannot be checked",
    "{file} ist verschlüsselt und kann nicht geprüft werden",
    remedy_en="Check the program that it was made from.",
    remedy_de="Das Programm prüfen, aus dem sie entstanden ist.",
    parameters=_FILE,
)
_add(
    900583,
    NOTE,
    "this list is checked alone, as {meaning_en}",
    "diese Liste wird allein geprüft, als {meaning_de}",
    remedy_en="Check the machine's folder for what several lists say together.",
    remedy_de="Für das, was mehrere Listen zusammen sagen, den Ordner der Maschine prüfen.",
    parameters={"meaning_en": "the kind of list", "meaning_de": "the same in German"},
)
_add(
    900584,
    NOTE,
    "no kind of list that is known has such entries; the list is not checked",
    "keine bekannte Art von Liste hat solche Einträge; die Liste wird nicht geprüft",
    remedy_en="Known are {meaning_en}",
    remedy_de="Bekannt sind {meaning_de}",
    parameters={"meaning_en": "the kinds of lists", "meaning_de": "the same in German"},
)
_add(
    900585,
    NOTE,
    "programs are checked for the demo machine",
    "Programme werden für die Demo-Maschine geprüft",
    remedy_en="--machine {folder} checks them for yours.",
    remedy_de="--machine {folder} prüft sie für die eigene.",
    parameters={"folder": "a machine's folder"},
)
_add(
    900586,
    ERROR,
    "'{text}' selects no message",
    "'{text}' wählt keine Meldung aus",
    remedy_en="Write numbers (22009), beginnings (9002) or ranges (22000-22099), divided by "
    "commas.",
    remedy_de="Nummern (22009), Anfänge (9002) oder Bereiche (22000-22099) mit Kommas schreiben.",
    parameters={"text": "what was given"},
)
_add(
    900815,
    NOTE,
    "programs are checked for the machine of {file}",
    "Programme werden für die Maschine von {file} geprüft",
    remedy_en="--machine DIR checks them for another one.",
    remedy_de="--machine DIR prüft sie für eine andere.",
    parameters={"file": "the start-up list that lies in their folder, or above it"},
)
