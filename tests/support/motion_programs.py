# SPDX-License-Identifier: MIT
"""Random programs of all that the path can do, and where they want the axes to be (MO-1, MO-3).

Lines over all axes, arcs and helices in three planes, G00, exact stops and contouring for a block
and on, slopes that change within the program, feeds in three kinds, overrides of the program, zero
offsets and turned systems, tool radius compensation, dwells, M functions of all kinds, a realtime
cycle that turns the override through 0. A program knows the way of each of its blocks in ACS.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random

import numpy as np

#: The planes: their first and second axis, the words of their centre.
PLANES = {17: (0, 1, "IJ"), 18: (2, 0, "KI"), 19: (1, 2, "JK")}
#: Zero offsets of the demo machine in X Y Z A.
OFFSETS = {53: (0.0, 0.0, 0.0, 0.0), 54: (100.0, 50.0, -10.0, 0.0), 55: (-50.0, 25.0, 0.0, 90.0)}
#: Blocks stay so near to where the program began.
ROOM_MM = 400.0
#: Overrides of the realtime cycle: a wave that is cut off at 0, steps.
WAVE = """#RT CYCLE [ID=1 SCOPE=PROG]
V.E.VALUE = V.E.VALUE + {step}
V.RTG.OVERRIDE.VEL.CYCLE = 0
$IF SIN[V.E.VALUE] > {low}
V.RTG.OVERRIDE.VEL.CYCLE = {maximum} * [SIN[V.E.VALUE] - {low}]
$ENDIF
#RT CYCLE END"""


@dataclass(frozen=True)
class Way:
    """Of one block, in ACS: from ``start`` to ``target``, over X Y Z A.

    ``arc``: first and second axis of the plane, the centre in them, the angle in radians.
    ``rounding``: how far a rounded corner at its end may stay away from it, mm; 0 none.
    ``exact``: it ends with an exact stop. ``plain``: its target is programmed as it is, with no
    offset, so that the last position is that one bit for bit. ``is_compensated``: the tool's
    centre is elsewhere.
    """

    start: np.ndarray
    target: np.ndarray
    arc: tuple[int, int, float, float, float] | None
    rounding: float
    exact: bool
    plain: bool
    is_compensated: bool
    limits_jerk: bool

    @property
    def moves(self) -> bool:
        """Whether it has a way that is more than rounding."""
        return self.arc is not None or bool(np.abs(self.start - self.target).max() > 1e-8)

    def distance(self, places: np.ndarray, count: int = 4) -> np.ndarray:
        """How far places (ticks, 4) are from the way, in the first ``count`` axes."""
        if self.arc is None:
            start, step = self.start[:count], self.target[:count] - self.start[:count]
            size = float(step @ step)
            off = places[:, :count] - start
            part = np.clip(off @ step / size, 0.0, 1.0) if size else np.zeros(len(places))
            return np.linalg.norm(off - np.multiply.outer(part, step), axis=1)
        first, second, centre_x, centre_y, angle = self.arc
        x, y = places[:, first] - centre_x, places[:, second] - centre_y
        begin_x, begin_y = self.start[first] - centre_x, self.start[second] - centre_y
        turned = np.arctan2(begin_x * y - begin_y * x, begin_x * x + begin_y * y)
        turned *= math.copysign(1.0, angle)
        turned = np.where(turned < -1e-6, turned + 2 * math.pi, turned)
        part = np.clip(turned / abs(angle), 0.0, 1.0)
        wanted = self.start + np.multiply.outer(part, self.target - self.start)
        cosine, sine = np.cos(part * angle), np.sin(part * angle)
        wanted[:, first] = centre_x + begin_x * cosine - begin_y * sine
        wanted[:, second] = centre_y + begin_x * sine + begin_y * cosine
        return np.linalg.norm((places - wanted)[:, :count], axis=1)

    def nearest(self, place: np.ndarray, count: int) -> float:
        """How far a place is from the way, also where a helix is nearer at another angle."""
        part = np.linspace(0.0, 1.0, 5001)
        points = self.start + np.multiply.outer(part, self.target - self.start)
        if self.arc is not None:
            first, second, centre_x, centre_y, angle = self.arc
            x, y = self.start[first] - centre_x, self.start[second] - centre_y
            cosine, sine = np.cos(part * angle), np.sin(part * angle)
            points[:, first] = centre_x + x * cosine - y * sine
            points[:, second] = centre_y + x * sine + y * cosine
        return float(np.linalg.norm((points - place)[:, :count], axis=1).min())


