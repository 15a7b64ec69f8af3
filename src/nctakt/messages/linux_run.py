# SPDX-License-Identifier: MIT
"""Messages about a schedule that runs for real."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

LINUX_ONLY = error(
    900680,
    en="a schedule runs for real on Linux only; this is {system}",
    de="ein Ablauf läuft nur unter Linux wirklich; das hier ist {system}",
    remedy_en="Simulate it: nctakt schedule simulate.",
    remedy_de="Ihn simulieren: nctakt schedule simulate.",
    system=("the operating system", "das Betriebssystem"),
)
SCHEDULE_RUNNER_MISSING = error(
    900681,
    en="the part that runs schedules is not installed",
    de="der Teil, der Abläufe laufen lässt, ist nicht installiert",
    remedy_en="Install nctakt again where there is a C compiler.",
    remedy_de="nctakt neu installieren, wo ein C-Compiler vorhanden ist.",
)
SCHED_FIFO_NOT_PERMITTED = warning(
    900682,
    en="SCHED_FIFO is not permitted ({reason}): ordinary scheduling, which ignores priorities",
    de="SCHED_FIFO ist nicht erlaubt ({reason}): gewöhnliches Scheduling, das Prioritäten nicht "
    "kennt",
    remedy_en="Run as root, or raise rtprio in /etc/security/limits.conf; in a container add the "
    "capability SYS_NICE.",
    remedy_de="Als root starten, rtprio in /etc/security/limits.conf erhöhen oder einem Container "
    "SYS_NICE geben.",
    reason=("what the system says", "was das System sagt"),
)
TIMER_INSTEAD_OF_INTERRUPT = note(
    900683,
    en="a timer plays the NC interrupts as the load has them: nothing else gives them here",
    de="ein Timer spielt die NC-Interrupts nach der Last: nichts anderes gibt sie hier",
    remedy_en="Nothing to do; interrupt_source 3 takes them from a semaphore.",
    remedy_de="Nichts zu tun; interrupt_source 3 nimmt sie von einem Semaphor.",
)
INVALID_LINUX_SEMAPHORE_NAME = error(
    900684,
    en="{name} cannot be the name of a semaphore on Linux",
    de="{name} kann unter Linux kein Semaphor heißen",
    remedy_en="At most 250 characters, no '/' but one at the begin.",
    remedy_de="Höchstens 250 Zeichen, kein '/' außer am Anfang.",
    name=("the semaphore", "der Semaphor"),
)
SEMAPHORE_EXISTS = error(
    900685,
    en="semaphore {name} is there already: another run, or another program, has made it",
    de="den Semaphor {name} gibt es schon: ein anderer Lauf oder ein anderes Programm hat ihn",
    remedy_en="End the other one; if nobody has it any more, remove its file below /dev/shm.",
    remedy_de="Das andere beenden; hat ihn niemand mehr, seine Datei unter /dev/shm löschen.",
    name=("the semaphore", "der Semaphor"),
)
SEMAPHORE_NOT_CREATED = error(
    900686,
    en="{name} cannot be made: {reason}",
    de="{name} lässt sich nicht anlegen: {reason}",
    remedy_en="See that /dev/shm is there and can be written.",
    remedy_de="Sehen, dass /dev/shm da ist und beschrieben werden kann.",
    name=("the semaphore, or a file about it", "der Semaphor oder eine Datei über ihn"),
    reason=("what the system says", "was das System sagt"),
)
SEMAPHORE_NOT_OPENED = error(
    900687,
    en="semaphore '{name}', which is to give the NC interrupts, cannot be opened: {reason}",
    de="der Semaphor '{name}', der die NC-Interrupts geben soll, lässt sich nicht öffnen: {reason}",
    remedy_en="Start the program that makes it first; external_object_name or --semaphore names "
    "it.",
    remedy_de="Zuerst das Programm starten, das ihn anlegt; external_object_name oder --semaphore "
    "nennt ihn.",
    name=("the semaphore", "der Semaphor"),
    reason=("what the system says", "was das System sagt"),
)
CPU_WOULD_STARVE = error(
    900688,
    en="the threads want {demand} % of CPU {cpu}: under SCHED_FIFO the machine could stand still",
    de="die Threads wollen {demand} % der CPU {cpu}: mit SCHED_FIFO könnte die Maschine "
    "stillstehen",
    remedy_en="Lower the load, run with --no-fifo, or insist with --force.",
    remedy_de="Die Last verringern, mit --no-fifo laufen lassen oder auf --force bestehen.",
    demand=("the demand of all threads, in percent", "der Bedarf aller Threads, in Prozent"),
    cpu=("the processor", "der Prozessor"),
)
SCHEDULE_RUN_ENDED = error(
    900689,
    en="the run was ended from outside, or could not begin ({reason})",
    de="der Lauf wurde von außen beendet oder konnte nicht beginnen ({reason})",
    remedy_en="Nothing was left behind; start it again.",
    remedy_de="Es blieb nichts zurück; neu starten.",
    reason=("what happened", "was geschah"),
)
LOAD_MACHINE_IGNORED = note(
    900690,
    en="machine.{key} of the load does not count: this machine has the CPUs {cpus}",
    de="machine.{key} der Last zählt nicht: diese Maschine hat die CPUs {cpus}",
    remedy_en="Nothing to do; a simulation goes by the load.",
    remedy_de="Nichts zu tun; eine Simulation richtet sich nach der Last.",
    key=("the entry", "der Eintrag"),
    cpus=("the processors that can be used", "die Prozessoren, die benutzt werden können"),
)
SCHEDULE_RECORDING_FULL = warning(
    900691,
    en="the run ended after {cycles} NC cycles: more cannot be recorded",
    de="der Lauf endete nach {cycles} NC-Takten: mehr lässt sich nicht aufzeichnen",
    remedy_en="Run shorter pieces.",
    remedy_de="In kürzeren Stücken laufen lassen.",
    cycles=("complete NC cycles", "vollständige NC-Zyklen"),
)
LEFTOVERS_REMOVED = note(
    900692,
    en="removed what a killed run had left behind: {names}",
    de="entfernt, was ein abgebrochener Lauf zurückgelassen hatte: {names}",
    remedy_en="Nothing to do.",
    remedy_de="Nichts zu tun.",
    names=("the semaphores", "die Semaphore"),
)
SCHEDULE_RUN_STOPPED = note(
    900693,
    en="stopped after {cycles} complete NC cycles",
    de="angehalten nach {cycles} ganzen NC-Takten",
    remedy_en="Nothing to do.",
    remedy_de="Nichts zu tun.",
    cycles=("complete NC cycles", "vollständige NC-Zyklen"),
)
LATE_WAKEUPS = warning(
    900694,
    en="the scheduler woke {count} times later than one time_slice, {latest} µs at most",
    de="der Scheduler wachte {count}-mal später als ein time_slice auf, höchstens {latest} µs",
    remedy_en="A kernel with PREEMPT_RT, SCHED_FIFO and a processor of its own make it punctual.",
    remedy_de="Ein Kernel mit PREEMPT_RT, SCHED_FIFO und eine eigene CPU machen ihn pünktlich.",
    count=("how often", "wie oft"),
    latest=("the longest delay, in µs", "die längste Verspätung in µs"),
)
NO_NC_CYCLE_COMPLETED = error(
    900695,
    en="not one NC cycle was completed",
    de="kein einziger NC-Takt wurde fertig",
    remedy_en="Run longer; with interrupt_source 3 see that somebody gives the semaphore.",
    remedy_de="Länger laufen lassen; bei interrupt_source 3 muss jemand den Semaphor geben.",
)
CYCLES_MAY_TAKE_WINDOWS_TIME = warning(
    900697,
    en="channel {channel}: realtime cycles may take {allowed} µs, Windows has {windows} of {cycle} "
    "µs",
    de="Kanal {channel}: Echtzeit-Zyklen dürfen {allowed} µs dauern, Windows hat {windows} von "
    "{cycle} µs",
    remedy_en="Lower rt_cycles.max_duration ({share} %), or windows_time.",
    remedy_de="rt_cycles.max_duration ({share} %) oder windows_time verringern.",
    channel=("the channel's number", "die Nummer des Kanals"),
    share=("P-CHAN-00425, in percent of the NC cycle", "P-CHAN-00425 in Prozent des NC-Zyklus"),
    allowed=("what it is of the NC cycle, in µs", "was das vom NC-Zyklus ist, in µs"),
    windows=("windows_time, in µs", "windows_time, in µs"),
    cycle=("cycle_time, in µs", "cycle_time in µs"),
)
POSTS_DRAINED = note(
    900696,
    en="semaphore '{name}' had been posted {count} times before the start; these do not count",
    de="der Semaphor '{name}' war vor dem Start schon {count}-mal gegeben; das zählt nicht",
    remedy_en="Nothing to do; only later posts are NC interrupts.",
    remedy_de="Nichts zu tun; nur spätere sind NC-Interrupts.",
    name=("the semaphore", "der Semaphor"),
    count=("how often", "wie oft"),
)
POSTS_CEASED = warning(
    900698,
    en="semaphore '{name}' was not posted for {gap} µs from {time} µs on; {expected} µs are usual",
    de="der Semaphor '{name}' wurde ab {time} µs für {gap} µs nicht gegeben; üblich sind "
    "{expected} µs",
    remedy_en="See whether the program that posts it still runs.",
    remedy_de="Prüfen, ob das Programm, das ihn gibt, noch läuft.",
    name=("the semaphore", "der Semaphor"),
    gap=("the longest time without a post, in µs", "die längste Zeit ohne ihn, in µs"),
    time=("when that time began, in µs of the run", "wann sie begann, in µs des Laufs"),
    expected=("the period of the NC interrupts, in µs", "die Periode der NC-Interrupts, in µs"),
)
NOBODY_WAITS = warning(
    900699,
    en="hardly anybody waits on semaphore '{name}': {taken} of {count} wake-ups were taken",
    de="auf den Semaphor '{name}' wartet kaum jemand: {taken} von {count} Weckrufen wurden "
    "genommen",
    remedy_en="Start the program of this thread, or play it with --stand-in.",
    remedy_de="Das Programm dieses Threads starten oder ihn mit --stand-in spielen lassen.",
    name=("the semaphore", "der Semaphor"),
    taken=("how many wake-ups were taken", "wie viele Weckrufe genommen wurden"),
    count=("how many there were", "wie viele es gab"),
)
SEMAPHORE_NOT_NAMED = error(
    900708,
    en="nobody names the semaphore that gives the NC interrupts",
    de="niemand nennt den Semaphor, der die NC-Interrupts gibt",
    remedy_en="Name it with --semaphore NAME, or with external_object_name in the list.",
    remedy_de="Ihn mit --semaphore NAME nennen oder mit external_object_name in der Liste.",
)
SEMAPHORE_OPTION_WITHOUT_EFFECT = warning(
    900709,
    en="--semaphore has no effect: interrupt_source is not a semaphore",
    de="--semaphore bleibt ohne Wirkung: interrupt_source ist kein Semaphor",
    remedy_en="Leave the option out, or set interrupt_source to 3.",
    remedy_de="Die Option weglassen oder interrupt_source auf 3 setzen.",
)
