# SPDX-License-Identifier: MIT
"""Messages of a schedule that runs for real, and of rtconf.lis beside others (900680 … 900699)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900680,
    ERROR,
    "a schedule runs for real on Linux only; this is {system}",
    "ein Ablauf läuft nur unter Linux wirklich; das hier ist {system}",
    remedy_en="Simulate it: nctakt schedule simulate.",
    remedy_de="Ihn simulieren: nctakt schedule simulate.",
    parameters={
        "system": "the operating system",
    },
)
_add(
    900681,
    ERROR,
    "the part that runs schedules is not installed",
    "der Teil, der Abläufe laufen lässt, ist nicht installiert",
    remedy_en="Install nctakt again where there is a C compiler.",
    remedy_de="nctakt neu installieren, wo ein C-Compiler vorhanden ist.",
)
_add(
    900682,
    WARNING,
    "SCHED_FIFO is not permitted ({reason}): ordinary scheduling, which ignores priorities",
    "SCHED_FIFO ist nicht erlaubt ({reason}): gewöhnliches Scheduling, das Prioritäten nicht kennt",
    remedy_en="Run as root, or raise rtprio in /etc/security/limits.conf; in a container add the "
    "capability SYS_NICE.",
    remedy_de="Als root starten, rtprio in /etc/security/limits.conf erhöhen oder einem "
    "Container SYS_NICE geben.",
    parameters={
        "reason": "what the system says",
    },
)
_add(
    900683,
    NOTE,
    "no hardware interrupt can be had here: a timer gives the NC interrupts, as the load says",
    "einen Hardware-Interrupt gibt es hier nicht: ein Timer gibt die NC-Interrupts nach der Last",
    remedy_en="Nothing to do; interrupt_source 3 takes them from a semaphore.",
    remedy_de="Nichts zu tun; interrupt_source 3 nimmt sie von einem Semaphor.",
)
_add(
    900684,
    ERROR,
    "{name} cannot be the name of a semaphore on Linux",
    "{name} kann unter Linux kein Semaphor heißen",
    remedy_en="At most 250 characters, no '/' but one at the begin.",
    remedy_de="Höchstens 250 Zeichen, kein '/' außer am Anfang.",
    parameters={
        "name": "the semaphore",
    },
)
_add(
    900685,
    ERROR,
    "semaphore {name} is there already: another run, or another program, has made it",
    "den Semaphor {name} gibt es schon: ein anderer Lauf oder ein anderes Programm hat ihn",
    remedy_en="End the other one; if nobody has it any more, remove its file below /dev/shm.",
    remedy_de="Das andere beenden; hat ihn niemand mehr, seine Datei unter /dev/shm löschen.",
    parameters={
        "name": "the semaphore",
    },
)
_add(
    900686,
    ERROR,
    "{name} cannot be made: {reason}",
    "{name} lässt sich nicht anlegen: {reason}",
    remedy_en="See that /dev/shm is there and can be written.",
    remedy_de="Sehen, dass /dev/shm da ist und beschrieben werden kann.",
    parameters={
        "name": "the semaphore, or a file about it",
        "reason": "what the system says",
    },
)
_add(
    900687,
    ERROR,
    "semaphore '{name}', which is to give the NC interrupts, cannot be opened: {reason}",
    "der Semaphor '{name}', der die NC-Interrupts geben soll, lässt sich nicht öffnen: {reason}",
    remedy_en="Start the program that makes it first; external_object_name names it.",
    remedy_de="Zuerst das Programm starten, das ihn anlegt; external_object_name nennt ihn.",
    parameters={
        "name": "the semaphore",
        "reason": "what the system says",
    },
)
_add(
    900688,
    ERROR,
    "the threads want {demand} % of CPU {cpu}: under SCHED_FIFO the machine could stand still",
    "die Threads wollen {demand} % der CPU {cpu}: mit SCHED_FIFO könnte die Maschine stillstehen",
    remedy_en="Lower the load, run with --no-fifo, or insist with --force.",
    remedy_de="Die Last verringern, mit --no-fifo laufen lassen oder auf --force bestehen.",
    parameters={
        "demand": "the demand of all threads, in percent",
        "cpu": "the processor",
    },
)
_add(
    900689,
    ERROR,
    "the run was ended from outside, or could not begin ({reason_en})",
    "der Lauf wurde von außen beendet oder konnte nicht beginnen ({reason_de})",
    remedy_en="Nothing was left behind; start it again.",
    remedy_de="Es blieb nichts zurück; neu starten.",
    parameters={
        "reason_en": "what happened, in English",
        "reason_de": "the same in German",
    },
)
_add(
    900690,
    NOTE,
    "machine.{key} of the load does not count: this machine has the CPUs {cpus}",
    "machine.{key} der Last zählt nicht: diese Maschine hat die CPUs {cpus}",
    remedy_en="Nothing to do; a simulation goes by the load.",
    remedy_de="Nichts zu tun; eine Simulation richtet sich nach der Last.",
    parameters={
        "key": "the entry",
        "cpus": "the processors that can be used",
    },
)
_add(
    900691,
    WARNING,
    "the run ended after {cycles} NC cycles: more cannot be recorded",
    "der Lauf endete nach {cycles} NC-Takten: mehr lässt sich nicht aufzeichnen",
    remedy_en="Run shorter pieces.",
    remedy_de="In kürzeren Stücken laufen lassen.",
    parameters={
        "cycles": "complete NC cycles",
    },
)
_add(
    900692,
    NOTE,
    "removed what a killed run had left behind: {names}",
    "entfernt, was ein abgebrochener Lauf zurückgelassen hatte: {names}",
    remedy_en="Nothing to do.",
    remedy_de="Nichts zu tun.",
    parameters={
        "names": "the semaphores",
    },
)
_add(
    900693,
    NOTE,
    "stopped after {cycles} complete NC cycles",
    "angehalten nach {cycles} ganzen NC-Takten",
    remedy_en="Nothing to do.",
    remedy_de="Nichts zu tun.",
    parameters={
        "cycles": "complete NC cycles",
    },
)
_add(
    900694,
    WARNING,
    "the scheduler woke {count} times later than one time_slice, {latest} µs at most",
    "der Scheduler wachte {count}-mal später als ein time_slice auf, höchstens {latest} µs",
    remedy_en="A kernel with PREEMPT_RT, SCHED_FIFO and a processor of its own make it punctual.",
    remedy_de="Ein Kernel mit PREEMPT_RT, SCHED_FIFO und eine eigene CPU machen ihn pünktlich.",
    parameters={
        "count": "how often",
        "latest": "the longest delay, in µs",
    },
)
_add(
    900695,
    ERROR,
    "not one NC cycle was completed",
    "kein einziger NC-Takt wurde fertig",
    remedy_en="Run longer; with interrupt_source 3 see that somebody gives the semaphore.",
    remedy_de="Länger laufen lassen; bei interrupt_source 3 muss jemand den Semaphor geben.",
)
_add(
    900697,
    WARNING,
    "channel {channel}: realtime cycles may take {allowed} µs, Windows has {windows} of {cycle} µs",
    "Kanal {channel}: Echtzeit-Zyklen dürfen {allowed} µs dauern, Windows hat {windows} von "
    "{cycle} µs",
    remedy_en="Lower rt_cycles.max_duration ({share} %), or windows_time.",
    remedy_de="rt_cycles.max_duration ({share} %) oder windows_time verringern.",
    parameters={
        "channel": "the channel's number",
        "share": "P-CHAN-00425, in percent of the NC cycle",
        "allowed": "what it is of the NC cycle, in µs",
        "windows": "windows_time, in µs",
        "cycle": "cycle_time, in µs",
    },
)
