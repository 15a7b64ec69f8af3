# SPDX-License-Identifier: MIT
"""``nctakt explain`` as a user meets it."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.reference.article import WIDTH, Topic
from nctakt.reference.concepts import GERMAN_GUIDES, find_concepts
from nctakt.reference.messages import MESSAGES
from nctakt.reference.topics import TOPICS, nearest_word
from nctakt.studies.measuring.measures import read_expectation
from nctakt.testing.expectations import read_script

pytestmark = pytest.mark.slow

Captured = pytest.CaptureFixture[str]

DOCS = Path(__file__).parent.parent.parent / "docs"


def test_message(capsys: Captured) -> None:
    """RC-602: text, cause, remedy, parameters and classes of a message."""
    assert main(["explain", "22009"]) == 0
    assert capsys.readouterr().out == (
        "22009: error of the controller\n"
        "  {name} is asynchronous and cannot be written in a realtime cycle\n"
        "    Cause       An asynchronous variable is read once, when the definition is decoded, and"
        " is a\n"
        "                constant in the cycle from then on.\n"
        "    Remedy      V.E and V.CH: set synchronisation TRUE in the variables list, or use Vs."
        " for this\n                block.\n"
        "    {name}      the name\n"
        "    Effect      the program is aborted; prepared blocks are still finished; error state"
        " (class 2)\n"
        "    Cleared by  a reset of the channel (class 3)\n"
    )


@pytest.mark.parametrize("number", ["20840", "900126"])
def test_both_numbers_of_a_message(number: str, capsys: Captured) -> None:
    """RC-801: the controller's number and ours find the same message."""
    assert main(["explain", number]) == 0
    out = capsys.readouterr().out
    assert "20840: error of the controller\n" in out
    assert "Also known as  900126, 21697, 21698\n" in out


def test_a_number_of_several_messages(capsys: Captured) -> None:
    """Each message that the controller reports under one number is reported."""
    assert main(["explain", "20836"]) == 0
    out = capsys.readouterr().out
    assert out.count("20836: error of the controller\n") == 2
    assert "900128" in out
    assert "900309" in out


def test_a_number_of_a_parameter(capsys: Captured) -> None:
    """errors-map.md: what the controller says of a value in a list."""
    assert main(["explain", "110087"]) == 0
    assert capsys.readouterr().out == (
        "110087: number of the controller for a parameter\n"
        "  The controller reports it when it reads the list.\n"
        "    P-AXIS-00236 getriebe[].window  it is 0, which is not allowed\n"
    )
    assert main(["explain", "P-AXIS-00236"]) == 0
    assert "110087" in capsys.readouterr().out


def test_parameter_in_german(capsys: Captured) -> None:
    """RC-5xx: ID, name, range, unit and default of a parameter, in the language asked for."""
    assert main(["explain", "P-CHAN-00425", "--lang", "de"]) == 0
    assert capsys.readouterr().out == (
        "P-CHAN-00425 rt_cycles.max_duration: Parameter, Kanalliste\n"
        "  Anteil am CNC-Takt, den alle Echtzeit-Zyklen zusammen nutzen dürfen\n"
        "    Typ           UNS16\n"
        "    Bereich       1 … 65534\n"
        "    Einheit       %\n"
        "    Standardwert  75\n"
        "    In nctakt     wirkt\n"
    )


def test_several_words(capsys: Captured) -> None:
    """Several words are explained one after another, the same thing once."""
    assert main(["explain", "ONCE", "EDGE", "once"]) == 0
    heads = [line for line in capsys.readouterr().out.split("\n") if line and line[0] != " "]
    assert heads == ["ONCE: keyword of realtime cycles", "EDGE: keyword of realtime cycles"]


def test_command_of_two_words(capsys: Captured) -> None:
    """A # command may be given as one argument or as its words."""
    assert main(["explain", "#RT CYCLE"]) == 0
    together = capsys.readouterr().out
    assert main(["explain", "#RT", "CYCLE"]) == 0
    assert capsys.readouterr().out == together
    assert main(["explain", "ONCE", "#RT", "CYCLE", "#FLUSH", "G01"]) == 0
    heads = [line for line in capsys.readouterr().out.split("\n") if line and line[0] != " "]
    assert [head.split(":")[0] for head in heads] == ["ONCE", "#RT CYCLE", "#FLUSH", "G01"]


def test_misspelt(capsys: Captured) -> None:
    """An unknown word suggests the nearest; the known ones are explained all the same."""
    assert main(["explain", "SQRTT", "MOD"]) == 2
    captured = capsys.readouterr()
    assert captured.out.startswith("MOD: operator between two values\n")
    assert "error 900571: unknown topic 'SQRTT'" in captured.err
    assert "Did you mean SQRT?" in captured.err


