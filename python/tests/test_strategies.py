"""The strategies: what they draw is right, and near where laws break; and a made-up law whose planted fault they
find.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import pytest
from hypothesis import HealthCheck, find, given, settings

import flockproof
from flockproof import strategies as own

quick = settings(max_examples=40, deadline=None, suppress_health_check=list(HealthCheck))


@quick
@given(own.stochastic_matrices(positive_diagonal=True, symmetric_footprint=True))
def test_matrices_of_averaging(matrix: list[list[Fraction]]) -> None:
    assert all(sum(row) == 1 and min(row) >= 0 for row in matrix)
    n = range(len(matrix))
    assert all(matrix[i][i] > 0 and (matrix[i][j] > 0) == (matrix[j][i] > 0) for i in n for j in n)


@quick
@given(own.stochastic_sequences())
def test_tau_1_is_submultiplicative(sequence: list[list[list[Fraction]]]) -> None:
    bound = Fraction(1)
    for matrix in sequence:
        bound *= flockproof.ergodicity([matrix]).tau_1
    assert flockproof.ergodicity(sequence).tau_1 <= bound


@quick
@given(own.graphs(connected=True, max_order=5))
def test_connected_graphs(rows: list[list[Fraction]]) -> None:
    spectrum = flockproof.spectrum(rows)
    assert spectrum[0].exact == 0 and spectrum[0].multiplicity == 1


@quick
@given(own.flocks(max_birds=3), own.gains(), own.circle_points())
def test_flocks_gains_and_phases(flock: flockproof.Flock, gains: tuple[Fraction, Fraction], z: own.CirclePoint) -> None:
    assert flock.run(3).until == 3 and not flock.from_floats
    assert flockproof.resonance(5, *gains).amplitude > 0
    assert z.cos**2 + z.sin**2 == 1


@pytest.mark.parametrize("near", [Fraction(0), Fraction(1, 2**40), Fraction(-1, 2**40)])
def test_ties_are_drawn(near: Fraction) -> None:
    def tied(flock: flockproof.Flock) -> bool:
        import json

        (x,), (y,) = json.loads(flock.to_json())["positions"]
        return abs(Fraction(x) - Fraction(y)) == 1 + near

    find(own.flocks(max_birds=2, dimension=1), tied, settings=settings(max_examples=2000))


# A made-up law: on the line, everybody moves to the mean of those within distance 1.


def step(places: list[Fraction], near: Callable[[Fraction], bool]) -> list[Fraction]:
    """Everybody moves to the mean of those that are near."""
    seen = [[y for y in places if near(abs(x - y))] for x in places]
    return [sum(near_by, Fraction(0)) / len(near_by) for near_by in seen]


def law(places: list[Fraction]) -> list[Fraction]:
    return step(places, lambda distance: distance <= 1)


def fast_law(places: list[Fraction]) -> list[Fraction]:
    """The same with a planted fault: birds at distance exactly 1 do not see each other."""
    return step(places, lambda distance: distance < 1)


def places(flock: flockproof.Flock) -> list[Fraction]:
    import json

    return [Fraction(x) for (x,) in json.loads(flock.to_json())["positions"]]


@quick
@given(own.flocks(dimension=1))
def test_the_law_keeps_the_order(flock: flockproof.Flock) -> None:
    moved = law(sorted(places(flock)))
    assert moved == sorted(moved)


def test_the_planted_fault_is_found_and_shrunk() -> None:
    differs: Callable[[flockproof.Flock], bool] = lambda flock: law(places(flock)) != fast_law(places(flock))  # noqa: E731
    simplest = places(find(own.flocks(dimension=1), differs, settings=settings(max_examples=2000)))
    assert len(simplest) == 2 and abs(simplest[0] - simplest[1]) == 1
    with pytest.raises(Exception):  # noqa: B017
        find(
            own.flocks(dimension=1, near_ties=False),
            lambda flock: len(places(flock)) > 9,
            settings=settings(max_examples=50),
        )
