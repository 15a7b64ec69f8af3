# SPDX-License-Identifier: MIT
"""Messages about the gear steps of spindles."""

from __future__ import annotations

from nctakt.messages.catalogue import error

_STAGE = ("number of the gear step", "Nummer der Getriebestufe")
_SPINDLE = ("name of the spindle", "Name der Spindel")

GEAR_STEP_OUT_OF_FORMAT = error(
    20030,
    en="G112: {stage} is not the number of a gear step",
    de="G112: {stage} ist keine Nummer einer Getriebestufe",
    remedy_en="Give a whole number from 1 to 65535.",
    remedy_de="Eine ganze Zahl von 1 bis 65535 angeben.",
    stage=_STAGE,
)
UNKNOWN_SPINDLE_GEAR = error(
    20029,
    en="the axis list of the spindle {spindle} has no gear step {stage}",
    de="die Achsliste der Spindel {spindle} hat keine Getriebestufe {stage}",
    remedy_en="Describe it there (getriebe[i].nummer), or choose one of these: {known}",
    remedy_de="Sie dort beschreiben (getriebe[i].nummer) oder eine von diesen wählen: {known}",
    spindle=_SPINDLE,
    stage=_STAGE,
    known=("the gear steps of the list", "die Getriebestufen der Liste"),
)
GEAR_CHANGE_WHILE_TURNING = error(
    60285,
    en="G112 while the spindle {spindle} turns",
    de="G112, während die Spindel {spindle} dreht",
    remedy_en="Program M5 before it, or M40 … M45, which stop the spindle themselves.",
    remedy_de="Davor M5 programmieren, oder M40 … M45, die die Spindel selbst anhalten.",
    spindle=_SPINDLE,
    classes=(6, 6),
)
GEAR_OF_PLC_SPINDLE = error(
    901876,
    en="the gear of the spindle {spindle} cannot change: the PLC turns it",
    de="das Getriebe der Spindel {spindle} kann nicht schalten: die SPS dreht sie",
    remedy_en="Gear steps need a spindle that the CNC turns (spindel[i].plc_control 0).",
    remedy_de="Getriebestufen brauchen eine Spindel, die die CNC dreht (spindel[i].plc_control 0).",
    spindle=_SPINDLE,
    classes=(2, 3),
)
NO_GEAR_FOR_SPEED = error(
    901877,
    en="no gear step of the spindle {spindle} has the speed {speed} 1/min",
    de="keine Getriebestufe der Spindel {spindle} hat die Drehzahl {speed} 1/min",
    remedy_en="Program a speed within the ranges of spindel[i].range_table: {ranges}",
    remedy_de="Eine Drehzahl aus den Bereichen von spindel[i].range_table programmieren: {ranges}",
    spindle=_SPINDLE,
    ranges=("the ranges of all steps", "die Bereiche aller Stufen"),
    classes=(2, 3),
)
GEAR_FUNCTION_SYNCHRONISATION = error(
    901878,
    en="M{function} changes the gear, but its synchronisation type does not make the program wait",
    de="M{function} schaltet das Getriebe, aber ihre Synchronisationsart lässt das Programm nicht "
    "warten",
    remedy_en="Set m_synch[{function}] to MVS_SVS (P-CHAN-00041).",
    remedy_de="m_synch[{function}] auf MVS_SVS setzen (P-CHAN-00041).",
    function=("number of the M function", "Nummer der M-Funktion"),
    classes=(2, 3),
)
