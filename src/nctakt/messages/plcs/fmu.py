# SPDX-License-Identifier: MIT
"""Messages about simulation models that are coupled to a run (FMUs)."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning
from nctakt.messages.extras import install_command

FMU_LIBRARY_MISSING = error(
    902600,
    en="an FMU needs the library FMPy, which is not installed",
    de="eine FMU braucht die Bibliothek FMPy, die nicht installiert ist",
    remedy_en=f"Install it: {install_command('fmi')}",
    remedy_de=f"Installieren: {install_command('fmi')}",
)
FMU_NOT_READABLE = error(
    902601,
    en="{file} cannot be read as an FMU: {reason}",
    de="{file} ist nicht als FMU lesbar: {reason}",
    remedy_en="Export the model again; 'fmpy validate {file}' names all faults.",
    remedy_de="Das Modell erneut exportieren; 'fmpy validate {file}' nennt alle Fehler.",
)
FMU_PATH_OUTSIDE = error(
    902602,
    en="{file} has an entry {path}, which would be written outside of its folder",
    de="{file} hat einen Eintrag {path}, der außerhalb seines Ordners geschrieben würde",
    remedy_en="Do not use it: no modelling tool writes such an FMU.",
    remedy_de="Sie nicht verwenden: kein Modellierungswerkzeug schreibt eine solche FMU.",
)
FMU_KIND_NOT_POSSIBLE = error(
    902603,
    en="{file} is an FMU for {kind}; nctakt runs FMI 2.0 and 3.0 for co-simulation",
    de="{file} ist eine FMU für {kind}; nctakt führt FMI 2.0 und 3.0 für Co-Simulation aus",
    remedy_en="Export the model for co-simulation.",
    remedy_de="Das Modell für Co-Simulation exportieren.",
    kind=("version and interfaces", "Version und Schnittstellen"),
)
FMU_WITHOUT_BINARY = error(
    902604,
    en="{file} has no library for {platform}; it has: {platforms}",
    de="{file} hat keine Bibliothek für {platform}; es gibt: {platforms}",
    remedy_en="Export the model for this platform.",
    remedy_de="Das Modell für diese Plattform exportieren.",
    platform=("this platform", "diese Plattform"),
    platforms=("the platforms that it has", "die vorhandenen Plattformen"),
)
UNKNOWN_FMU_VARIABLE = error(
    902605,
    en="{file} has no variable {name}",
    de="{file} hat keine Variable {name}",
    remedy_en="Did you mean {nearest}? 'fmpy info {file}' lists all.",
    remedy_de="War {nearest} gemeint? 'fmpy info {file}' zeigt alle.",
)
FMU_VARIABLE_NOT_POSSIBLE = error(
    902606,
    en="{file}: {name} is {found}, and not {expected}",
    de="{file}: {name} ist {found} und nicht {expected}",
    remedy_en="Connect another variable, or put it into the other table of [fmu].",
    remedy_de="Eine andere Variable verbinden oder sie in die andere Tabelle von [fmu] setzen.",
    found=("what the variable is", "was die Variable ist"),
)
FMU_UNITS_DIFFER = error(
    902607,
    en="{file}: {name} is in {unit}, {signal} in {own}: one cannot be converted into the other",
    de="{file}: {name} ist in {unit}, {signal} in {own}: das ist nicht umrechenbar",
    remedy_en="Connect another variable, or correct the unit in the model.",
    remedy_de="Eine andere Variable verbinden oder die Einheit im Modell berichtigen.",
    unit=("the unit of the FMU", "die Einheit der FMU"),
    signal=("nctakt's variable", "die Variable von nctakt"),
    own=("its unit", "ihre Einheit"),
)
FMU_NOT_CONNECTED = error(
    902608,
    en="no variable of {file} is connected; inputs: {inputs}; outputs: {outputs}",
    de="keine Variable von {file} ist verbunden; Eingänge: {inputs}; Ausgänge: {outputs}",
    remedy_en="Name pairs in the tables [fmu.inputs] and [fmu.outputs] of nctakt.toml: docs/fmi.md",
    remedy_de="Paare in den Tabellen [fmu.inputs] und [fmu.outputs] von nctakt.toml nennen: "
    "docs/fmi.md",
    inputs=("the inputs of the FMU", "die Eingänge der FMU"),
    outputs=("its outputs", "ihre Ausgänge"),
)
FMU_FAILED = error(
    902609,
    en="{file}: {function} failed at {time} of the run: {reason}",
    de="{file}: {function} ist bei {time} des Laufs gescheitert: {reason}",
    remedy_en="Correct the model, or the values that it gets; the text comes from the model.",
    remedy_de="Das Modell oder die Werte berichtigen, die es erhält; der Text ist der des Modells.",
    function=("the function of FMI", "die Funktion von FMI"),
    time=("the time", "die Zeit"),
    reason=("the status and the last lines of its log", "der Status und die letzten Logzeilen"),
)
FMU_ENDED = error(
    902610,
    en="{file} asks to end the simulation at {time} of the run",
    de="{file} verlangt, die Simulation bei {time} des Laufs zu beenden",
    remedy_en="Limit the run (--until {time}), or correct the model.",
    remedy_de="Den Lauf begrenzen (--until {time}) oder das Modell berichtigen.",
    time=("the time", "die Zeit"),
)
FMU_STEP_NOT_POSSIBLE = error(
    902611,
    en="{file} cannot be called every {every}: this must be a multiple of {step}",
    de="{file} kann nicht alle {every} aufgerufen werden: es muss ein Vielfaches von {step} sein",
    remedy_en='Set it in nctakt.toml: [fmu], every = "10 ms"',
    remedy_de='In nctakt.toml einstellen: [fmu], every = "10 ms"',
    every=("the communication step", "die Kommunikationsschrittweite"),
    step=("a tick, or the internal step of the FMU", "ein Takt oder der interne Schritt der FMU"),
)
FMU_VALUE_REFUSED = error(
    902612,
    en="{file}: at {time} of the run {value} of {origin} is not a valid value for {target}",
    de="{file}: bei {time} des Laufs ist {value} von {origin} kein gültiger Wert für {target}",
    remedy_en="Limit the value where it comes from, or connect another variable.",
    remedy_de="Den Wert begrenzen, wo er entsteht, oder eine andere Variable verbinden.",
    origin=("the variable that has the value", "die Variable, die den Wert hat"),
    target=("the variable that cannot have it", "die Variable, die ihn nicht annehmen kann"),
    time=("the time", "die Zeit"),
)
CELL_NOT_COMPLETE = error(
    902615,
    en="the FMU would not start with only the files that it contains",
    de="die FMU würde mit ihren Dateien allein nicht starten",
    remedy_en="Name files in lists and programs relative to the machine's folder, and keep them "
    "inside it.",
    remedy_de="Dateien in Listen und Programmen relativ zum Maschinenordner nennen und darin "
    "ablegen.",
)
CELL_STEP_NOT_POSSIBLE = error(
    902616,
    en="a communication step of {step} is not a whole number of ticks of {tick}",
    de="eine Kommunikationsschrittweite von {step} ist keine ganze Zahl von Takten von {tick}",
    remedy_en="Set the step of the importing tool to a multiple of the tick.",
    remedy_de="Die Schrittweite des importierenden Werkzeugs auf ein Vielfaches des Takts setzen.",
    step=("the communication step", "die Kommunikationsschrittweite"),
    tick=("the length of a tick", "die Länge eines Takts"),
)
NOT_AN_INPUT = error(
    902617,
    en="{name} cannot be an input of the FMU",
    de="{name} kann kein Eingang der FMU sein",
    remedy_en="Inputs are V.E variables, and operator's values such as HLI.OVERRIDE.",
    remedy_de="Eingänge sind V.E-Variablen und Werte des Bedieners wie HLI.OVERRIDE.",
)
CELL_NAME_NOT_POSSIBLE = error(
    902618,
    en="{file} cannot be the file of an FMU",
    de="{file} kann nicht die Datei einer FMU sein",
    remedy_en="Name it like a variable, with the ending .fmu: cell.fmu",
    remedy_de="Sie wie eine Variable nennen, mit der Endung .fmu: zelle.fmu",
)
FMU_CRASHED = error(
    902731,
    en="{file} has ended its process at {time} of the run, {call}: {reason}",
    de="{file} hat seinen Prozess bei {time} des Laufs beendet, {call}: {reason}",
    remedy_en="Correct the model; its error output is shown above.",
    remedy_de="Das Modell berichtigen; seine Fehlerausgabe steht oben.",
    time=("the time", "die Zeit"),
    call=("what was asked of it", "was von ihm verlangt war"),
    reason=("the signal or the exit code", "das Signal oder der Rückgabewert"),
)
FMU_HANGS = error(
    902732,
    en="{file} has not returned for {limit} at {time} of the run, {call}; its process was ended",
    de="{file} kehrt bei {time} des Laufs seit {limit} nicht zurück, {call}; sein Prozess wurde "
    "beendet",
    remedy_en='Correct the model, or give it more time in nctakt.toml: [fmu], limit = "60 s"',
    remedy_de='Das Modell berichtigen oder ihm mehr Zeit geben: [fmu], limit = "60 s"',
    limit=("how long a call may last", "wie lange ein Aufruf dauern darf"),
    time=("the time", "die Zeit"),
    call=("what was asked of it", "was von ihm verlangt war"),
)
FMU_REFERENCE_SHARED = error(
    902950,
    en="{file}: {name} and {other} share the value reference {reference}: {reason}",
    de="{file}: {name} und {other} haben beide die Wertreferenz {reference}: {reason}",
    remedy_en="Export the model again; 'fmpy validate {file}' names all faults.",
    remedy_de="Das Modell erneut exportieren; 'fmpy validate {file}' nennt alle Fehler.",
    other=("the variable that has the same reference", "die Variable mit derselben Referenz"),
    reference=("the value reference", "die Wertreferenz"),
)
FMU_START_REFUSED = error(
    902951,
    en="{file}: {name} cannot begin with {value}: it is {expected}",
    de="{file}: {name} kann nicht mit {value} beginnen: es ist {expected}",
    remedy_en="Correct the value, or remove it: then {name} begins as the model says.",
    remedy_de="Den Wert berichtigen oder entfernen: dann beginnt {name}, wie das Modell es angibt.",
)
FMU_NOT_INSTANTIATED = error(
    902952,
    en="{file} refuses to begin with the token {token} of its description: {reason}",
    de="{file} lehnt es ab, mit dem Token {token} seiner Beschreibung zu beginnen: {reason}",
    remedy_en="Export the model again: its description and library do not seem to match.",
    remedy_de="Das Modell erneut exportieren: Beschreibung und Bibliothek passen wohl nicht "
    "zusammen.",
    token=("its GUID or instantiation token", "seine GUID oder sein Instantiation Token"),
    reason=("the last lines of its log", "die letzten Zeilen seines Logs"),
)
FMU_LATE = warning(
    902733,
    en="{file} has not returned from {function} for {limit}, at {time} of the run",
    de="{file} kehrt seit {limit} nicht aus {function} zurück, bei {time} des Laufs",
    remedy_en='End nctakt and run again with --isolate, or give it more time: [fmu], limit = "60 '
    's"',
    remedy_de="nctakt beenden und mit --isolate neu starten, oder mehr Zeit geben: [fmu], limit = "
    '"60 s"',
    function=("the function of FMI", "die Funktion von FMI"),
    limit=("how long a call may last", "wie lange ein Aufruf dauern darf"),
    time=("the time", "die Zeit"),
)
NOTHING_TO_ISOLATE = error(
    902734,
    en="--isolate needs an FMU, but none is named",
    de="--isolate braucht eine FMU, aber keine ist angegeben",
    remedy_en="Name one: --fmu plant.fmu",
    remedy_de="Eine nennen: --fmu anlage.fmu",
)
CELL_INPUTS_NOT_KEPT = error(
    902840,
    en="the inputs of the FMU, which its states need, cannot be kept: {reason}",
    de="die Eingänge der FMU, die ihre Zustände brauchen, lassen sich nicht aufheben: {reason}",
    remedy_en="Make room in the folder for temporary files, or name another folder: "
    "TMPDIR=/var/tmp",
    remedy_de="Im Ordner für temporäre Dateien Platz schaffen, oder einen anderen: TMPDIR=/var/tmp",
)
CELL_STATE_UNREADABLE = error(
    902841,
    en="these bytes are not a state of an FMU of nctakt: {reason}",
    de="diese Bytes sind kein Zustand einer FMU von nctakt: {reason}",
    remedy_en="Keep the bytes unchanged, as the FMU has given them.",
    remedy_de="Die Bytes unverändert aufheben, wie die FMU sie ausgegeben hat.",
)
CELL_STATE_OF_ANOTHER = error(
    902842,
    en="the state belongs to another FMU: other programs, lists, inputs, outputs or options",
    de="der Zustand gehört zu einer anderen FMU: andere Programme, Listen, Variablen oder Optionen",
    remedy_en="Restore states only in the FMU that they come from.",
    remedy_de="Zustände nur in die FMU zurücksetzen, aus der sie stammen.",
)
CELL_DOES_OTHERWISE = error(
    902843,
    en="when run again, the FMU is not in the state that it had after {ticks} ticks (PLC: {plc})",
    de="beim erneuten Ausführen hat die FMU nicht den Zustand wie nach {ticks} Takten (SPS: {plc})",
    remedy_en="Keep the PLC's state in its object; do not use clocks, files, random numbers or "
    "other modules.",
    remedy_de="Den Zustand der SPS in ihrem Objekt halten; keine Uhren, Dateien, Zufallszahlen, "
    "anderen Module.",
    plc=("the PLC's file, - without", "die Datei der SPS, - ohne"),
)