def test_unknown(capsys: Captured) -> None:
    """A word like nothing that is known says how to find out what is."""
    assert main(["explain", "@@@", "--lang", "de"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("Fehler 900570: unbekanntes Stichwort '@@@'")


def test_topics(capsys: Captured) -> None:
    """Without words the topics are listed, each with examples that can be explained."""
    assert main(["explain"]) == 0
    reported = capsys.readouterr().out
    for topic in TOPICS:
        assert f"  {topic.word} " in reported
        for example in topic.examples:
            assert main(["explain", example.strip("'\"")]) == 0


@pytest.mark.parametrize("topic", TOPICS, ids=lambda topic: topic.word)
def test_topic_lists_its_words(topic: Topic, capsys: Captured) -> None:
    """The name of a topic lists all that it knows, one line each."""
    word = topic.word
    assert main(["explain", word]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == len(list(topic.articles()))


@pytest.mark.nightly
def test_lines_are_short(capsys: Captured) -> None:
    """No line is wider than a terminal of 100 columns unless a word is."""
    numbers = [article.name for article in MESSAGES.articles()]
    assert main(["explain", *numbers]) == 0
    assert all(len(line) <= WIDTH for line in capsys.readouterr().out.splitlines())


@pytest.mark.parametrize(
    ("word", "head"),
    [
        ("hli_axis", "hli_axis: structure of the interface to the PLC"),
        ("hli_axis.command", "hli_axis.command: value of the interface to the PLC"),
        ("PATH_SPEED", "hli_channel.path_speed: value of the interface to the PLC"),
        ("HLI.OVERRIDE", "hli_command.override: value of the interface to the PLC"),
        ("HLI.S2.OVERRIDE", "hli_spindle_command.override: value of the interface to the PLC"),
        ("rc-105", "RC-105: rule of realtime cycles"),
        ("RC-001", "RC-001: rule of realtime cycles"),
        ("V.E.CONDITION", "V.E.CONDITION: variable of the machine demo"),
        ("Vs.e.condition", "V.E.CONDITION: variable of the machine demo"),
    ],
)
def test_the_hli_rules_and_the_machines_variables(word: str, head: str, capsys: Captured) -> None:
    """Names of the HLI, numbers of rules, variables with their declaration."""
    assert main(["explain", word]) == 0
    assert capsys.readouterr().out.split("\n")[0] == head


@pytest.mark.parametrize(
    ("word", "head"),
    [
        (
            "gpCh[1]^.bahn_state.program_end_r",
            "gpCh[1]^.bahn_state.program_end_r: element of the interface to the PLC",
        ),
        (
            "HLI_Global_Variables.gpAx[0]^.ipo_mc_control.override.command_w",
            "gpAx[0]^.ipo_mc_control.override.command_w: element of the interface",
        ),
        ("backward_storage_off", "gpCh[]^.bahn_mc_control.backward_storage_off: element of"),
        ("mc_control_bool_unit", "MC_CONTROL_BOOL_UNIT: structure of the interface"),
        ("HLI_IMCM_MDI_MODE", "HLI_IMCM_MDI_MODE: constant of the PLC's library"),
        ("MC_Halt", "MC_Halt: function block of the PLC's library"),
    ],
)
def test_the_interface_as_the_controller_names_it(word: str, head: str, capsys: Captured) -> None:
    """Paths with any index, elements by their last name, structures, constants, blocks."""
    assert main(["explain", word]) == 0
    assert capsys.readouterr().out.startswith(head)


def test_an_unknown_path_suggests_the_nearest_and_a_part_finds_all(capsys: Captured) -> None:
    """902100 names what is unknown; a part of a name lists the elements that have it."""
    assert main(["explain", "gpCh[0]^.bahn_state.programm_end_r"]) == 2
    assert "Did you mean gpCh[0]^.bahn_state.program_end_r?" in capsys.readouterr().err
    assert main(["explain", "dyn_pos_lim"]) == 0
    assert "gpAx[]^.ipo_mc_control.dyn_pos_limit_low " in capsys.readouterr().out


@pytest.mark.parametrize("word", ["V.E", "vs.e"])
def test_a_family_lists_the_variables_of_the_machine(word: str, capsys: Captured) -> None:
    """Each on a line, after the article of the family."""
    assert main(["explain", word]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "V.E: variables"
    assert any(line.split() == "V.E.CONDITION a variable of channel 1".split() for line in lines)
    assert not any("V.CH." in line for line in lines)


def test_a_variable_of_another_machine(capsys: Captured, tmp_path: Path) -> None:
    """``--machine`` says whose; an unknown one is reported with the nearest (900541, 901006)."""
    assert main(["new", str(tmp_path / "m"), "--quiet"]) == 0
    assert main(["explain", "V.E.CONDITIO", "--machine", str(tmp_path / "m")]) == 2
    reported = capsys.readouterr().err
    assert "Did you mean V.E.CONDITION?" in reported
    assert "901006" not in reported
    assert main(["explain", "V.E.CONDITIO"]) == 2
    assert "901006" in capsys.readouterr().err


def test_a_word_without_an_article_is_searched_in_all_texts(capsys: Captured) -> None:
    """Names and meanings first; those that are too many are counted."""
    assert main(["explain", "cannot be written"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("'cannot be written' appears in ")
    assert any(line.startswith("22009 ") for line in lines)
    assert main(["explain", "gleich", "--lang", "de"]) == 0
    assert capsys.readouterr().out.startswith("'gleich' steht in ")


@pytest.mark.parametrize(
    ("words", "head"),
    [
        ("Z", "axis letters: subject"),
        ("gate", "reaction: subject"),
        ("override", "override: subject"),
        ("M100", "M: word"),
        ("waiting", "waiting: subject"),
        ("expect", "expect: subject"),
        ("expectations", "expect: subject"),
        ("why does my program wait", "waiting: subject"),
        ("gpCh", "interface: subject"),
        ("Was ist ein Zyklus", "realtime cycle: subject"),
        ("Wie warte ich auf die Position", "waiting: subject"),
        ("Wie verbinde ich TwinCAT", "connection: subject"),
        ("Wie schreibe ich eine Schleife", "loop: subject"),
        ("Referenzfahrt", "homing: subject"),
        ("Meldung ausgeben", "message: subject"),
        ("Kommentar", "comment: subject"),
        ("Was bedeutet Fehler 22009", "22009: error of the controller"),
        ("worauf wartet die Achse", "axis letters: subject"),
        ("Wartezeit", "waiting: subject"),
        ("how do I set a variable", "variable: subject"),
        ("wie lange dauert das Programm", "machining time: subject"),
        ("wo sind meine Listen", "lists: subject"),
        ("feed hold", "feed hold: subject"),
        ("Echtzeitzyklus", "realtime cycle: subject"),
        ("Spindel", "spindle: subject"),
        ("single block", "single block: subject"),
        ("Schutztür", "reaction: subject"),
        ("Warum bleibt das Programm stehen", "waiting: subject"),
        ("Satzvorlauf", "block search: subject"),
        ("backward_motion", "hli_command.backward_motion: value of the interface"),
    ],
)
def test_what_people_ask_for(words: str, head: str, capsys: Captured) -> None:
    """Words and questions in both languages; what is about the subject comes first."""
    assert main(["explain", *words.split()]) == 0
    assert capsys.readouterr().out.startswith(head)


def test_the_examples_of_expectations_can_be_read() -> None:
    """What ``explain expect`` shows are inputs and expectations that a test takes."""
    (article,) = find_concepts("expect")
    for fact in article.facts[:2]:
        parts = [part for line in fact.value.en.splitlines() for part in line.split("    ")]
        script = read_script(Path("p.nc"), "".join(f"{part}\n" for part in parts) + "M30\n")
        assert script.expectations or script.assignments
    (in_plans,) = (fact.value.en for fact in article.facts if fact.label.en == "In plans")
    assert [read_expectation(text, {}).text for text in in_plans.splitlines()]


@pytest.mark.parametrize(
    ("word", "first"), [("2200", "2"), ("G1234", "G"), ("P-CHAN-9", "P-"), ("RC-1055", "RC-")]
)
def test_a_misspelt_word_is_like_its_family_only(word: str, first: str) -> None:
    """A number is no parameter, a G function no message."""
    near = nearest_word(word)
    assert near == "" or near.startswith(first)


@pytest.mark.parametrize(
    ("words", "language", "head"),
    [
        (
            "stop at the end of the block: no motion follows at once",
            "en",
            "stop at the end of the block: no motion follows at once: word of nctakt time\n",
        ),
        ("corner before line 7", "en", "corner: word of nctakt time\n"),
        ("acceleration of axis X", "en", "acceleration: word of nctakt time\n"),
        ("zwischen Sätzen", "de", "zwischen Sätzen: Wort von nctakt time\n"),
        ("Genauhalt am Ende von Zeile 7", "de", "Genauhalt: Wort von nctakt time\n"),
        ("Echtzeitzyklus", "de", "Echtzeit-Zyklus: Thema\n"),
    ],
)
def test_words_that_time_prints(words: str, language: str, head: str, capsys: Captured) -> None:
    """Each is explained, also with its line or axis; the head speaks the language of the answer."""
    for asked in ([words], words.split()):
        assert main(["explain", *asked, "--lang", language]) == 0
        assert head in capsys.readouterr().out


def test_german_answers_name_german_guides(capsys: Captured) -> None:
    """Guides in both languages are named in that of the answer."""
    assert main(["explain", "Echtzeitzyklus", "--lang", "de"]) == 0
    assert "docs/why.de.md" in capsys.readouterr().out
    assert main(["explain", "Echtzeitzyklus"]) == 0
    assert "docs/why.md" in capsys.readouterr().out
    german = {path.name.removesuffix(".de.md") for path in DOCS.glob("*.de.md")}
    assert german == GERMAN_GUIDES
