# SPDX-License-Identifier: MIT
"""Messages about a PLC in another process: its waits, its requests to the HLI."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

NO_HLI_OF_NAME = error(
    901430,
    en="there is no HLI {name}: nothing has shared it within {seconds} s",
    de="das HLI {name} gibt es nicht: in {seconds} s hat es niemand freigegeben",
    remedy_en="Start nctakt run PROGRAM --hli {name}. Shared at present: {known}",
    remedy_de="nctakt run PROGRAMM --hli {name} starten. Zurzeit freigegeben: {known}",
    seconds=("how long it was waited for", "wie lange darauf gewartet wurde"),
    known=("the images that can be found, or –", "die Abbilder, die sich finden lassen, oder –"),
)
NOT_AN_HLI = error(
    901431,
    en="the shared memory {name} is not an HLI of nctakt",
    de="der gemeinsame Speicher {name} ist kein HLI von nctakt",
    remedy_en="Give the name after nctakt run --hli.",
    remedy_de="Den Namen hinter nctakt run --hli angeben.",
)
HLI_VERSION_DIFFERS = error(
    901432,
    en="the HLI {name} has version {version} of the layout, this nctakt {own}: {differences}",
    de="das HLI {name} hat Version {version} des Aufbaus, dieses nctakt {own}: {differences}",
    remedy_en="Use the same nctakt for the CNC and for the PLC.",
    remedy_de="Für CNC und SPS dasselbe nctakt verwenden.",
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
    version=("the version in its header", "die Version in seinem Kopf"),
    own=("the version that this nctakt knows", "die Version, die dieses nctakt kennt"),
    differences=("what has changed between them", "was sich dazwischen geändert hat"),
)
HLI_LAYOUT_DIFFERS = error(
    901433,
    en="the HLI {name} is laid out differently: {part} does not fit",
    de="das HLI {name} ist anders aufgebaut: {part} passt nicht",
    remedy_en="Use the same nctakt for the CNC and for the PLC.",
    remedy_de="Für CNC und SPS dasselbe nctakt verwenden.",
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
    part=("the structure or value", "die Struktur oder der Wert"),
)
HLI_HAS_PLC = error(
    901434,
    en="the HLI {name} already has a PLC: process {process}",
    de="das HLI {name} hat schon eine SPS: Prozess {process}",
    remedy_en="End that program first: only one PLC answers the CNC.",
    remedy_de="Zuerst jenes Programm beenden: nur eine SPS antwortet der CNC.",
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
    process=("the ID of its process", "die ID ihres Prozesses"),
)
HLI_HAS_NO_NAME = error(
    901435,
    en="the HLI {hli} has no {name}",
    de="das HLI {hli} hat kein {name}",
    remedy_en="Did you mean {nearest}? It has HLI values and V.E variables, each with its index.",
    remedy_de="War {nearest} gemeint? Es hat HLI-Werte und V.E-Variablen, jede mit ihrem Index.",
    hli=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
    nearest=("the nearest name, or –", "der ähnlichste Name, oder –"),
)
HLI_INDEX_OUTSIDE = error(
    901436,
    en="{name} is outside of the array, whose last index is {last}",
    de="{name} liegt außerhalb des Feldes, dessen letzter Index {last} ist",
    remedy_en="Use an index from 0 to {last}.",
    remedy_de="Einen Index von 0 bis {last} verwenden.",
    last=("the last index", "der letzte Index"),
)
UNKNOWN_HLI_SPINDLE = error(
    901437,
    en="unknown spindle {name}",
    de="unbekannte Spindel {name}",
    remedy_en="Did you mean {nearest}? Name one of these: {known}",
    remedy_de="War {nearest} gemeint? Eine von diesen nennen: {known}",
    nearest=("the nearest spindle, or –", "die ähnlichste Spindel, oder –"),
    known=("the spindles of the machine", "die Spindeln der Maschine"),
)
HLI_CNC_WRITES_ON = error(
    901438,
    en="the CNC of the HLI {name} never finishes writing",
    de="die CNC des HLI {name} hört nicht auf zu schreiben",
    remedy_en="It was killed while writing: remove the shared memory and start it again.",
    remedy_de="Sie wurde beim Schreiben beendet: den gemeinsamen Speicher entfernen und sie neu "
    "starten.",
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
)
NO_TICK_AT_HLI = error(
    901439,
    en="the CNC of the HLI {name} has run no tick for {seconds} s",
    de="die CNC des HLI {name} hat seit {seconds} s keinen Takt ausgeführt",
    remedy_en="Let the CNC continue, or wait longer (within_s).",
    remedy_de="Die CNC weiterlaufen lassen oder länger warten (within_s).",
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
    seconds=("how long it was waited for", "wie lange darauf gewartet wurde"),
)
WAITING_FOR_PLC = note(
    901440,
    en="waiting up to {seconds} s for a PLC at the HLI {name}",
    de="es wird bis zu {seconds} s auf eine SPS am HLI {name} gewartet",
    remedy_en='Start it in another shell; in Python it begins with nctakt.hli.attach("{name}").',
    remedy_de="Sie in einer anderen Konsole starten; in Python beginnt sie mit "
    'nctakt.hli.attach("{name}").',
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
    seconds=("how long it is waited for", "wie lange gewartet wird"),
)
PLC_CONNECTED = note(
    901441,
    en="a PLC has connected to the HLI {name}: {process}",
    de="eine SPS hat sich mit dem HLI {name} verbunden: {process}",
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
    process=("its process, if the PLC names it", "ihr Prozess, falls die SPS ihn nennt"),
)
PLC_KEEPS_WAITING = warning(
    901442,
    en="after tick {tick} the CNC is waiting for the PLC, for {seconds} s so far",
    de="nach Takt {tick} wartet die CNC auf die SPS, bisher {seconds} s",
    remedy_en="It has {left} s to write turn of hli_link; a debugger may hold it.",
    remedy_de="Ihr bleiben {left} s, turn in hli_link zu schreiben; vielleicht hält ein Debugger "
    "sie an.",
    tick=("the last tick that was run", "der zuletzt gelaufene Takt"),
    seconds=("how long it has been waited for", "wie lange schon gewartet wird"),
    left=("the time that is left", "die Zeit, die noch bleibt"),
)
PLC_ANSWERED_AGAIN = note(
    901443,
    en="the PLC has answered tick {tick}; the run continues",
    de="die SPS hat Takt {tick} beantwortet; der Lauf geht weiter",
    tick=("the last tick that was run", "der zuletzt gelaufene Takt"),
)
