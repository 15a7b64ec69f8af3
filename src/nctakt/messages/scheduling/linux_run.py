# SPDX-License-Identifier: MIT
"""Messages about a schedule that runs for real."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

LINUX_ONLY = error(
    900680,
    en="a schedule can only be run in real time on Linux; this is {system}",
    de="ein Ablaufplan lässt sich nur unter Linux in Echtzeit ausführen; dies ist {system}",
    remedy_en="Simulate it instead, with nctakt schedule simulate.",
    remedy_de="Ihn stattdessen mit nctakt schedule simulate simulieren.",
    system=("the operating system", "das Betriebssystem"),
)
SCHEDULE_RUNNER_MISSING = error(
    900681,
    en="the part that runs schedules is not installed",
    de="der Teil, der Ablaufpläne ausführt, ist nicht installiert",
    remedy_en="Reinstall nctakt where a C compiler is available.",
    remedy_de="nctakt dort neu installieren, wo ein C-Compiler vorhanden ist.",
)
SCHED_FIFO_NOT_PERMITTED = warning(
    900682,
    en="SCHED_FIFO is not permitted ({reason}): ordinary scheduling is used, which ignores "
    "priorities",
    de="SCHED_FIFO ist nicht erlaubt ({reason}): es gilt gewöhnliches Scheduling, das Prioritäten "
    "ignoriert",
    remedy_en="Run as root, raise rtprio in /etc/security/limits.conf, or give a container the "
    "capability SYS_NICE.",
    remedy_de="Als root starten, rtprio in /etc/security/limits.conf erhöhen oder einem Container "
    "SYS_NICE geben.",
)
TIMER_INSTEAD_OF_INTERRUPT = note(
    900683,
    en="a timer gives the NC interrupts as defined in the load: there is no other source here",
    de="ein Timer gibt die NC-Interrupts gemäß der Last: eine andere Quelle gibt es hier nicht",
    remedy_en="Nothing to do; with interrupt_source 3 they come from a semaphore.",
    remedy_de="Nichts zu tun; mit interrupt_source 3 kommen sie von einem Semaphor.",
)
INVALID_LINUX_SEMAPHORE_NAME = error(
    900684,
    en="{name} is not a valid name for a semaphore on Linux",
    de="{name} ist unter Linux kein gültiger Name für einen Semaphor",
    remedy_en="Use at most 250 characters, and no '/' except at the start.",
    remedy_de="Höchstens 250 Zeichen verwenden, und kein '/' außer am Anfang.",
    name=("the semaphore", "der Semaphor"),
)
SEMAPHORE_EXISTS = error(
    900685,
    en="semaphore {name} already exists: another run or another program has created it",
    de="den Semaphor {name} gibt es schon: ein anderer Lauf oder ein anderes Programm hat ihn "
    "angelegt",
    remedy_en="End that run; if the semaphore is no longer in use, remove its file in /dev/shm.",
    remedy_de="Diesen Lauf beenden; wird der Semaphor nicht mehr benutzt, seine Datei in /dev/shm "
    "löschen.",
    name=("the semaphore", "der Semaphor"),
)
SEMAPHORE_NOT_CREATED = error(
    900686,
    en="{name} cannot be created: {reason}",
    de="{name} lässt sich nicht anlegen: {reason}",
    remedy_en="Make sure that /dev/shm exists and is writable.",
    remedy_de="Sicherstellen, dass /dev/shm vorhanden und beschreibbar ist.",
    name=("the semaphore, or its file", "der Semaphor oder seine Datei"),
)
SEMAPHORE_NOT_OPENED = error(
    900687,
    en="semaphore '{name}', which should give the NC interrupts, cannot be opened: {reason}",
    de="der Semaphor '{name}' für die NC-Interrupts lässt sich nicht öffnen: {reason}",
    remedy_en="First start the program that creates it; external_object_name or --semaphore gives "
    "its name.",
    remedy_de="Zuerst das Programm starten, das ihn anlegt; den Namen gibt external_object_name "
    "oder --semaphore.",
    name=("the semaphore", "der Semaphor"),
)
CPU_WOULD_STARVE = error(
    900688,
    en="the threads need {demand} % of CPU {cpu}: with SCHED_FIFO the computer could freeze",
    de="die Threads brauchen {demand} % der CPU {cpu}: mit SCHED_FIFO könnte der Rechner "
    "stehenbleiben",
    remedy_en="Reduce the load, run with --no-fifo, or insist with --force.",
    remedy_de="Die Last verringern, mit --no-fifo ausführen oder mit --force darauf bestehen.",
    demand=("the demand of all threads, in percent", "der Bedarf aller Threads, in Prozent"),
)
SCHEDULE_RUN_ENDED = error(
    900689,
    en="the run was ended from outside or could not start ({reason})",
    de="der Lauf wurde von außen beendet oder konnte nicht starten ({reason})",
    remedy_en="It has cleaned up; start it again.",
    remedy_de="Es ist nichts zurückgeblieben; den Lauf neu starten.",
    reason=("what happened", "was geschah"),
)
LOAD_MACHINE_IGNORED = note(
    900690,
    en="machine.{key} of the load is ignored: this computer has the CPUs {cpus}",
    de="machine.{key} der Last wird ignoriert: dieser Rechner hat die CPUs {cpus}",
    remedy_en="Nothing to do; a simulation uses the load.",
    remedy_de="Nichts zu tun; eine Simulation verwendet die Last.",
    cpus=("the processors that can be used", "die verfügbaren Prozessoren"),
)
SCHEDULE_RECORDING_FULL = warning(
    900691,
    en="the run ended after {cycles} NC cycles: no more can be recorded",
    de="der Lauf endete nach {cycles} NC-Takten: mehr lässt sich nicht aufzeichnen",
    remedy_en="Keep the runs shorter.",
    remedy_de="Die Läufe kürzer halten.",
    cycles=("complete NC cycles", "vollständige NC-Takte"),
)
LEFTOVERS_REMOVED = note(
    900692,
    en="removed the leftovers of a killed run: {names}",
    de="Reste eines abgebrochenen Laufs entfernt: {names}",
    remedy_en="Nothing to do.",
    remedy_de="Nichts zu tun.",
    names=("the semaphores", "die Semaphore"),
)
SCHEDULE_RUN_STOPPED = note(
    900693,
    en="stopped after {cycles} complete NC cycles",
    de="angehalten nach {cycles} vollständigen NC-Takten",
    remedy_en="Nothing to do.",
    remedy_de="Nichts zu tun.",
    cycles=("complete NC cycles", "vollständige NC-Takte"),
)
LATE_WAKEUPS = warning(
    900694,
    en="the scheduler woke up more than one time_slice late {count} times, by up to {latest} µs",
    de="der Scheduler wachte {count}-mal mehr als ein time_slice zu spät auf, um bis zu {latest} "
    "µs",
    remedy_en="A kernel with PREEMPT_RT, SCHED_FIFO and a dedicated processor make it punctual.",
    remedy_de="Ein Kernel mit PREEMPT_RT, SCHED_FIFO und ein eigener Prozessor machen ihn "
    "pünktlich.",
    count=("the number of late wake-ups", "die Anzahl der verspäteten Weckvorgänge"),
    latest=("the longest delay, in µs", "die längste Verspätung in µs"),
)
NO_NC_CYCLE_COMPLETED = error(
    900695,
    en="no NC cycle was completed",
    de="kein NC-Takt wurde vollständig ausgeführt",
    remedy_en="Run longer; with interrupt_source 3 make sure that the semaphore is given.",
    remedy_de="Länger laufen lassen; bei interrupt_source 3 muss der Semaphor gegeben werden.",
)
CYCLES_MAY_TAKE_WINDOWS_TIME = warning(
    900697,
    en="channel {channel}: realtime cycles may take {allowed} µs, Windows has {windows} of {cycle} "
    "µs",
    de="Kanal {channel}: Echtzeit-Zyklen dürfen {allowed} µs dauern, Windows hat {windows} von "
    "{cycle} µs",
    remedy_en="Lower rt_cycles.max_duration ({share} %), or windows_time.",
    remedy_de="rt_cycles.max_duration ({share} %) oder windows_time verringern.",
    share=("P-CHAN-00425, in percent of the NC cycle", "P-CHAN-00425, in Prozent des NC-Takts"),
    allowed=("this share of the NC cycle, in µs", "dieser Anteil am NC-Takt, in µs"),
    cycle=("cycle_time, in µs", "cycle_time in µs"),
)
POSTS_DRAINED = note(
    900696,
    en="semaphore '{name}' was posted {count} times before the start; these posts are ignored",
    de="der Semaphor '{name}' wurde vor dem Start schon {count}-mal gegeben; das wird ignoriert",
    remedy_en="Nothing to do; only later posts are NC interrupts.",
    remedy_de="Nichts zu tun; nur spätere sind NC-Interrupts.",
    name=("the semaphore", "der Semaphor"),
    count=("the number of posts", "wie oft er gegeben wurde"),
)
POSTS_CEASED = warning(
    900698,
    en="semaphore '{name}' was not posted for {gap} µs, starting at {time} µs; {expected} µs are "
    "usual",
    de="der Semaphor '{name}' wurde ab {time} µs für {gap} µs nicht gegeben; üblich sind "
    "{expected} µs",
    remedy_en="Check whether the program that posts it is still running.",
    remedy_de="Prüfen, ob das Programm, das ihn gibt, noch läuft.",
    name=("the semaphore", "der Semaphor"),
    gap=("the longest time without a post, in µs", "die längste Zeit ohne Freigabe, in µs"),
    time=("the start of this time, in µs of the run", "der Beginn dieser Zeit, in µs des Laufs"),
    expected=("the period of the NC interrupts, in µs", "die Periode der NC-Interrupts, in µs"),
)
NOBODY_WAITS = warning(
    900699,
    en="hardly anybody waits for semaphore '{name}': {taken} of {count} wake-ups were used",
    de="auf den Semaphor '{name}' wartet kaum jemand: {taken} von {count} Weckrufen wurden genutzt",
    remedy_en="Start the program of this thread, or replace it with --stand-in.",
    remedy_de="Das Programm dieses Threads starten oder es durch --stand-in ersetzen.",
    name=("the semaphore", "der Semaphor"),
    taken=("the number of wake-ups that were used", "die Anzahl der genutzten Weckrufe"),
    count=("the number of wake-ups", "die Anzahl der Weckrufe"),
)
SEMAPHORE_NOT_NAMED = error(
    900708,
    en="the semaphore that gives the NC interrupts is not named",
    de="der Semaphor, der die NC-Interrupts gibt, ist nicht benannt",
    remedy_en="Name it with --semaphore NAME, or with external_object_name in the list.",
    remedy_de="Ihn mit --semaphore NAME oder in der Liste mit external_object_name benennen.",
)
SEMAPHORE_OPTION_WITHOUT_EFFECT = warning(
    900709,
    en="--semaphore has no effect: interrupt_source is not a semaphore",
    de="--semaphore hat keine Wirkung: interrupt_source ist kein Semaphor",
    remedy_en="Omit the option, or set interrupt_source to 3.",
    remedy_de="Die Option weglassen oder interrupt_source auf 3 setzen.",
)
