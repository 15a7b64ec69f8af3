# SPDX-License-Identifier: MIT
"""Articles: complete, in both languages, found by every usual spelling of their word."""

from __future__ import annotations

from typing import get_args

import pytest

from nctakt.base.diagnostics import Text
from nctakt.nc import tree
from nctakt.nc.check.cycles import realtime_cycles
from nctakt.nc.parse import hash_commands
from nctakt.nc.vocabulary.keywords import KEYWORDS
from nctakt.nc.vocabulary.single_axes import axis_commands
from nctakt.nc.vocabulary.variables.realtime_variables import AXIS_VARIABLES, CHANNEL_VARIABLES
from nctakt.reference.article import Article, Topic
from nctakt.reference.topics import TOPICS, explain, nearest_word

pytestmark = pytest.mark.slow

EVERY = [article for topic in TOPICS for article in topic.articles()]


def texts(article: Article) -> list[Text]:
    labels = [fact.label for fact in article.facts]
    return [article.kind, article.meaning, *labels, *(fact.value for fact in article.facts)]


@pytest.mark.parametrize("topic", TOPICS, ids=lambda topic: topic.word)
def test_articles_are_complete(topic: Topic) -> None:
    """Each article has its texts in English and German."""
    articles = [*topic.articles()]
    assert articles
    for article in articles:
        for text in texts(article):
            assert text.en, article.name
            assert text.de, article.name


#: How many articles of a topic are looked for.
EACH_TOPIC = 150


