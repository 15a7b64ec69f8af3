# SPDX-License-Identifier: MIT
"""Messages about a controller whose threads run by a scheduling list on a real clock."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

STEPS_BESIDE_TICKS = note(
    901460,
    en="decoder and PLC work between two ticks: a tick begins after the block or PLC call that "
    "is running",
    de="Dekoder und SPS arbeiten zwischen zwei Takten: ein Takt beginnt nach dem laufenden Satz "
    "oder SPS-Aufruf",
    remedy_en="The wake-up latency of the interpolation's thread shows the cost.",
    remedy_de="Die Kosten zeigt die Aufwachverzögerung des Interpolations-Threads.",
)
ALWAYS_A_TIMER = note(
    901552,
    en="a timer gives the NC interrupts of a served controller, whatever interrupt_source says",
    de="ein Timer gibt die NC-Interrupts dieser Steuerung, was auch immer interrupt_source sagt",
    remedy_en="nctakt schedule run waits for a semaphore; so does a PLC's thread here.",
    remedy_de="Auf einen Semaphor wartet nctakt schedule run, hier nur der Thread der SPS.",
)
THREADS_SHARED = note(
    901461,
    en="these threads share the work of another thread with the same function: {threads}",
    de="diese Threads teilen sich die Arbeit eines anderen mit derselben Funktion: {threads}",
    remedy_en="Interpolation and decoder of a context each run in the first of their threads.",
    remedy_de="Interpolation und Dekoder eines Kontexts laufen je im ersten ihrer Threads.",
)
THREADS_WITHOUT_WORK = note(
    901462,
    en="these threads have no work here and are not run: {threads}",
    de="diese Threads haben hier keine Arbeit und laufen nicht: {threads}",
    remedy_en="nctakt schedule run plays all threads, with the times of a load.",
    remedy_de="nctakt schedule run spielt alle Threads, mit den Zeiten einer Last.",
)
THREAD_NOT_PLACED = warning(
    901463,
    en="thread {thread} does not have the class or processor of the list: {reason}",
    de="Thread {thread} hat nicht die Klasse oder den Prozessor der Liste: {reason}",
    remedy_en="Give nctakt the right to use SCHED_FIFO and this processor.",
    remedy_de="nctakt das Recht auf SCHED_FIFO und diesen Prozessor geben.",
    reason=("the reason of the system", "der Grund des Systems"),
)
REAL_SCHEDULE_HAS_NO_PAST = error(
    901464,
    en="a session on a real schedule cannot go back",
    de="eine Sitzung mit echtem Ablaufplan kann nicht zurück",
    remedy_en="Record it and open the tape; nctakt replay repeats the run.",
    remedy_de="Sie aufzeichnen und das Band öffnen; nctakt replay wiederholt den Lauf.",
)
SPEED_OF_REAL_SCHEDULE = error(
    901465,
    en="--speed and --rtconf must not be used together: the list gives the clock",
    de="--speed und --rtconf schließen sich aus: die Liste gibt die Uhr vor",
    remedy_en="Omit --speed.",
    remedy_de="--speed weglassen.",
)
