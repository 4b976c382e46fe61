"""Peaks, products, exact flocks, spectra and recordings against slow references from their definitions, in NumPy and in fractions."""

from __future__ import annotations

import itertools
import random
from fractions import Fraction
from typing import Any

import networkx as nx
import numpy as np
import pytest

import flockproof

CASES = range(12)


def response(arcs: list[tuple[int, int, int]], gains: list[tuple[Fraction, Fraction]], car: int, w: float) -> float:
    """|y_car| for a leader e^{iwt}, agent 0; all others track the weighted mean of those that their arcs lead to."""
    n = len(gains)
    matrix, right = np.zeros((n, n), complex), np.zeros(n, complex)
    for k, (f, g) in enumerate(gains):
        rows = [(j, weight) for i, j, weight in arcs if i == k + 1]
        control = complex(float(f), w * float(g))
        matrix[k, k] += -(w**2) - control
        for j, weight in rows:
            share = weight / sum(weight for _, weight in rows)
            if j == 0:
                right[k] -= control * share
            else:
                matrix[k, j - 1] += control * share
    return float(abs(np.linalg.solve(matrix, right)[car - 1]))


@pytest.mark.parametrize("case", CASES)
def test_no_frequency_is_worse_than_the_peak(case: int) -> None:
    choose = random.Random(case)
    n = 2 + case % 5
    # A path from the leader to every car, and more arcs.
    arcs = [(k, choose.randrange(k), choose.choice([1, 1, 10, 100])) for k in range(1, n + 1)]
    used = {(i, j) for i, j, _ in arcs}
    others = [(i, j) for i in range(1, n + 1) for j in range(n + 1) if i != j and (i, j) not in used]
    arcs += [(i, j, choose.choice([1, 10, 100])) for i, j in choose.sample(others, min(len(others), case % 4))]
    gains = [(Fraction(-choose.randint(1, 8), 2), Fraction(-choose.randint(1, 30), 10)) for _ in range(n)]
    graph = nx.DiGraph()
    graph.add_nodes_from(range(n + 1))
    graph.add_weighted_edges_from(arcs)
    try:
        found = flockproof.peak(graph, *zip(*gains, strict=True), leader=0, car=n, digits=10)
    except ValueError as error:
        assert "not stable" in str(error)
        rows = np.zeros((2 * n, 2 * n))
        for k, (f, g) in enumerate(gains):
            rows[k, n + k] = 1
            own = [(j, weight) for i, j, weight in arcs if i == k + 1]
            for j, weight in [(k + 1, -sum(w for _, w in own)), *own]:
                if j > 0:
                    share = -weight / sum(w for _, w in own)
                    rows[n + k, j - 1] += share * float(f)
                    rows[n + k, n + j - 1] += share * float(g)
        assert np.linalg.eigvals(rows).real.max() > -1e-9
        return
    assert found.frequency is not None
    high = float(found.amplitude.hi) * (1 + 1e-9)
    near = float(found.frequency.mid)
    assert response(arcs, gains, n, near) == pytest.approx(float(found.amplitude), rel=1e-6)
    grid = np.concatenate([np.geomspace(1e-4, 1e3, 4000), near * np.linspace(0.9, 1.1, 400)])
    assert max(response(arcs, gains, n, w) for w in grid) <= high


def stochastic(choose: random.Random, n: int) -> list[list[Fraction]]:
    rows = [[choose.choice([0, 0, 1, 2, 5]) for _ in range(n)] for _ in range(n)]
    for i, row in enumerate(rows):
        row[i] += 1
    return [[Fraction(x, sum(row)) for x in row] for row in rows]


def times(a: Any, b: Any) -> Any:
    def entry(row: Any, column: Any) -> Fraction:
        return sum((x * y for x, y in zip(row, column, strict=True)), Fraction(0))

    return [[entry(row, column) for column in zip(*b, strict=True)] for row in a]