@pytest.mark.nightly
@pytest.mark.parametrize("topic", TOPICS, ids=lambda topic: topic.word)
def test_each_article_is_found_by_its_name(topic: Topic) -> None:
    """What a topic lists can be asked for, and so can each name that is suggested.

    Of long topics some articles are enough: all of one topic are found by the same table.
    """
    articles = [*topic.articles()]
    for article in articles[:: max(1, len(articles) // EACH_TOPIC)]:
        word = article.name.split()[0] if topic.word == "parameters" else article.name
        assert article in explain(word), article.name
    names = sorted(topic.names())
    for name in names[:: max(1, len(names) // EACH_TOPIC)]:
        assert explain(name), name


def test_keywords_are_those_that_the_checker_knows() -> None:
    """RC-101 … RC-111, RC-203: the explained keywords are those that are accepted."""
    accepted = {
        *realtime_cycles.SCOPES,
        *realtime_cycles.END_ACTIONS,
        *hash_commands.CYCLE_ACTIONS,
        *get_args(tree.Frequency),
        *("ID", "SCOPE", "END_ACTION", "DEF"),
        *(word for word in axis_commands.KEYWORDS if word[0] != "G"),
        *axis_commands.OFFSETS,
        *axis_commands.DIRECTIONS,
    }
    assert accepted <= KEYWORDS.keys()
    assert sorted(set(KEYWORDS) - accepted) == ["Vs."]


def test_realtime_variables_are_explained_with_their_rights() -> None:
    """RC-303: each variable of the access tables has an article; what has no access has none."""
    for row in (*CHANNEL_VARIABLES, *AXIS_VARIABLES):
        family = "RTG" if row in CHANNEL_VARIABLES else "RTA"
        found = explain(f"V.{family}.{row.path}")
        named = [article for article in found if article.name.startswith(f"V.{family}.")]
        assert len(named) == (1 if row.decoder or row.cycle else 0), row.path


def facts(word: str) -> dict[str, str]:
    (article,) = explain(word)
    return {fact.label.en: fact.value.en for fact in article.facts}


def test_rights_per_context() -> None:
    """RC-303: MEAS_DELTA is for programs only, the path override is written by cycles only."""
    assert facts("V.RTG.MEAS_DELTA")["In realtime cycles"] == "no access"
    assert facts("V.RTG.OVERRIDE.VEL.CYCLE")["In realtime cycles"].startswith("read and write")
    assert facts("V.RTG.OVERRIDE.VEL.CYCLE")["In programs"].startswith("read;")
    assert facts("V.RTG.OVERRIDE.VEL.TOTAL")["In realtime cycles"].startswith("read;")


def test_a_family_names_its_variables() -> None:
    """Whoever looks for a variable begins with its family; what it lacks is refused."""
    assert facts("V.RTG")["Known here"].startswith("V.RTG.OVERRIDE.VEL.CYCLE, V.RTG.OVERRIDE.")
    assert "V.RTA.ACS.ACT_POS.<X>" in facts("V.RTA")["Known here"]
    assert "V.A.ABS.X, V.A.PROG.X" in facts("V.A")["Known here"]
    assert facts("V.A")["Others"].startswith("refused")
    assert facts("V.RTG")["In nctakt"] == "simulated"
    assert "Known here" not in facts("V.P")


@pytest.mark.parametrize(
    ("word", "name"),
    [
        ("22009", "22009"),
        ("50930", "50939"),
        ("P-CHAN-00425", "P-CHAN-00425 rt_cycles.max_duration"),
        ("p-chan-00425", "P-CHAN-00425 rt_cycles.max_duration"),
        ("rt_cycles.max_duration", "P-CHAN-00425 rt_cycles.max_duration"),
        ("rt_cycles.enable", "P-CHAN-00406 configuration.rt_cycles.enable"),
        ("V.RTA.ACS.ACT_POS.X", "V.RTA.ACS.ACT_POS.<X>"),
        ("V.RTA.ACS.ACT_POS", "V.RTA.ACS.ACT_POS.<X>"),
        ("v.rta.acs.act_pos.c2", "V.RTA.ACS.ACT_POS.<X>"),
        ("V.A.ABS.Z", "V.A.ABS.X"),
        ("V.A.ACT_POS[2]", "V.A.ACT_POS.X"),
        ("V.G.NP[7].V.Y", "V.G.NP[1].V.X"),
        ("V.G.NP[7].V[0]", "V.G.NP[1].V.X"),
        ("V.RTG.TIMER[3]", "V.RTG.TIMER[i]"),
        ("Vs.RTG.TIMER", "V.RTG.TIMER[i]"),
        ("#RT CYCLE", "#RT CYCLE"),
        ("#rt  cycle", "#RT CYCLE"),
        ("G1", "G01"),
        ("g01", "G01"),
        ("G001", "G01"),
        ("M30", "M30"),
        ("M110", "M"),
        ("H5", "H"),
        ("$ENDIF", "$IF"),
        ("$ELSEIF", "$IF"),
        ("$UNTIL", "$REPEAT"),
        ("$CASE", "$SWITCH"),
        ("P10", "P"),
        ("V.E.COUNT", "V.E"),
        ("Vs.CH.COUNT[2].VALUE", "V.CH"),
        ("sqrt", "SQRT"),
        ("SIN[V.E.ANGLE]", "SIN"),
        ("MOD", "MOD"),
        ("**", "**"),
        ("PI", "PI"),
        ("once", "ONCE"),
        ("MVS_SVS", "MVS_SVS"),
        ("#RT CYCLE DELETE", "#RT CYCLE"),
        ("P-CHAN-425", "P-CHAN-00425 rt_cycles.max_duration"),
        ("chan-425", "P-CHAN-00425 rt_cycles.max_duration"),
        ("00425", "P-CHAN-00425 rt_cycles.max_duration"),
        ("vb_max", "P-AXIS-00212 getriebe[0..5].dynamik.vb_max"),
        ("vb_max", "P-TOOL-00014 wz[0..200].vb_max"),
        ("GETRIEBE.DYNAMIK.VB_MAX", "P-AXIS-00212 getriebe[0..5].dynamik.vb_max"),
        ("m_synch", "P-CHAN-00041 m_synch[0..999]"),
        ("array_size", "P-EXTV-00007 var[0..65534].array_elements"),
        ("fb_storage_size", "P-STUP-00033 fb_storage_size[0..11]"),
    ],
)
def test_usual_spellings(word: str, name: str) -> None:
    """A word is found in any letter case, with or without axis, index and leading zeros."""
    assert name in [article.name for article in explain(word)]


@pytest.mark.parametrize("word", ["", "22008", "XYZZY", "P-CHAN-99999", "V.RTA.ACS.NOWHERE.X", "²"])
def test_unknown_words(word: str) -> None:
    """What nobody knows has no article."""
    assert explain(word) == ()


@pytest.mark.parametrize(
    ("word", "near"),
    [
        ("V.RTA.ACS.ACT_PSO", "V.RTA.ACS.ACT_POS"),
        ("P-CHAN-0425", "P-CHAN-00425"),
        ("rt_cycles.max_durration", "rt_cycles.max_duration"),
        ("#RT CYLCE", "#RT CYCLE"),
        ("SQRTT", "SQRT"),
        ("ALLWAYS", "ALWAYS"),
        ("@@@", ""),
    ],
)
def test_misspelt_words_suggest_the_nearest(word: str, near: str) -> None:
    """A misspelt word suggests what it is most like."""
    assert nearest_word(word) == near


def test_operators_and_cases_share_a_word() -> None:
    """A word with two meanings is explained with both."""
    assert [article.kind.en for article in explain("-")] == [
        "operator before a value",
        "operator between two values",
    ]
