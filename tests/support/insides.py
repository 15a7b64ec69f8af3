# SPDX-License-Identifier: MIT
"""What tests see of a controller and a session that their users do not: nobody else reaches in."""

from __future__ import annotations

from nctakt.run.assembly import AssembledMachine
from nctakt.run.controller import Controller
from nctakt.run.tick_loop import TickLoop
from nctakt.session.session import Session
from nctakt.session.story import Story


def machine_of(controller: Controller) -> AssembledMachine:
    """The machine that a controller runs."""
    return controller._machine


def loop_of(controller: Controller) -> TickLoop:
    """The loop in which a controller runs ticks."""
    return controller._loop


def story_of(session: Session) -> Story:
    """What turns the commands of a session into effects."""
    return session._story
