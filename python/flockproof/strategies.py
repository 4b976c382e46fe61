"""Hypothesis strategies for flocks, stochastic matrices, graphs, gains and states on the circle: exact, and near
where laws break.

Everything is drawn from small integers, so that a failing case shrinks to few birds, small denominators and the
simple side of a tie.

Examples
--------
>>> from hypothesis import given, settings
>>> from flockproof import strategies
>>> @settings(max_examples=20, deadline=None)
... @given(strategies.stochastic_matrices(max_order=3))
... def rows_sum_to_one(matrix):
...     assert all(sum(row) == 1 for row in matrix)
>>> rows_sum_to_one()
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ._extras import missing
from ._flock import Flock
from ._signatures import readable

try:
    from hypothesis import strategies as st
except ModuleNotFoundError as _error:
    raise missing(["hypothesis"], ["strategies"]) from _error

__all__ = [
    "CirclePoint",
    "circle_points",
    "flocks",
    "fractions",
    "gains",
    "graphs",
    "stochastic_matrices",
    "stochastic_sequences",
]


def __dir__() -> list[str]:
    return sorted(__all__)


def fractions(lowest: int = -4, highest: int = 4, max_denominator: int = 8) -> st.SearchStrategy[Fraction]:
    """Fractions with small denominators; shrink to integers, and to 0.

    Parameters
    ----------
    lowest, highest
        Integers between which they lie.
    max_denominator
        At least 1.
    """

    def between(denominator: int) -> st.SearchStrategy[Fraction]:
        return st.integers(lowest * denominator, highest * denominator).map(lambda p: Fraction(p, denominator))

    return st.integers(1, max_denominator).flatmap(between)


#: Distances from a tie: on it, and a little to either side.
_beside = st.sampled_from([Fraction(0), Fraction(1, 8), Fraction(-1, 8), Fraction(1, 2**40), Fraction(-1, 2**40)])


@st.composite
def _positions(draw: st.DrawFn, birds: int, dimension: int, ties: bool) -> list[list[Fraction]]:
    """Birds one after the other; with ties each may be placed at distance 1, or almost, from one before it."""
    places = [[draw(fractions(-2, 2)) for _ in range(dimension)]]
    for i in range(1, birds):
        if ties and draw(st.booleans()):
            neighbour = places[draw(st.integers(0, i - 1))]
            # Rational points of the unit sphere: of the circle, turned into any two coordinates.
            step = [Fraction(0)] * dimension
            if dimension == 1:
                step[0] = draw(st.sampled_from([Fraction(1), Fraction(-1)]))
            else:
                a, b = draw(st.permutations(range(dimension)))[:2]
                point = draw(circle_points())
                step[a], step[b] = point.cos, point.sin
            stretch = 1 + draw(_beside)
            places.append([x + stretch * s for x, s in zip(neighbour, step, strict=True)])
        else:
            places.append([draw(fractions(-2, 2)) for _ in range(dimension)])
    return places


@st.composite
def flocks(
    draw: st.DrawFn,
    min_birds: int = 2,
    max_birds: int = 5,
    dimension: int | None = None,
    near_ties: bool = True,
    near_grazing: bool = True,
    weights: str | None = None,
) -> Flock:
    """Flocks of model D.

    Parameters
    ----------
    min_birds, max_birds, dimension
        Sizes; dimension 1 or 2 where none is given.
    near_ties
        Pairs may start at distance 1, where the network changes, or 2^-40 beside it.
    near_grazing
        Two birds may fly past each other in the plane with a least distance of 1, or 2^-40 beside it.
    weights
        ``"lazy"`` or ``"vicsek"``; either where none is given.
    """
    birds = draw(st.integers(min_birds, max_birds))
    size = dimension if dimension is not None else draw(st.sampled_from([1, 2]))
    positions = draw(_positions(birds, size, near_ties))
    velocities = [[draw(fractions(-1, 1)) for _ in range(size)] for _ in range(birds)]
    if near_grazing and size >= 2 and birds >= 2 and draw(st.booleans()):
        # Along the first axis, at a distance across it of 1 or almost.
        far = draw(st.integers(2, 6))
        positions[1] = [positions[0][0] + far, positions[0][1] + 1 + draw(_beside), *positions[0][2:]]
        velocities[0] = [Fraction(1, 4), *[Fraction(0)] * (size - 1)]
        velocities[1] = [Fraction(-1, 4), *[Fraction(0)] * (size - 1)]
    chosen = weights if weights is not None else draw(st.sampled_from(["lazy", "vicsek"]))
    return Flock(positions, velocities, weights=chosen)


@st.composite
def stochastic_matrices(
    draw: st.DrawFn,
    min_order: int = 1,
    max_order: int = 5,
    order: int | None = None,
    positive_diagonal: bool = False,
    symmetric_footprint: bool = False,
) -> list[list[Fraction]]:
    """Row-stochastic matrices with exact entries; shrink to the identity.

    Parameters
    ----------
    min_order, max_order, order
        Sizes.
    positive_diagonal, symmetric_footprint
        What averaging on undirected networks gives.
    """
    n = order if order is not None else draw(st.integers(min_order, max_order))
    joined = [[i == j or draw(st.booleans()) for j in range(n)] for i in range(n)]
    shares = [[draw(st.integers(1, 6)) if joined[i][j] else 0 for j in range(n)] for i in range(n)]
    for i in range(n):
        for j in range(i):
            if symmetric_footprint and (shares[i][j] > 0) != (shares[j][i] > 0):
                shares[i][j] = shares[j][i] = 0
        if not positive_diagonal and n > 1 and draw(st.booleans()) and sum(shares[i]) > shares[i][i]:
            shares[i][i] = 0
    return [[Fraction(x, sum(row)) for x in row] for row in shares]


@st.composite
def stochastic_sequences(
    draw: st.DrawFn, /, max_length: int = 6, min_order: int = 1, max_order: int = 4, **kind: Any
) -> list[list[list[Fraction]]]:
    """Sequences of row-stochastic matrices of one order, the first factor first; shrink to few small ones.

    Parameters
    ----------
    max_length, min_order, max_order
        Sizes.
    kind
        As for :func:`stochastic_matrices`.
    """
    # Both sizes before all entries: then fewer entries are needed where one of them shrinks.
    length, order = draw(st.integers(1, max_length)), draw(st.integers(min_order, max_order))
    return [draw(stochastic_matrices(order=order, **kind)) for _ in range(length)]


@st.composite
def graphs(
    draw: st.DrawFn,
    min_order: int = 1,
    max_order: int = 6,
    connected: bool = False,
    directed: bool = False,
    weighted: bool = False,
) -> list[list[Fraction]]:
    """Graphs as weighted adjacency matrices; shrink to few edges, connected ones to a star.

    Rows of fractions, n x n, with the weight of the arc from i to j in row i, column j, as
    :func:`flockproof.spectrum` reads them.

    Parameters
    ----------
    min_order, max_order
        Sizes.
    connected, directed, weighted
        Strongly connected where directed; weights are 1 where not weighted, otherwise between 1 and 4.
    """
    n = draw(st.integers(min_order, max_order))
    rows = [[Fraction(0)] * n for _ in range(n)]

    def weight() -> Fraction:
        return draw(fractions(1, 4)) if weighted else Fraction(1)

    def join(i: int, j: int) -> None:
        rows[i][j] = weight()
        rows[j][i] = weight() if directed else rows[i][j]

    for i in range(n):
        for j in range(n if directed else i):
            if i != j and draw(st.booleans()):
                rows[i][j] = weight()
                if not directed:
                    rows[j][i] = rows[i][j]
    if connected:
        # A tree beneath: each vertex is joined to one before it.
        for i in range(1, n):
            j = draw(st.integers(0, i - 1))
            if not rows[i][j] or not rows[j][i]:
                join(i, j)
    return rows


@st.composite
def gains(draw: st.DrawFn, extreme: bool = False) -> tuple[Fraction, Fraction]:
    """Gains (f, g) of a platoon, both below 0; shrink to (-1, -1).

    Parameters
    ----------
    extreme
        Also of very different size, 10^12 times larger and smaller.
    """

    def one() -> Fraction:
        size = Fraction(draw(st.integers(1, 64)), draw(st.sampled_from([1, 2, 8, 10, 100])))
        return -size * (Fraction(10) ** draw(st.sampled_from([0, -12, 12])) if extreme else 1)

    return one(), one()


@dataclass(frozen=True)
class CirclePoint:
    """A point of the unit circle with rational coordinates: ((1 - t^2) + 2 t i)/(1 + t^2).

    Attributes
    ----------
    t : Fraction or None
        The tangent of half the angle; None for -1, which no t gives.
    """

    t: Fraction | None

    @property
    def cos(self) -> Fraction:
        """The first coordinate."""
        return Fraction(-1) if self.t is None else (1 - self.t**2) / (1 + self.t**2)

    @property
    def sin(self) -> Fraction:
        """The second coordinate."""
        return Fraction(0) if self.t is None else 2 * self.t / (1 + self.t**2)


def circle_points() -> st.SearchStrategy[CirclePoint]:
    """Exact phases, :class:`CirclePoint`; shrink to 1, and to the quarter turns before others."""
    corners = st.sampled_from([Fraction(0), Fraction(1), Fraction(-1), None])
    return st.one_of(corners, fractions(-8, 8, 12)).map(CirclePoint)


readable(globals(), __all__)