@pytest.mark.parametrize("case", CASES)
def test_products_are_multiplied_out(case: int) -> None:
    choose = random.Random(case)
    n, length = 1 + case % 5, 1 + case % 4
    factors = [stochastic(choose, n) for _ in range(length)]
    found = flockproof.ergodicity(factors)
    product = factors[0]
    for factor in factors[1:]:
        product = times(factor, product)
    assert found.product.tolist() == product
    pairs = list(itertools.product(product, repeat=2))
    apart = [[x - y for x, y in zip(a, b, strict=True)] for a, b in pairs]
    assert found.tau_1 == max(sum(map(abs, row)) for row in apart) / 2
    assert found.tau_2_squared == max(sum(x * x for x in row) for row in apart)


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("weights", ["lazy", "vicsek"])
def test_flocks_are_stepped_by_the_rule(case: int, weights: str) -> None:
    choose = random.Random(case)
    n, dimension, until = 1 + case % 5, 1 + case % 2, 14

    def draw(size: int) -> Any:
        return [[Fraction(choose.randint(-size, size), 8) for _ in range(dimension)] for _ in range(n)]

    x, v = draw(12), draw(6)
    threshold = None if case % 3 == 0 else Fraction(1, 40)
    flock = flockproof.Flock(x, v, weights=weights, hysteresis="none" if threshold is None else str(threshold))
    found = flock.run(until)

    def squared(x: Any, i: int, j: int) -> Fraction:
        return sum(((a - b) ** 2 for a, b in zip(x[i], x[j], strict=True)), Fraction(0))

    def grows_little(before: Fraction, after: Fraction) -> bool:
        # | sqrt(after) - sqrt(before) | < threshold, without roots.
        assert threshold is not None
        rest = before + after - threshold**2
        return rest < 0 or rest**2 < 4 * before * after

    pairs = list(itertools.combinations(range(n), 2))
    edges, switches = None, []
    for t in range(until + 1):
        if t > 0:
            last, x = x, [[a + b for a, b in zip(row, rate, strict=True)] for row, rate in zip(x, v, strict=True)]
        near = {(i, j) for i, j in pairs if squared(x, i, j) <= 1}
        if edges is not None and threshold is not None:
            near |= {(i, j) for i, j in edges if grows_little(squared(last, i, j), squared(x, i, j))}
        if edges is not None and near != edges:
            gained, lost = ([(i + 1, j + 1) for i, j in sorted(some)] for some in (near - edges, edges - near))
            switches.append((t, gained, lost))
        edges = near
        if t == 0:
            continue
        degree = [sum(k in pair for pair in edges) for k in range(n)]
        share = [Fraction(2, 3 * d) if weights == "lazy" and d else Fraction(1, d + 1) for d in degree]
        heard = [[j for j in range(n) if (min(i, j), max(i, j)) in edges and j != i] for i in range(n)]
        v = [
            [v[i][k] + share[i] * sum(((v[j][k] - v[i][k]) for j in heard[i]), Fraction(0)) for k in range(dimension)]
            for i in range(n)
        ]
    assert [(s.t, [tuple(p) for p in s.gained], [tuple(p) for p in s.lost]) for s in found.switches] == switches
    assert tuple(sorted(found.edges)) == tuple(sorted((i + 1, j + 1) for i, j in edges or ()))
    assert found.positions is not None and [list(row) for row in found.positions] == x
    assert found.velocities is not None and [list(row) for row in found.velocities] == v


