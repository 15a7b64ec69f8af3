# SPDX-License-Identifier: MIT
"""The forms of the ``#`` commands that are simulated, for remedies and explanations."""

from __future__ import annotations

from nctakt.base.diagnostics import NOTHING

#: Command -> examples of its forms; each is a line that a program may have.
FORMS: dict[str, tuple[str, ...]] = {
    "#BACKWARD STORAGE CLEAR": ("#BACKWARD STORAGE CLEAR",),
    "#CHANNEL INIT": ("#CHANNEL INIT", "#CHANNEL INIT [CMDPOS]", "#CHANNEL INIT [ACTPOS]"),
    "#CONTOUR MODE": (
        "#CONTOUR MODE [DEV PATH_DEV=0.1]",
        "#CONTOUR MODE ON",
        "#CONTOUR MODE OFF",
    ),
    "#CS": (
        "#CS DEF [1] [10, 0, 0, 0, 0, 30]",
        "#CS ON [1]",
        "#CS ON",
        "#CS OFF",
        "#CS OFF ALL",
    ),
    "#CS ADD": ("#CS ADD [WCS] [10, 0, 0, 0, 0, 30]",),
    "#CS SELECT": ("#CS SELECT [WCS]",),
    "#DISABLE MODAL CYCLE": ("#DISABLE MODAL CYCLE",),
    "#DELETE": ("#DELETE V.P.NAME", "#DELETE V.P."),
    "#ERROR": ("#ERROR [ID=455]", "#ERROR [ID=455 RC=2 MID=1 PV1=P1 PM1=3]"),
    "#EXPL SYN": ("#EXPL SYN",),
    "#FILE NAME": ("#FILE NAME [MSG=report.txt]",),
    "#FILENAME": ("#FILENAME [MSG=report.txt]",),
    "#FGROUP": ("#FGROUP [X, Y]", "#FGROUP"),
    "#FLUSH": ("#FLUSH", "#FLUSH WAIT", "#FLUSH CONTINUE"),
    "#KIN ID": ("#KIN ID [1]", "#KIN ID [1, NONE]", "#KIN ID"),
    "#MSG": ('#MSG ["text"]', '#MSG ["%d of %f", V.E.COUNT, P1]'),
    "#OVERRIDE": ("#OVERRIDE [FEED_FACT=50]", "#OVERRIDE [RAPID_FACT=50]"),
    "#PRESET": ("#PRESET X10",),
    "#PSET": ("#PSET X10",),
    "#SIGNAL": ("#SIGNAL [ID=5 CH=2]", "#SIGNAL SYN [ID=5 COUNT=2 P[0]=1.5 CH=2 CH=3]"),
    "#SIGNAL READ": ("#SIGNAL READ [ID=5 CH=1]", "#SIGNAL READ [ID=5 P[0]=V.P.VALUE CH=1]"),
    "#SIGNAL REMOVE": ("#SIGNAL REMOVE [ID=5]", "#SIGNAL REMOVE SYN [IDMIN=5 IDMAX=9 CH=2]"),
    "#SET SLOPE PROFIL": ("#SET SLOPE PROFIL [1]", "#SET SLOPE PROFIL"),
    "#PTP": ("#PTP ON", "#PTP OFF"),
    "#RTCP": ("#RTCP ON", "#RTCP OFF"),
    "#SLOPE": ("#SLOPE [TYPE=STEP]", "#SLOPE [TYPE=TRAPEZ]", "#SLOPE DEFAULT"),
    "#SUPPRESS OFFSETS": ("#SUPPRESS OFFSETS G00 X0",),
    "#TLC": ("#TLC ON [2.5]", "#TLC ON", "#TLC OFF"),
    "#TIME": ("#TIME 0.5", "#TIME P1"),
    "#TURN": ("#TURN [ROT_FEED_CPL=0]", "#TURN [THREAD_CHAIN=0]"),
    "#TIMER": ("#TIMER START [ID=3]", "#TIMER STOP", "#TIMER READ", "#TIMER CLEAR"),
    "#VECTOR LIMIT": (
        "#VECTOR LIMIT ON [VEL=6000 ACC=2000]",
        "#VECTOR LIMIT ON [ACC=2000 FEED]",
        "#VECTOR LIMIT ON ALL",
        "#VECTOR LIMIT OFF [ACC]",
        "#VECTOR LIMIT OFF",
    ),
    "#TRAFO": ("#TRAFO ON", "#TRAFO OFF", "#TRAFO [1]", "#TRAFO [ON, OFF]", "#TRAFO [DEFAULT]"),
    "#WAIT": ("#WAIT [ID=5 CH=1]", "#WAIT [ID=5 P[0]=V.P.VALUE CH=1]", "#WAIT SYN [ID=5 CH=1]"),
    "#WAIT FOR": ("#WAIT FOR P1 == 1",),
    "#WAIT INDP": ("#WAIT INDP [X, Y]", "#WAIT INDP ALL"),
}


def forms_of(command: str) -> str:
    """Return the forms of a command as one line."""
    return "  |  ".join(FORMS.get(command, ())) or NOTHING
