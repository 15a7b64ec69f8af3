# SPDX-License-Identifier: MIT
"""Messages about suites of unit tests in Structured Text (ST-901 … ST-904)."""

from __future__ import annotations

from nctakt.messages.catalogue import error
from nctakt.messages.extras import install_command

_NAME = ("name of the test", "Name des Tests")
_SUITE = ("path of the suite", "Pfad der Suite")
_TIME = ("time of the run", "Zeit des Laufs")

TEST_UNFINISHED = error(
    902540,
    en="{name} in {suite} has not ended after {time}",
    de="{name} in {suite} ist nach {time} nicht beendet",
    remedy_en="Let each path through the test reach TEST_FINISHED.",
    remedy_de="Jeden Weg durch den Test bis TEST_FINISHED führen.",
    name=_NAME,
    suite=_SUITE,
    time=_TIME,
)
NOTHING_TESTED = error(
    902541,
    en="no tests in {paths}",
    de="keine Tests in {paths}",
    remedy_en="Name files or folders with expectations, suites or Python tests; nctakt init writes "
    "a first one.",
    remedy_de="Dateien oder Ordner mit Erwartungen, Suiten oder Python-Tests nennen; nctakt init "
    "schreibt einen ersten.",
    paths=("the files and folders", "die Dateien und Ordner"),
)
NOTHING_CHOSEN = error(
    902961,
    en="no test in {paths} has a name that fits -k {expression}",
    de="kein Test in {paths} hat einen Namen, der zu -k {expression} passt",
    remedy_en="nctakt test -- --collect-only shows the names of all tests.",
    remedy_de="nctakt test -- --collect-only zeigt die Namen aller Tests.",
    paths=("the files and folders", "die Dateien und Ordner"),
    expression=("the words of -k", "die Wörter von -k"),
)
OUTSIDE_OF_TESTS = error(
    902542,
    en="this does not belong to a test: none has been opened",
    de="das gehört zu keinem Test: keiner ist eröffnet",
    remedy_en="Call TEST before it, in a suite that TcUnit.RUN calls.",
    remedy_de="Vorher TEST aufrufen, in einer Suite, die TcUnit.RUN aufruft.",
)
TEST_NAME_TWICE = error(
    902543,
    en="{suite} opens {name} twice in one cycle: assertions of the second do not count",
    de="{suite} eröffnet {name} zweimal in einem Zyklus: Prüfungen des zweiten zählen nicht",
    remedy_en="Give each test of the suite a different name.",
    remedy_de="Jedem Test der Suite einen eigenen Namen geben.",
    name=_NAME,
    suite=_SUITE,
)
UNKNOWN_TEST_FINISHED = error(
    902544,
    en="{name} is not a test of the suite; the suites end here",
    de="{name} ist kein Test der Suite; die Suiten enden hier",
    remedy_en="Pass TEST_FINISHED_NAMED the name that TEST has.",
    remedy_de="TEST_FINISHED_NAMED den Namen geben, den TEST hat.",
    name=_NAME,
)
TOO_MANY_TESTS = error(
    902545,
    en="more suites or tests than one run holds: 1000 suites, 5000 tests",
    de="mehr Suiten oder Tests, als ein Lauf fasst: 1000 Suiten, 5000 Tests",
    remedy_en="Split them among several projects.",
    remedy_de="Auf mehrere Projekte verteilen.",
)
SUITE_NOT_CALLED = error(
    902546,
    en="no task calls {suite}",
    de="keine Task ruft {suite} auf",
    remedy_en="Call TcUnit.RUN() in each cycle of a program of a task.",
    remedy_de="TcUnit.RUN() in jedem Zyklus eines Programms einer Task aufrufen.",
    suite=_SUITE,
)
PYTEST_MISSING = error(
    902547,
    en="pytest, which runs the tests, is not installed",
    de="pytest, das die Tests ausführt, ist nicht installiert",
    remedy_en=f"Install it: {install_command('pytest')}",
    remedy_de=f"Installieren: {install_command('pytest')}",
)
OTHER_TEST_LIBRARY = error(
    902911,
    en="these sources of TcUnit store their results in a form that nctakt does not know",
    de="diese Quellen von TcUnit halten Ergebnisse auf eine Art, die nctakt nicht kennt",
    remedy_en="Remove them from [plc] libraries, for the TcUnit of nctakt, or take newer ones.",
    remedy_de="Sie aus [plc] libraries entfernen, für das TcUnit von nctakt, oder neuere nehmen.",
)