class MotionProgram:
    """The program of a seed: ``text``, and ``ways``, by the numbers of its blocks."""

    def __init__(self, seed: int, slopes: tuple[str, ...], size: int = 45) -> None:
        self.chance = Random(seed)
        self.slopes = slopes
        self.ways: dict[int, Way] = {}
        self.has_compensation = False
        self.has_wave = False
        self.number = 0
        self.place = np.zeros(4)
        self.plane = 17
        self.offset = 53
        self.turn: tuple[np.ndarray, np.ndarray, float] | None = None
        self.slope = ""
        self.is_exact = False
        self.is_contouring = False
        self.deviation = 1.0
        self.feed_kind = 94
        self.heading = self.chance.uniform(-math.pi, math.pi)
        self.bend = self.chance.choice((0.0, 0.02, 0.3, 3.0))
        self.size = self.chance.choice((0.03, 0.3, 3.0, 20.0))
        self.lines = ["G01 F6000"]
        self.set_slope()
        if self.chance.random() < 0.15:
            self.wave()
        for _ in range(self.chance.randint(6, size)):
            self.step()
        self.lines.append("M30")
        self.text = "\n".join(self.lines)

    # --- one step -------------------------------------------------------------------------------

    def step(self) -> None:
        """A setting or a block that moves."""
        chance = self.chance
        if chance.random() < 0.12:
            self.size = chance.choice((0.03, 0.3, 3.0, 20.0, 60.0))
        if chance.random() < 0.3:
            chance.choice(self.settings)(self)
        self.heading += chance.gauss(0.0, self.bend)
        kind = chance.random()
        if kind < 0.3:
            self.arc()
        elif kind < 0.32 and self.turn is None and self.offset == 53:
            self.compensated()
        else:
            self.line()

    def line(self) -> None:
        """A straight block."""
        chance = self.chance
        target = self.programmed()
        length = self.size * chance.uniform(0.2, 2.0)
        first, second, _ = PLANES[self.plane]
        if chance.random() > 0.05:
            target[first] += length * math.cos(self.heading)
            target[second] += length * math.sin(self.heading)
        if chance.random() < 0.2:
            target[3 - first - second] += length * chance.uniform(-1.0, 1.0)
        if chance.random() < 0.12:
            target[3] += length * chance.uniform(-3.0, 3.0)
        rapid = chance.random() < 0.12
        once = chance.choice(("", "", "", "", "G60 ", "G61 ", "G166 "))
        self.block(f"{once}G0{0 if rapid else 1}", self.inside(target), None, "", rapid)

    def arc(self) -> None:
        """An arc in the plane, along the heading as often as not, or a helix."""
        chance = self.chance
        first, second, letters = PLANES[self.plane]
        start = self.programmed()
        radius = self.size * chance.choice((0.3, 1.0, 5.0, 50.0))
        way = self.size * chance.uniform(0.2, 3.0)
        side = chance.choice((1, -1))
        angle = side * min(way / radius, 6.0)
        if chance.random() < 0.5:
            self.heading = chance.uniform(-math.pi, math.pi)
        x, y = -math.sin(self.heading) * radius * side, math.cos(self.heading) * radius * side
        x, y = round(x, 9), round(y, 9)
        centre = start[first] + x, start[second] + y
        target = start.copy()
        target[first] = centre[0] - x * math.cos(angle) + y * math.sin(angle)
        target[second] = centre[1] - x * math.sin(angle) - y * math.cos(angle)
        if np.abs(target[:3]).max() > ROOM_MM:
            self.heading += math.pi
            return
        self.heading += angle
        if chance.random() < 0.2:
            target[3 - first - second] += way * chance.uniform(-1.0, 1.0)
        if chance.random() < 0.05:
            target[3] += way * chance.uniform(-2.0, 2.0)
        words = f" {letters[0]}{x:.9f} {letters[1]}{y:.9f}"
        if chance.random() < 0.3 and 0.05 < abs(angle) < 3.0:
            words = f" R{math.hypot(x, y):.9f}"
        once = chance.choice(("", "", "", "G60 ", "G61 "))
        arc = (first, second, *centre, angle)
        self.block(f"{once}G0{3 if side > 0 else 2}", target, arc, words, False)

    def compensated(self) -> None:
        """A contour around outer corners with the radius of the tool."""
        chance = self.chance
        self.has_compensation = True
        if self.plane != 17:
            self.set_plane(17)
        self.lines.append(f"V.G.WZ_AKT.R = {chance.choice((0.5, 2.0, 5.0))}")
        side = chance.choice((1, -1))
        heading = chance.uniform(-math.pi, math.pi)
        pieces = chance.randint(2, 6)
        self.lines.append(chance.choice(("G25", "G26")))
        for piece in range(pieces + 2):
            words = "G41 " if side > 0 else "G42 "
            words = words if piece == 0 else "G40 " if piece == pieces + 1 else ""
            target = self.place.copy()
            length = chance.uniform(12.0, 40.0)
            target[0] += length * math.cos(heading)
            target[1] += length * math.sin(heading)
            self.block(f"{words}G01", target, None, "", False, is_compensated=True)
            if chance.random() < 0.2:
                self.lines.append(f"F{chance.choice((600, 3000, 12000))}")
            heading -= side * chance.uniform(0.0, 1.5)

    def block(
        self,
        head: str,
        target: np.ndarray,
        arc: tuple[int, int, float, float, float] | None,
        words: str,
        rapid: bool,
        *,
        is_compensated: bool = False,
    ) -> None:
        """Write a block, and the way that it has."""
        self.number += 10
        named = np.array([float(f"{value:.9f}") for value in target])
        moved = "".join(f" {name}{value:.9f}" for name, value in zip("XYZA", named, strict=True))
        if "G61" in head and self.feed_kind == 93:
            head = head.replace("G61 ", "")
        if self.feed_kind == 93 and not rapid:
            words += f" F{self.chance.uniform(0.05, 0.5):.3f}"
        self.lines.append(f"N{self.number} {head}{moved}{words}")
        end = self.outside(named)
        exact = rapid or self.is_exact or "G60" in head
        rounds = (self.is_contouring or "G61" in head) and not exact
        self.ways[self.number] = Way(
            self.place,
            end,
            None if arc is None else self.arc_outside(arc),
            self.deviation if rounds else 0.0,
            exact,
            self.turn is None and self.offset == 53,
            is_compensated,
            self.slope == "TRAPEZ",
        )
        self.place = end

    # --- coordinates ----------------------------------------------------------------------------

    def programmed(self) -> np.ndarray:
        """Where the axes are in the coordinates of the program."""
        if self.turn is not None:
            matrix, origin, _ = self.turn
            return np.array([*(matrix.T @ (self.place[:3] - origin)), self.place[3]])
        return self.place - np.array(OFFSETS[self.offset])

    def outside(self, place: np.ndarray) -> np.ndarray:
        """A place of the program in ACS."""
        if self.turn is not None:
            matrix, origin, _ = self.turn
            return np.array([*(matrix @ place[:3] + origin), place[3]])
        return place + np.array(OFFSETS[self.offset])

    def inside(self, target: np.ndarray) -> np.ndarray:
        """A target that is not too far away: the way turns back there."""
        if np.abs(self.outside(target)[:3]).max() > ROOM_MM:
            self.heading += math.pi
            return self.programmed() * (0.98, 0.98, 0.98, 1.0)
        return target

    def arc_outside(
        self, arc: tuple[int, int, float, float, float]
    ) -> tuple[int, int, float, float, float]:
        """An arc of the program in ACS: turned about the third axis, it stays one of G17."""
        first, second, x, y, angle = arc
        place = self.outside(
            np.array([x if i == first else y if i == second else 0.0 for i in range(4)])
        )
        return first, second, float(place[first]), float(place[second]), angle

    # --- settings -------------------------------------------------------------------------------

    def wave(self) -> None:
        """A realtime cycle that turns the override through 0."""
        chance = self.chance
        self.has_wave = True
        self.lines.append(
            WAVE.format(
                step=f"{chance.choice((0.4, 2.0, 11.0)):.1f}",
                low=f"{chance.choice((-0.9, -0.5, 0.0)):.1f}",
                maximum=chance.choice((60, 80, 100)),
            )
        )

    def set_slope(self) -> None:
        """One of the slopes that the program may have."""
        slope = self.chance.choice(self.slopes)
        if slope != self.slope:
            self.lines.append(f"#SLOPE [TYPE={slope}]")
            self.slope = slope

    def set_feed(self) -> None:
        """A feed per minute, another kind now and then."""
        chance = self.chance
        kind = chance.choice((94, 94, 94, 94, 93, 95))
        if kind == 95 and "M3 S1200" not in self.lines:
            self.lines += ["M3 S1200", "G04 X0.05"]
        feed = {93: 0.3, 94: chance.choice((600, 3000, 12000, 40000)), 95: 3}[kind]
        self.lines.append(f"G{kind} F{feed}")
        self.feed_kind = kind

    def set_ends(self) -> None:
        """Exact stop or contouring from here on."""
        chance = self.chance
        word = chance.choice(("G360", "G359", "G359", "G261", "G260"))
        self.lines.append(word)
        self.is_exact = {"G360": True, "G359": False}.get(word, self.is_exact)
        self.is_contouring = {"G261": True, "G260": False}.get(word, self.is_contouring)
        if chance.random() < 0.3:
            self.deviation = chance.choice((0.01, 0.1, 1.0))
            self.lines.append(f"#CONTOUR MODE [DEV PATH_DEV={self.deviation}]")

    def set_plane(self, plane: int = 0) -> None:
        """Another plane, where the system is not turned."""
        if self.turn is None:
            self.plane = plane or self.chance.choice((17, 17, 18, 19))
            self.lines.append(f"G{self.plane}")

    def set_offset(self) -> None:
        """A zero offset, or a system of coordinates that is shifted and turned about Z."""
        chance = self.chance
        if self.turn is not None:
            self.turn = None
            self.lines.append("#CS OFF")
        elif chance.random() < 0.5:
            self.offset = chance.choice((53, 54, 55))
            self.lines.append(f"G{self.offset}")
        elif self.offset == 53:
            self.set_plane(17)
            x, y, angle = chance.randint(-20, 20), chance.randint(-20, 20), chance.randint(-90, 90)
            self.lines.append(f"#CS ON [{x},{y},3,,,{angle}]")
            c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            matrix = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
            self.turn = (matrix, np.array([x, y, 3.0]), angle)

    def function(self) -> None:
        """An M function of any kind, a dwell, an override of the program."""
        chance = self.chance
        self.lines.append(
            chance.choice(
                (
                    f"M{chance.choice((100, 111, 112, 113, 114, 115, 117, 118))}",
                    f"M{chance.choice((100, 111, 112, 113, 114, 115, 117, 118))}",
                    f"#TIME {chance.choice((0.002, 0.02))}",
                    f"#OVERRIDE [FEED_FACT={chance.choice((30, 100, 150))}]",
                    "#FLUSH",
                )
            )
        )

    settings = (set_slope, set_feed, set_ends, set_ends, set_plane, set_offset, function, function)


