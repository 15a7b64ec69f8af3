# SPDX-License-Identifier: MIT
"""Messages about measuring with a touch probe (G100, #MEAS, G101)."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note

PROBE_PRESSED = error(
    50052,
    en="the probe is already pressed where the measuring block begins",
    de="der Taster ist zu Beginn des Messsatzes schon ausgelenkt",
    remedy_en="Set HLI.PROBE to 0 before the block, or meas_allow_actuated_probe (P-CHAN-00312) "
    "to 1.",
    remedy_de="HLI.PROBE vor dem Satz auf 0 setzen oder meas_allow_actuated_probe (P-CHAN-00312) "
    "auf 1.",
    classes=(6, 6),
)
NO_PROBE_SIGNAL = error(
    901700,
    en="the probe gave no signal in the measuring block",
    de="der Taster hat im Messsatz kein Signal gegeben",
    remedy_en="Set HLI.PROBE while the block moves, simulate a probe (P-AXIS-00112), or write "
    "#MEAS [ERR_NO_SIGNAL=0].",
    remedy_de="HLI.PROBE während der Fahrt setzen, Taster simulieren (P-AXIS-00112) oder "
    "#MEAS [ERR_NO_SIGNAL=0].",
    cause_en="Measuring type 2 needs the signal; the others where meas_error_no_signal "
    "(P-CHAN-00176) or #MEAS [ERR_NO_SIGNAL=1] says so.",
    cause_de="Messtyp 2 braucht das Signal; die anderen, wo es meas_error_no_signal "
    "(P-CHAN-00176) oder #MEAS [ERR_NO_SIGNAL=1] verlangt.",
    classes=(6, 6),
)
NO_MEASURING_WAY = error(
    50067,
    en="the measuring block moves no axis",
    de="der Messsatz bewegt keine Achse",
    remedy_en="Program a target beyond the workpiece, or set meas_error_no_move_path "
    "(P-CHAN-00313) to 0.",
    remedy_de="Ein Ziel hinter dem Werkstück programmieren oder meas_error_no_move_path "
    "(P-CHAN-00313) = 0 setzen.",
)
UNKNOWN_MEASURING_TYPE = error(
    20437,
    en="{type} is not a measuring type",
    de="{type} ist kein Messtyp",
    remedy_en="Types 1 to 4 and 7 are those of G100, 5 and 6 those of G310.",
    remedy_de="1 bis 4 und 7 sind die Typen von G100, 5 und 6 die von G310.",
)
TYPE_WITHOUT_G100 = error(
    20138,
    en="G100 with measuring type {type}, which belongs to G310",
    de="G100 mit Messtyp {type}, der zu G310 gehört",
    remedy_en="Choose type 1, 2, 3 or 4 by #MEAS MODE before the block, or write G310.",
    remedy_de="Vor dem Satz mit #MEAS MODE Typ 1, 2, 3 oder 4 wählen, oder G310 schreiben.",
    type=("the active type", "der wirksame Typ"),
)
TYPE_WITHOUT_G310 = error(
    20956,
    en="G310 with measuring type {type}: only types 5 and 6 interrupt a block",
    de="G310 mit Messtyp {type}: nur die Typen 5 und 6 unterbrechen einen Satz",
    remedy_en="Write #MEAS MODE [5] before the block.",
    remedy_de="Vor dem Satz #MEAS MODE [5] schreiben.",
    type=("the active type", "der wirksame Typ"),
)
MEASURING_DURING_SEARCH = error(
    50718,
    en="{word} before the start block: block search cannot measure",
    de="{word} vor dem Startsatz: der Satzvorlauf kann nicht messen",
    remedy_en="Skip the block (/{word}), or begin before it.",
    remedy_de="Den Satz ausblenden (/{word}) oder vor ihm beginnen.",
    word=("G100 or G310", "G100 oder G310"),
    classes=(2, 7),
)
NO_FIXED_STOP_DETECTION = error(
    901701,
    en="{axis} does not find fixed stops: {key} is {value}",
    de="{axis} erkennt keinen Festanschlag: {key} ist {value}",
    remedy_en="Set kenngr.meas_signal_fixed_stop (P-AXIS-00330) to 1, and a lag above 0.",
    remedy_de="kenngr.meas_signal_fixed_stop (P-AXIS-00330) auf 1 und einen Abstand über 0 setzen.",
    cause_en="At a fixed stop the command runs ahead of the axis by more than P-AXIS-00774, "
    "P-AXIS-00769 or P-AXIS-00331.",
    cause_de="Am Festanschlag eilt der Sollwert der Achse um mehr als P-AXIS-00774, P-AXIS-00769 "
    "oder P-AXIS-00331 voraus.",
    key=("the entry of its list", "der Eintrag ihrer Liste"),
    classes=(2, 3),
)
NOT_A_MEASURING_AXIS = error(
    50059,
    known_as=(901702,),
    en="{axis} may not take part in measuring motions",
    de="{axis} darf nicht an Messfahrten teilnehmen",
    remedy_en="Set kenngr.messachse (P-AXIS-00118) of the axis to 1.",
    remedy_de="kenngr.messachse (P-AXIS-00118) der Achse auf 1 setzen.",
    classes=(4, 6),
)
WRONG_MEASURING_AXES = error(
    50061,
    known_as=(901703,),
    en="measuring type {type} with {count} axes: {axes}",
    de="Messtyp {type} mit {count} Achsen: {axes}",
    remedy_en="Type 2 measures exactly one axis, type 4 the first three of the channel only.",
    remedy_de="Typ 2 misst genau eine Achse, Typ 4 nur die ersten drei des Kanals.",
    count=("how many axes the block has", "wie viele Achsen der Satz hat"),
    axes=("the axes of the block", "die Achsen des Satzes"),
    classes=(4, 6),
)
CONTINUATION_WITHOUT_TYPE_3 = error(
    20772,
    known_as=(901704,),
    en="G106 with measuring type {type}: only type 3 continues after the signal",
    de="G106 mit Messtyp {type}: nur Typ 3 fährt nach dem Signal weiter",
    remedy_en="Write #MEAS MODE [3] before the block.",
    remedy_de="Vor dem Satz #MEAS MODE [3] schreiben.",
    type=("the active type", "der wirksame Typ"),
)
CONTINUATION_WITHOUT_MEASURING = error(
    901705,
    en="G106 in a block that does not measure",
    de="G106 in einem Satz, der nicht misst",
    remedy_en="Write G100 in the same block, with measuring type 3.",
    remedy_de="G100 in denselben Satz schreiben, mit Messtyp 3.",
    classes=(2, 3),
)
NO_MEASURED_VALUE = error(
    901706,
    en="G101: {axis} has no measured value to include",
    de="G101: {axis} hat keinen Messwert zum Einrechnen",
    remedy_en="Measure the axis first (G100), and ask V.A.MERF.{axis} whether the probe touched.",
    remedy_de="Die Achse zuerst messen (G100) und mit V.A.MERF.{axis} prüfen, ob der Taster "
    "geschaltet hat.",
    classes=(2, 3),
)
SIMULATED_OFFSET_WITHOUT_MODE = error(
    901707,
    en="SIMU_OFFSET without an axis whose simulated probe touches at the target",
    de="SIMU_OFFSET ohne eine Achse, deren simulierter Taster am Ziel schaltet",
    remedy_en="Give a measuring axis meas_simu.meas_simu_mode (P-AXIS-00112) 4.",
    remedy_de="Einer Messachse meas_simu.meas_simu_mode (P-AXIS-00112) 4 geben.",
    classes=(2, 3),
)
PROBE_CHOICE_WITHOUT_EFFECT = note(
    901708,
    en="{word} of #MEAS has no effect: all axes measure with HLI.PROBE",
    de="{word} von #MEAS hat keine Wirkung: alle Achsen messen mit HLI.PROBE",
)
