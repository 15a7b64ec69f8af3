# SPDX-License-Identifier: MIT
"""Slips in the form of a line: operators, brackets, numbers and words written as elsewhere.

In: nothing. Out: ``FORM_SLIPS``. A row applies only to a line in which parser or checker have found
a mistake, so that nothing valid is ever reported.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from nctakt.base.diagnostics import Message
from nctakt.base.misspelling import nearest
from nctakt.messages.programs.slips import (
    ARGUMENTS_WITHOUT_BRACKETS,
    BODY_BEHIND_CONDITION,
    BODY_BEHIND_THEN,
    COMMENT_OF_OTHER_LANGUAGE,
    COMPARISON_AS_ASSIGNMENT,
    CURLY_BRACKETS,
    DECIMAL_COMMA,
    EQUALS_IN_CONDITION,
    FUNCTION_WITHOUT_BRACKETS,
    KEYWORDS_WITHOUT_EQUALS,
    LETTER_IN_NUMBER,
    MISSPELT_FREQUENCY,
    NAME_OF_INTERFACE,
    OPERATOR_OF_OTHER_LANGUAGE,
    POINT_MISSING_IN_NAME,
    ROUND_BRACKETS,
    SEPARATOR_IN_FOR,
    SIGN_MISSING_BEFORE_WORD,
    STEP_OPERATOR,
    SURPLUS_WORD,
    UNIT_BEHIND_VALUE,
    WORD_FOR_CYCLE_COMMAND,
    WORD_INSIDE_BRACKETS,
)

#: Where a slip is, its message, and the text for the group ``wrong`` of the pattern.
FormSlip = tuple[re.Pattern[str], Message, Callable[[re.Match[str]], str]]

_OPERATORS = {
    "AND": "&&",
    "OR": "||",
    "EQ": "==",
    "NE": "!=",
    "GT": ">",
    "LT": "<",
    "GE": ">=",
    "LE": "<=",
    "=>": ">=",
    "=<": "<=",
    "<>": "!=",
    ":=": "=",
    "%": "MOD",
    "===": "==",
    "!": "NOT",
    "!==": "!=",
}
_CYCLE_COMMANDS = {
    "DEL": "DELETE",
    "KILL": "DELETE",
    "REMOVE": "DELETE",
    "STOP": "HOLD",
    "PAUSE": "HOLD",
    "RESUME": "CONTINUE",
    "ABORT": "ABORT ACTION",
}
_FREQUENCIES = ("ONCE", "EDGE", "ALWAYS")
_OTHER_FREQUENCIES = {
    "RISING": "EDGE",
    "POSEDGE": "EDGE",
    "R_TRIG": "EDGE",
    "TRIGGER": "EDGE",
    "FIRST": "ONCE",
    "ON": "ONCE",
    "ONES": "ONCE",
    "EVERY": "ALWAYS",
    "CYCLIC": "ALWAYS",
}
_DECLARED = r"(?:P\w+|Vs?\.\w+(?:\.\w+|\[[^\]]*\])*)"
_HEAD = r"^\s*(?:/\d*\s*)?(?:N\d+\s*:?\s*)?"
_CONDITION = r"[$#](?:IF|ELSEIF|WHILE|UNTIL|ENDDO)\b"
_ANGLES = "SIN|COS|TAN|ASIN|ACOS|ATAN|ABS|SQRT|SQR|EXP|LN|INT|FRACT|ROUND|DEG|RAD"


def _operator(match: re.Match[str]) -> str:
    return _OPERATORS[match["wrong"].upper()]


def _bracketed(match: re.Match[str]) -> str:
    return f"[{match['wrong'].strip()}]"


def _frequency(match: re.Match[str]) -> str:
    word = match["wrong"].upper()
    return _OTHER_FREQUENCIES.get(word) or nearest(word, _FREQUENCIES)


def _comment(match: re.Match[str]) -> str:
    return f"; {match['text'].strip()}".rstrip()


def _row(
    pattern: str, message: Message, replacement: str | Callable[[re.Match[str]], str]
) -> FormSlip:
    compiled = re.compile(pattern, re.IGNORECASE)
    if callable(replacement):
        return compiled, message, replacement
    template: str = replacement
    return compiled, message, lambda match: match.expand(template)


#: In the order in which they are tried; ``wrong`` is the part shown and replaced.
FORM_SLIPS: tuple[FormSlip, ...] = tuple(
    _row(pattern, message, replacement)
    for pattern, message, replacement in (
        (r"(?P<wrong>//(?P<text>.*))$", COMMENT_OF_OTHER_LANGUAGE, _comment),
        (r"(?P<wrong>/\*(?P<text>.*?)(?:\*/|$))", COMMENT_OF_OTHER_LANGUAGE, _comment),
        (r"\$\w+\s*(?P<wrong>\{[^{}]*\})", CURLY_BRACKETS, ""),
        (r"(?P<wrong>[{}])", CURLY_BRACKETS, ""),
        (
            r"#\s*RT\s+CYCLE\b[^\[]*\[.*?"
            r"(?P<wrong>(?:ID|SCOPE)\s+\w+(?:\s+(?:ID|SCOPE)[\s=]\s*\w+)*)",
            KEYWORDS_WITHOUT_EQUALS,
            lambda match: re.sub(r"(?i)(ID|SCOPE)\s+", r"\1=", match["wrong"]),
        ),
        (
            rf"{_HEAD}(?P<wrong>IF|ELSE|ELSEIF|ENDIF|WHILE|ENDWHILE|FOR|ENDFOR|GOTO|SWITCH|CASE"
            r"|ENDSWITCH|REPEAT|UNTIL|ENDDO|BREAK|CONTINUE)\b(?!\s*=).*$",
            SIGN_MISSING_BEFORE_WORD,
            lambda match: "$" + match["wrong"].upper(),
        ),
        (
            rf"{_HEAD}(?P<wrong>RT\s+CYCLE|MSG|FLUSH|TIMER|VAR|ENDVAR|COMMENT)\b(?!\s*=).*$",
            SIGN_MISSING_BEFORE_WORD,
            r"#\g<wrong>",
        ),
        (
            r"(?P<wrong>(?<!\w)(?:AND|OR|EQ|NE|GT|LT|GE|LE)(?!\w))",
            OPERATOR_OF_OTHER_LANGUAGE,
            _operator,
        ),
        (r"(?P<wrong>=>|=<|<>|:=|[=!]==)", OPERATOR_OF_OTHER_LANGUAGE, _operator),
        (
            r"(?:[-+*/=<>&|^\[,]|\$\w+|\b(?:ONCE|EDGE|ALWAYS|NOT))\s*(?P<wrong>!)\s*[\w\[]",
            OPERATOR_OF_OTHER_LANGUAGE,
            "NOT ",
        ),
        (r"[\w\]]\s*(?P<wrong>%)\s*[\w\[]", OPERATOR_OF_OTHER_LANGUAGE, _operator),
        (
            rf"(?P<wrong>(?P<name>{_DECLARED})\s*(?P<sign>[+-])(?P=sign))",
            STEP_OPERATOR,
            r"\g<name> \g<sign>= 1",
        ),
        (
            rf"{_HEAD}(?P<wrong>(?P<sign>[+-])(?P=sign)\s*(?P<name>{_DECLARED}))",
            STEP_OPERATOR,
            r"\g<name> \g<sign>= 1",
        ),
        (
            r"(?<![\w.])(?P<wrong>(?P<begin>Vs?)[,\-]?(?P<space>E|P|L|S|CH|CYC|RTA|RTG|A|G)"
            r"(?P<rest>\.\w+(?:\.\w+)*))",
            POINT_MISSING_IN_NAME,
            r"\g<begin>.\g<space>\g<rest>",
        ),
        (
            r"(?<![\w.])(?P<wrong>(?:HLI|gp\w+\s*\[[^\]]*\]\^?)(?:\.\w+(?:\[[^\]]*\])?)+)",
            NAME_OF_INTERFACE,
            "",
        ),
        (
            r"\d(?P<wrong>\s?(?:mm(?:/(?:min|s))?|m/min|in(?:ch)?|rpm|U/min|deg|ms|s|°))(?![\w.])",
            UNIT_BEHIND_VALUE,
            "",
        ),
        (r"\$GOTO\s+(?P<wrong>\d+)", SIGN_MISSING_BEFORE_WORD, r"N\g<wrong>"),
        (
            rf"{_CONDITION}.*?(?<![=<>!+\-*/:])(?P<wrong>=)(?!=)",
            EQUALS_IN_CONDITION,
            "==",
        ),
        (rf"{_HEAD}{_DECLARED}\s*(?P<wrong>==)", COMPARISON_AS_ASSIGNMENT, "="),
        (
            r"\$(?:IF|ELSEIF)\s+(?P<wrong>EDG|EDGES|EGDE|EDEG|EGE|EDGEE|ONES?|ONC|ONEC|ALWAY"
            rf"|ALLWAYS|ALWYAS|{'|'.join(_OTHER_FREQUENCIES)})\b.*$",
            MISSPELT_FREQUENCY,
            _frequency,
        ),
        (
            r"\$(?:IF|ELSEIF)\b.*\s(?P<wrong>THEN\s+(?P<body>\S.*?))\s*$",
            BODY_BEHIND_THEN,
            lambda match: re.sub(r"(?i)\s*\$ENDIF$", "", match["body"]),
        ),
        (r"\$(?:IF|ELSEIF)\b.*\s(?P<wrong>THEN)\b", SURPLUS_WORD, ""),
        (r"\$(?:WHILE|FOR)\b.*\s(?P<wrong>DO)\s*$", SURPLUS_WORD, ""),
        (r"\$FOR\b.*(?P<wrong>\s+(?:TO|DOWNTO|STEP|BY)\b)", SEPARATOR_IN_FOR, ","),
        (
            r"(?<!\w)[A-Z]*(?P<wrong>\d+,\d+)",
            DECIMAL_COMMA,
            lambda match: match["wrong"].replace(",", "."),
        ),
        (r"(?<=\d)(?P<wrong>[OQ])(?![A-Z])", LETTER_IN_NUMBER, "0"),
        (r"(?<=\d)(?P<wrong>[lI])(?![A-Z])", LETTER_IN_NUMBER, "1"),
        (
            r"(?:[-=+*/\[]|(?<!\w)\$?[A-Z]\w*)\s*(?P<wrong>\((?P<inner>[\s\w.+\-*/\[\]<>=&|!,]+)\))\s*.?",
            ROUND_BRACKETS,
            r"[\g<inner>]",
        ),
        (
            rf"(?<!\w)(?P<wrong>(?P<name>{_ANGLES})\s+(?P<value>[\w.]+))",
            FUNCTION_WITHOUT_BRACKETS,
            r"\g<name>[\g<value>]",
        ),
        (r"#\s*RT\s+CYCLE\s*(?P<wrong>\[\s*DEF\s+)", WORD_INSIDE_BRACKETS, "DEF ["),
        (
            r"#\s*RT\s+CYCLE\s+(?P<wrong>DEL|KILL|REMOVE|STOP|PAUSE|RESUME|ABORT)(?!\w)",
            WORD_FOR_CYCLE_COMMAND,
            lambda match: _CYCLE_COMMANDS[match["wrong"].upper()],
        ),
        (
            r"#[A-Z ]+?\s(?P<wrong>\w+\s*=\s*[\w.]+(?:\s+\w+\s*=\s*[\w.]+)*)",
            ARGUMENTS_WITHOUT_BRACKETS,
            _bracketed,
        ),
        (
            r"(?<!\w)[XYZABCUVW]\s+(?P<wrong>INDP\w*\b[^;(]*)",
            ARGUMENTS_WITHOUT_BRACKETS,
            _bracketed,
        ),
        (
            rf"{_CONDITION}.*?[\s\]](?P<wrong>[MHGTXYZ]\d+|{_DECLARED}\s*[-+*/]?=(?!=))",
            BODY_BEHIND_CONDITION,
            r"\g<wrong>",
        ),
    )
)