class WeightedProgram(MotionProgram):
    """A program that changes weights, limits of the path and the mode of contouring as well."""

    def weigh(self) -> None:
        """A weight of one axis, of all, or of none."""
        chance = self.chance
        word = chance.choice(("G127 ", "G128", "G129", "G130 ", "G131", "G230 ", "G231"))
        pct = chance.choice((10, 40, 100, 100))
        if chance.random() < 0.3:
            word, pct = chance.choice(("G132 ", "G133", "G232 ", "G233")), 250
        self.lines.append(f"{word}{chance.choice('XYZA') if word[-1] == ' ' else '='}{pct}")

    def limit(self) -> None:
        """A limit of the path on or off."""
        chance = self.chance
        self.lines.append(
            chance.choice(
                (
                    "#VECTOR LIMIT OFF",
                    f"#VECTOR LIMIT ON [ACC={3600 * chance.choice((200, 2000))}]",
                    f"#VECTOR LIMIT ON [VEL={chance.choice((600, 6000))} FEED]",
                    f"#VECTOR LIMIT ON [RADIAL_ACC={3600 * chance.choice((50, 1000))}]",
                    "#VECTOR LIMIT ON [JERK=2160000000 RAPID]",
                )
            )
        )

    def contour(self) -> None:
        """Contouring by a distance from the corner, of which a curve goes at most half off."""
        distance = self.chance.choice((0.1, 2.0, 30.0))
        self.lines.append(
            f"#CONTOUR MODE [DIST PRE_DIST={distance} POST_DIST={distance} REMAIN_PART=20]"
        )
        self.deviation = 0.5 * distance
        self.lines.append("G261")
        self.is_contouring = True
        self.is_exact = False

    settings = (*MotionProgram.settings, weigh, weigh, limit, contour)