@pytest.mark.parametrize("kind", ["laplacian", "adjacency", "out-degree", "in-degree"])
@pytest.mark.parametrize("case", CASES)
def test_spectra_are_those_of_numpy(case: int, kind: str) -> None:
    rng = np.random.default_rng(case)
    n = 2 + case % 6
    weights = rng.integers(0, 4, (n, n)) * (rng.random((n, n)) < 0.6)
    np.fill_diagonal(weights, 0)
    if kind in ("laplacian", "adjacency"):
        weights = np.triu(weights) + np.triu(weights).T
    degrees = np.diag(weights.sum(axis=0 if kind == "in-degree" else 1))
    matrix = weights if kind == "adjacency" else degrees - weights
    left = list(np.linalg.eigvals(matrix.astype(float)))
    for part in flockproof.spectrum(weights.tolist(), kind):
        for _ in range(part.multiplicity):
            nearest = min(left, key=lambda z, own=complex(part): abs(z - own))
            # Floats know a multiple eigenvalue to a root of their precision.
            assert abs(nearest - complex(part)) < 1e-3, (weights, kind)
            left.remove(nearest)
    assert not left


def recorded(rng: np.random.Generator, frames: int, fish: int) -> Any:
    """Fish that turn at random, with some positions missing; shape (frames, fish, 2)."""
    angle = rng.uniform(0, 7, fish) + 0.3 * rng.standard_normal((frames, fish)).cumsum(axis=0)
    data = np.stack([np.cos(angle), np.sin(angle)], axis=2).cumsum(axis=0) + 5 * rng.standard_normal((fish, 2))
    data[rng.random((frames, fish)) < 0.01] = np.nan
    return data


def velocity(data: Any, frame: int, fish: int, window: int, step: float) -> Any:
    """The mean over the window of central differences; nothing where a position that it needs is missing."""
    numbers = range(frame - window // 2 - 1, frame + window // 2 + 2)
    if numbers[0] < 0 or numbers[-1] >= len(data) or any(np.isnan(data[k, fish, 0]) for k in numbers):
        return None
    return sum((data[k + 1, fish] - data[k - 1, fish]) / (2 * step) for k in numbers[1:-1]) / window


@pytest.mark.parametrize("case", range(9))
def test_recordings_are_measured_frame_by_frame(case: int) -> None:
    rng = np.random.default_rng(case)
    frames, n, window = 150, 3 + case % 4, [1, 3, 7][case % 3]
    data = recorded(rng, frames, n)
    found = flockproof.tracks(data, fps=10, window=window, null=0, plain_nearest=True, nearest=[2]).summary
    sums: dict[str, list[float]] = {
        name: [] for name in ("p_1", "p_2", "momentum", "rotation", "W_complete", "W_single", "W_2")
    }
    for frame in range(frames):
        moving = [velocity(data, frame, fish, window, 0.1) for fish in range(n)]
        if any(v is None for v in moving):
            continue
        places, heading = data[frame], [v / np.hypot(*v) for v in moving]
        angle = [np.arctan2(y, x) for x, y in heading]
        arm = places - places.mean(axis=0)
        arm = [r / np.hypot(*r) for r in arm]

        def laplacian(neighbours: int) -> float:
            near = [sorted(range(n), key=lambda j: np.hypot(*(places[j] - places[k])))[1:] for k in range(n)]
            return sum(1 - np.cos(angle[k] - angle[j]) for k in range(n) for j in near[k][:neighbours]) / (2 * n)

        sums["p_1"].append(abs(sum(np.exp(1j * a) for a in angle)) / n)
        sums["p_2"].append(abs(sum(np.exp(2j * a) for a in angle)) / (2 * n))
        sums["momentum"].append(np.hypot(*(sum(moving) / n)))
        sums["rotation"].append(sum(r[0] * u[1] - r[1] * u[0] for r, u in zip(arm, heading, strict=True)) / n)
        sums["W_complete"].append(laplacian(n - 1))
        sums["W_single"].append(laplacian(1))
        sums["W_2"].append(laplacian(2))
    assert found["left_out"]["used"] == len(sums["p_1"]) > 20
    means = {**found["means"], "W_2": found["means"]["W_nearest"]["2"]}
    for name, values in sums.items():
        assert means[name] == pytest.approx(np.mean(values), abs=1e-9), name
