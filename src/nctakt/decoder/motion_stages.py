# SPDX-License-Identifier: MIT
"""The stages after the decoder that change motions, in sequence.

Shapes of several blocks, then the compensation of the tool's radius, then the curves of contoured
corners. Each holds motions until it knows the next one; held commands count as executed.
"""

from __future__ import annotations

from collections.abc import Callable, Generator

from nctakt.decoder import tilted_motions
from nctakt.decoder.blocks.path.path_motion import PathMotion
from nctakt.decoder.compensation import Compensation
from nctakt.decoder.shapes.contouring import Contouring
from nctakt.decoder.shapes.shaping import Shaping
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values


class MotionStages:
    """The stages of one program; ``pass_time`` is called once for each command that takes time."""

    def __init__(
        self, values: Values, path: PathMotion, pass_time: Callable[[Command], None]
    ) -> None:
        self._environment = values.environment
        self._pass_time = pass_time
        self._shaping = Shaping(values, path, pass_time)
        self.compensation = Compensation(values, path, self._behind_shaping)
        self._contouring = Contouring(values, path, self._behind_compensation, self.compensation)

    @property
    def needs_next(self) -> bool:
        """Whether the next motion shapes the held one."""
        return self._shaping.needs_next or self._contouring.needs_next

    @property
    def is_idle(self) -> bool:
        """Whether no stage holds a motion, so that commands pass at once."""
        stages = (self._shaping, self.compensation, self._contouring)
        return all(stage.is_idle for stage in stages)

    def run(self, commands: Generator[Command, Answer]) -> Generator[Command, Answer]:
        """Yield the commands of a program with its motions changed; raises ``DecodeError``."""
        shaped = self._shaping.shape(commands)
        return self._contouring.contour(self.compensation.compensate(shaped))

    def loop_body(self, body: list[Command]) -> list[Command]:
        """Return the commands of a realtime loop's body with its motions changed."""
        shaped = self._shaping.shape_body(body)
        whole = tilted_motions.all_out_of_plane(shaped, self._environment)
        return self._contouring.plain_body(whole)

    def pass_time(self, command: Command) -> None:
        """Note that the consumer has taken a command that takes time."""
        if not self._contouring.is_releasing:
            self._behind_compensation(command)

    def _behind_compensation(self, command: Command) -> None:
        if not self.compensation.is_releasing:
            self._behind_shaping(command)

    def _behind_shaping(self, command: Command) -> None:
        if not self._shaping.is_releasing:
            self._pass_time(command)
