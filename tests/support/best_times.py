# SPDX-License-Identifier: MIT
"""Paths of lines and arcs as programs, and the best time along them: ``toppra`` as the oracle.

The geometry is exact, piece by piece, so that the oracle sees no other curve than the program's.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class Piece:
    """From ``start`` along ``way``, or about ``centre`` by ``angle`` radians and up by ``rise``."""

    start: Vector
    way: Vector
    centre: Vector | None = None
    angle: float = 0.0

    @property
    def length(self) -> float:
        """The way along it."""
        if self.centre is None:
            return float(np.linalg.norm(self.way))
        radius = float(np.linalg.norm((self.start - self.centre)[:2]))
        return math.hypot(radius * self.angle, self.way[2])

    def derivative(self, done: float, order: int) -> Vector:
        """Place, direction or curvature after a way; the way itself is a fourth axis."""
        part = done / self.length
        found = np.zeros(4)
        found[3] = (done, 1.0, 0.0)[order]
        rise = (self.start + self.way * part, self.way / self.length, np.zeros(3))[order]
        found[:3] = rise
        if self.centre is None:
            return found
        x, y = (self.start - self.centre)[:2]
        turn = self.angle / self.length
        cosine, sine = math.cos(self.angle * part), math.sin(self.angle * part)
        across = np.array([x * cosine - y * sine, x * sine + y * cosine])
        along = np.array([-across[1], across[0]]) * turn
        found[:2] = (self.centre[:2] + across, along, -across * turn * turn)[order]
        return found


@dataclass
class Way:
    """A path that grows piece by piece from the origin, and the blocks of its program."""

    place: Vector = field(default_factory=lambda: np.zeros(3))
    pieces: list[Piece] = field(default_factory=list)
    blocks: list[str] = field(default_factory=list)

    def line(self, x: float, y: float, z: float = 0.0) -> Way:
        """On by a line."""
        way = np.array([x, y, z])
        self.pieces.append(Piece(self.place, way))
        self.place = self.place + way
        self.blocks.append(f"G01 {self._target()}")
        return self

    def arc(self, i: float, j: float, degrees: float, rise: float = 0.0) -> Way:
        """On by an arc about a centre, counted from here, counterclockwise where above 0."""
        centre = self.place + np.array([i, j, 0.0])
        piece = Piece(self.place, np.array([0.0, 0.0, rise]), centre, math.radians(degrees))
        self.pieces.append(piece)
        end = piece.derivative(piece.length, 0)[:3]
        if abs(degrees) == 360:
            end = self.place + np.array([0.0, 0.0, rise])
        self.place = end
        self.blocks.append(f"G0{3 if degrees > 0 else 2} {self._target()} I{i:.9f} J{j:.9f}")
        return self

    def _target(self) -> str:
        x, y, z = self.place
        return f"X{x:.9f} Y{y:.9f} Z{z:.9f}"

    def program(self, feed: float) -> str:
        """Its blocks with a feed in mm/s."""
        return "\n".join([f"F{feed * 60}", *self.blocks])


def best_time(
    way: Way,
    feed: float,
    speeds: tuple[float, ...],
    accelerations: tuple[float, ...],
    places: int = 800,
) -> float:
    """The shortest time from rest to rest with the limits of X, Y, Z and a feed.

    The oracle counts in centimetres: its tolerances are absolute, and no number may be above 10⁴.
    """
    toppra: Any = pytest.importorskip("toppra", reason="the oracle for curves is not installed")
    toppra.setup_logging("ERROR")
    unit = 10.0
    path, grid = _geometry(toppra, way, places, unit)
    limits = [
        toppra.constraint.JointVelocityConstraint(_both([*speeds, feed], unit)),
        toppra.constraint.JointAccelerationConstraint(
            _both([*accelerations, 1e5], unit),
            discretization_scheme=toppra.constraint.DiscretizationType.Interpolation,
        ),
    ]
    solver = toppra.algorithm.TOPPRA(limits, path, gridpoints=grid, solver_wrapper="seidel")
    _, speed, _ = solver.compute_parameterization(0, 0)
    return float(np.sum(2 * np.diff(grid) / (speed[1:] + speed[:-1])))


def _both(limits: list[float], unit: float) -> Vector:
    return np.array([[-limit, limit] for limit in limits]) / unit


def _geometry(toppra: Any, way: Way, places: int, unit: float) -> tuple[Any, Vector]:
    """The path as ``toppra`` wants it, and a grid with both sides of each joint."""
    lengths = [piece.length / unit for piece in way.pieces]
    begins = np.concatenate([[0.0], np.cumsum(lengths)])

    class Exact(toppra.interpolator.AbstractGeometricPath):  # type: ignore[misc]
        """Piece by piece."""

        dof = 4
        path_interval = np.array([0.0, begins[-1]])
        waypoints = None

        def __call__(self, places: Any, order: int = 0) -> Vector:
            if np.ndim(places):
                return np.array([self(place, order) for place in places])
            k = int(np.clip(np.searchsorted(begins, places, side="right") - 1, 0, len(lengths) - 1))
            done = (float(places) - begins[k]) * unit
            return way.pieces[k].derivative(done, order) * unit ** (order - 1)

    grid = []
    for k, length in enumerate(lengths):
        one = np.linspace(begins[k], begins[k + 1], max(8, int(places * length / begins[-1])))
        one[0] += 1e-6 * length * (k > 0)
        one[-1] -= 1e-6 * length * (k + 1 < len(lengths))
        grid.append(one)
    return Exact(), np.concatenate(grid)
