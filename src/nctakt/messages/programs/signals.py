# SPDX-License-Identifier: MIT
"""Messages about signals between channels, and about programs that wait for each other."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

SIGNAL_FORM = error(
    20998,
    en="{command} must be followed by SYN or brackets, not {found}",
    de="hinter {command} müssen SYN oder Klammern stehen; hier steht {found}",
    remedy_en="Possible forms: {forms}",
    remedy_de="Mögliche Formen: {forms}",
    forms=("the forms of the command", "die Formen des Befehls"),
)
SIGNAL_NUMBER_TWICE = error(
    21056,
    en="{keyword} appears twice in {command}",
    de="{keyword} steht zweimal in {command}",
    remedy_en="Program a signal with one number; several signals need several commands.",
    remedy_de="Ein Signal mit einer Nummer programmieren; mehrere brauchen mehrere Befehle.",
    keyword=("ID, IDMIN, IDMAX or COUNT", "ID, IDMIN, IDMAX oder COUNT"),
)
SIGNAL_NUMBER_MISSING = error(
    901500,
    en="{command} has no signal number",
    de="{command} hat keine Signalnummer",
    remedy_en="Program ID with a number from 1 on, for example ID=5.",
    remedy_de="ID mit einer Nummer ab 1 programmieren, zum Beispiel ID=5.",
    classes=(2, 3),
)
INVALID_SIGNAL_NUMBER = error(
    20995,
    en="{value} is not a signal number: 1 … {highest}",
    de="{value} ist keine Signalnummer: 1 … {highest}",
    remedy_en="Choose a whole number in this range.",
    remedy_de="Eine ganze Zahl in diesem Bereich wählen.",
)
INVALID_SIGNAL_CHANNEL = error(
    20996,
    en="{value} is not a channel number: 1 … {highest}",
    de="{value} ist keine Kanalnummer: 1 … {highest}",
    remedy_en="Choose a whole number in this range.",
    remedy_de="Eine ganze Zahl in diesem Bereich wählen.",
    value=("the value of CH", "der Wert von CH"),
)
SIGNAL_CHANNEL_MISSING = error(
    250008,
    en="channel {value} is named, and the machine has {count}",
    de="Kanal {value} ist angegeben, die Maschine hat aber {count}",
    remedy_en="Name one of the machine's channels; kanal_anzahl of the start-up list counts them.",
    remedy_de="Einen Kanal der Maschine angeben; ihre Anzahl ist kanal_anzahl der Hochlaufliste.",
    value=("the value of CH", "der Wert von CH"),
    count=("the number of channels", "die Anzahl der Kanäle"),
    classes=(3, 1),
)
INVALID_SIGNAL_COUNT = error(
    901501,
    en="{value} is not a valid COUNT of a signal: 1 … {highest}",
    de="{value} ist kein gültiges COUNT eines Signals: 1 … {highest}",
    remedy_en="Leave COUNT out, or choose a whole number in this range.",
    remedy_de="COUNT weglassen oder eine ganze Zahl in diesem Bereich wählen.",
    value=("the value of COUNT", "der Wert von COUNT"),
    classes=(2, 3),
)
EMPTY_SIGNAL_RANGE = error(
    901530,
    en="IDMAX is {high}, less than IDMIN, which is {low}",
    de="IDMAX ist {high}, kleiner als IDMIN mit {low}",
    remedy_en="Program the lower number as IDMIN.",
    remedy_de="Die kleinere Nummer als IDMIN programmieren.",
    low=("the value of ID or IDMIN", "der Wert von ID oder IDMIN"),
    high=("the value of IDMAX", "der Wert von IDMAX"),
    classes=(2, 3),
)
INVALID_SIGNAL_VALUE = error(
    901502,
    en="P[{value}] is not a value of a signal: P[0] … P[{highest}]",
    de="P[{value}] ist kein Parameter eines Signals: P[0] … P[{highest}]",
    remedy_en="Choose a whole number in this range.",
    remedy_de="Eine ganze Zahl in diesem Bereich wählen.",
    value=("the index", "der Index"),
    highest=("the highest index", "der höchste Index"),
    classes=(2, 3),
)
SIGNAL_TARGET = error(
    901503,
    en="P[…]= of {command} needs a variable that takes the value",
    de="P[…]= bei {command} braucht eine Variable, die den Wert aufnimmt",
    remedy_en="Name a variable or parameter: P[0]=V.P.NAME or P[0]=P1.",
    remedy_de="Eine Variable oder einen Parameter angeben: P[0]=V.P.NAME oder P[0]=P1.",
    cause_en="The value of the signal goes from left to right, into the variable after the =.",
    cause_de="Der Wert des Signals geht von links nach rechts, in die Variable nach dem =.",
    classes=(2, 3),
)
WAIT_SYN_WITH_VALUES = error(
    21344,
    en="{command} SYN cannot take values of a signal",
    de="{command} SYN kann keine Signalparameter übernehmen",
    remedy_en="Leave SYN out: the decoder waits then, and has the values.",
    remedy_de="SYN weglassen: dann wartet der Dekoder und hat die Werte.",
    cause_en="With SYN the interpolator waits; by then the blocks after it are already decoded.",
    cause_de="Mit SYN wartet der Interpolator; die Sätze danach sind dann schon dekodiert.",
)
SIGNAL_VALUE_NOT_SENT = error(
    21549,
    en="signal {id} has come without its value P[{index}]",
    de="Signal {id} ist ohne seinen Parameter P[{index}] eingetroffen",
    remedy_en="Program P[{index}]= in the #SIGNAL that sends it, or leave it out here.",
    remedy_de="P[{index}]= im sendenden #SIGNAL programmieren oder hier weglassen.",
    id=("number of the signal", "Nummer des Signals"),
    index=("index of the value", "Index des Parameters"),
)
TOO_MANY_SIGNALS = error(
    250001,
    en="{count} signals are open, and no more can be sent",
    de="{count} Signale sind offen, weitere können nicht gesendet werden",
    remedy_en="Take signals with #WAIT, or clear them with #SIGNAL REMOVE.",
    remedy_de="Signale mit #WAIT abholen oder mit #SIGNAL REMOVE löschen.",
    count=("the number of signals", "die Anzahl der Signale"),
    classes=(3, 6),
)
SIGNAL_OUT_OF_ORDER = error(
    250002,
    en="the sender has sent signal {id} before the signal awaited here",
    de="der Sender hat Signal {id} vor dem gesendet, auf das hier gewartet wird",
    remedy_en="Wait for the signals in the order in which they are sent, or program AHEAD.",
    remedy_de="In der Reihenfolge des Sendens auf die Signale warten oder AHEAD programmieren.",
    cause_en="Signals of one channel to another are taken in the order of their sending.",
    cause_de="Signale von einem Kanal an einen anderen werden in Sendereihenfolge abgeholt.",
    id=("number of the earlier signal", "Nummer des früheren Signals"),
    classes=(3, 6),
)
AHEAD_TAKES_SIGNAL_EARLY = note(
    901504,
    en="AHEAD: the signal is taken even if the sender has sent others before it",
    de="AHEAD: das Signal wird auch abgeholt, wenn der Sender vorher andere gesendet hat",
    remedy_en="Nothing to do; this is reported once per program.",
    remedy_de="Nichts zu tun; das wird einmal je Programm gemeldet.",
    cause_en="No public source describes AHEAD; this is the meaning chosen here.",
    cause_de="Keine öffentliche Quelle beschreibt AHEAD; das ist die hier gewählte Bedeutung.",
)
SIGNAL_NEVER_SENT = warning(
    901505,
    en="no program of this run sends signal {id} {sender}",
    de="kein Programm dieses Laufs sendet Signal {id} {sender}",
    remedy_en="Check the number and CH of #WAIT and #SIGNAL; without it the wait never ends.",
    remedy_de="Nummer und CH von #WAIT und #SIGNAL prüfen; sonst wartet das Programm endlos.",
    id=("number of the signal", "Nummer des Signals"),
    sender=("from where to where", "von wo nach wo"),
)
DEADLOCK = error(
    901506,
    en="channel {channel} has waited since {since} for something that cannot happen: {awaited}",
    de="Kanal {channel} wartet endlos seit {since}: {awaited}",
    remedy_en="{freed_by}",
    remedy_de="{freed_by}",
    cause_en="Each program that still runs waits, and none can send the signal or give the axis "
    "that another waits for.",
    cause_de="Jedes laufende Programm wartet, und keines kann das Signal senden oder die Achse "
    "abgeben, auf die ein anderes wartet.",
    since=("since when", "seit wann"),
    awaited=("what it waits for, and from whom", "worauf und auf wen er wartet"),
    freed_by=("the line that would free it", "die Zeile, die ihn befreien würde"),
)
