# SPDX-License-Identifier: MIT
"""The meanings of the HLI's structures and values in German.

The English ones stand with their declarations (``hli/layout.py``), from which the C header is
written. A key is the name of a structure, or of a value in it.
"""

from __future__ import annotations

from nctakt.hli.layout import VERSION

GERMAN: dict[str, str] = {
    "hli_header": "der Anfang des Abbilds: was es gibt, wo es steht, und die Uhr",
    "hli_header.magic": "`NCTAKT` und zwei Nullbytes",
    "hli_header.version": f"{VERSION}; eine andere ist ein anderer Aufbau",
    "hli_header.ready": "1, solange die CNC da ist; zuletzt geschrieben, zuerst weggenommen",
    "hli_header.size": "das ganze Abbild",
    "hli_header.cycle_time_us": "die Dauer eines Takts",
    "hli_header.channels": "Anzahl der `hli_channel` und der `hli_command`",
    "hli_header.channel_offset": "Stelle des ersten `hli_channel`",
    "hli_header.channel_size": "von einem `hli_channel` zum nächsten",
    "hli_header.axes": "Anzahl der `hli_axis`",
    "hli_header.axis_offset": "Stelle der ersten `hli_axis`",
    "hli_header.axis_size": "von einer `hli_axis` zur nächsten",
    "hli_header.spindles": "Anzahl der `hli_spindle` und der `hli_spindle_command`",
    "hli_header.spindle_offset": "Stelle der ersten `hli_spindle`",
    "hli_header.spindle_size": "von einer `hli_spindle` zur nächsten",
    "hli_header.command_offset": "Stelle des ersten `hli_command`",
    "hli_header.command_size": "von einem `hli_command` zum nächsten",
    "hli_header.spindle_command_offset": "Stelle des ersten `hli_spindle_command`",
    "hli_header.spindle_command_size": "von einem davon zum nächsten",
    "hli_header.link_offset": "Stelle von `hli_link`",
    "hli_header.ve_offset": "Stelle der V.E-Variablen",
    "hli_header.ve_size": "der V.E-Variablen, alle Abschnitte",
    "hli_header.sequence": (
        "ungerade, während die CNC schreibt; unverändert: das Gelesene passt zusammen"
    ),
    "hli_header.tick": "Takte, die gelaufen sind",
    "hli_header.turn": "im Gleichschritt: zählt, wie oft die CNC auf die SPS wartet",
    "hli_link": "die Seite der SPS im Gleichschritt",
    "hli_link.turn": "`turn` des Kopfes, sobald die SPS geantwortet hat",
    "hli_link.process": "ID des Prozesses der SPS, dessen Ende bemerkt wird; 0: keiner",
    "hli_unit": "ein Platz für eine M- oder H-Funktion",
    "hli_unit.serial": "0: frei; sonst die laufende Nummer der Funktion",
    "hli_unit.letter": "1 M, 2 H",
    "hli_unit.number": "der Funktion: 100 für M100",
    "hli_unit.sequence": "ihre Nummer unter denen ihres Takts und Abschnitts, ab 1",
    "hli_unit.axis": "`logical` der Achse oder Spindel, für die sie ist, 0: Kanal",
    "hli_unit.value": "ihr Wert im Programm wie in M110=130; 0 ohne Wert",
    "hli_unit.identifier": "1: die des Programms, 2 POS_RT: die eines Echtzeit-Zyklus",
    "hli_unit.synchronisation": (
        "Bits ihrer Synchronisationsart, 1 MOS, 2 MVS_SVS … (P-CHAN-00041, P-CHAN-00027); "
        "POS_RT: immer MOS"
    ),
    "hli_unit.time_us": "der Anfang des Takts, der sie beauftragt hat",
    "hli_unit.duration_us": "die Zeit, die ihr die Kanalliste gibt",
    "hli_channel": "der Zustand eines Kanals",
    "hli_channel.state": "0 bereit, 1 ein Programm läuft, 2 Fehler, 3 Reset",
    "hli_channel.paused": "1: Einzelsatz, M00 oder M01 wartet auf START",
    "hli_channel.armed": "1: ein angewähltes Programm wartet auf START",
    "hli_channel.error": "Nummer des Fehlers, der den Kanal angehalten hat, sonst 0",
    "hli_channel.retrace": "0: am vorderen Ende, 1 rückwärts über die Historie, 2 wieder vorwärts",
    "hli_channel.history": "Sätze in der Historie der Bahn, der aktuelle mitgezählt",
    "hli_channel.inside_rt_loop": "1: die Bahn ist in einer Echtzeitschleife",
    "hli_channel.history_size": "Sätze, die die Historie fasst (P-STUP-00033); 0: keine",
    "hli_channel.override_total": "der wirksame",
    "hli_channel.path_speed": "die Geschwindigkeit auf der Bahn",
    "hli_channel.distance_to_go": "Restweg des Satzes",
    "hli_channel.block": "N-Nummer des aktuellen Satzes",
    "hli_channel.active_cycles": "Echtzeit-Zyklen, die laufen",
    "hli_axis": "der Zustand einer Achse",
    "hli_axis.name": "ihr Name im Kanal, mit einem Nullbyte",
    "hli_axis.logical": "ihre logische Nummer",
    "hli_axis.command": "Sollposition, ACS",
    "hli_axis.actual": "Istposition, ACS",
    "hli_axis.target": "Ende der Bewegung, ACS",
    "hli_axis.machine": "Sollposition, MCS",
    "hli_axis.program": "Sollposition, PCS",
    "hli_axis.distance_to_go": "Restweg bis zum Ziel",
    "hli_axis.override_total": "der ihrer eigenen Bewegungen",
    "hli_axis.state": (
        "PLCopen: 1 Standstill, 2 DiscreteMotion, 3 ContinuousMotion, 4 Stopping, 5 ErrorStop, "
        "6 SynchronizedMotion"
    ),
    "hli_spindle": (
        "der Zustand einer Spindel; wo die SPS sie dreht, der Auftrag, der auf sie wartet"
    ),
    "hli_spindle.name": "ihr Name in Programmen, mit einem Nullbyte",
    "hli_spindle.logical": "ihre logische Nummer",
    "hli_spindle.channel": "Nummer ihres Kanals, ab 1",
    "hli_spindle.plc_controlled": "1: die SPS dreht sie (P-CHAN-00069)",
    "hli_spindle.speed": "negativ unter M4; nur die der CNC",
    "hli_spindle.position": "0 … 360; nur die der CNC",
    "hli_spindle.job": "0: keiner wartet; sonst die laufende Nummer des Auftrags",
    "hli_spindle.function": "3, 4, 5 oder 19: M3, M4, M5, M19",
    "hli_spindle.direction": "bei M19: 0 der kürzere Weg, 1 vorwärts, 2 rückwärts",
    "hli_spindle.job_time_us": "der Anfang des Takts, der ihn beauftragt hat",
    "hli_spindle.job_duration_us": "die Zeit, die ihm die Kanalliste gibt",
    "hli_spindle.job_speed": "die beauftragte Drehzahl",
    "hli_spindle.job_position": "bei M19",
    "hli_command": "was die SPS einem Kanal befiehlt",
    "hli_command.override": "der Override der Bahn vom Bediener",
    "hli_command.feed_hold": "1: die Bahn bremst bis zum Stillstand und bleibt dort",
    "hli_command.single_block": "1: der Kanal hält vor jedem Satz",
    "hli_command.start": "START: die SPS schreibt 1, die CNC nimmt es und schreibt 0",
    "hli_command.reset": "RESET: die SPS schreibt 1, die CNC nimmt es und schreibt 0",
    "hli_command.plc_present": "1: die SPS quittiert Funktionen, 0: die CNC selbst",
    "hli_command.backward_motion": "1: die Bahn wird rückwärts abgefahren, 0: wieder vorwärts",
    "hli_command.probe": "1: der Taster der Kantenanleimung ist auf der Kante",
    "hli_command.optional_stop": "1: M01 hält wie M00",
    "hli_command.ack_program": "quittiert `program[i]` des Kanals: dessen laufende Nummer",
    "hli_command.ack_realtime": "quittiert `realtime[i]` des Kanals: dessen laufende Nummer",
    "hli_spindle_command": "die Antwort der SPS für eine Spindel, die sie dreht",
    "hli_spindle_command.ack_job": "quittiert `job` der Spindel: dessen Nummer",
    "hli_spindle_command.reserved": "nicht benutzt",
}
