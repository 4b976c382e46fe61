"""Attacks on the results about averaging flocks, in fractions."""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction

import numpy as np
import pytest
from attacks import words

Graph = frozenset[tuple[int, int]]
Matrix = list[list[Fraction]]


def graphs(n: int) -> Iterable[Graph]:
    """All undirected graphs on 0, .., n-1; both directions of each edge."""
    pairs = list(itertools.combinations(range(n), 2))
    for size in range(len(pairs) + 1):
        for edges in itertools.combinations(pairs, size):
            yield frozenset(edges) | frozenset((j, i) for i, j in edges)


def random_graph(n: int, choose: random.Random, dense: float = 0.5) -> Graph:
    edges = [pair for pair in itertools.combinations(range(n), 2) if choose.random() < dense]
    return frozenset(edges) | frozenset((j, i) for i, j in edges)


def reached(n: int, arcs: Iterable[tuple[int, int]], start: int) -> set[int]:
    arcs, seen, new = set(arcs), {start}, {start}
    while new:
        new = {j for i, j in arcs if i in new} - seen
        seen |= new
    return seen


def is_connected(n: int, graph: Iterable[tuple[int, int]]) -> bool:
    return len(reached(n, graph, 0)) == n


def degree(graph: Graph, i: int) -> int:
    return sum(1 for a, _ in graph if a == i)


def lazy(d: int) -> Fraction:
    return Fraction(2, 3 * d) if d else Fraction(0)


def vicsek(d: int) -> Fraction:
    return Fraction(1, d + 1)


def transition(n: int, graph: Graph, weight: Callable[[int], Fraction]) -> Matrix:
    rows = [[Fraction(0)] * n for _ in range(n)]
    for i in range(n):
        own = weight(degree(graph, i))
        rows[i][i] = 1 - own * degree(graph, i)
        for j in range(n):
            if (i, j) in graph:
                rows[i][j] = own
    return rows


def times(a: Matrix, b: Matrix) -> Matrix:
    return [
        [sum((x * y for x, y in zip(row, column, strict=True)), Fraction(0)) for column in zip(*b, strict=True)]
        for row in a
    ]


def tau_1(a: Matrix) -> Fraction:
    pairs = itertools.combinations(a, 2)
    return max(
        (sum((abs(x - y) for x, y in zip(p, q, strict=True)), Fraction(0)) / 2 for p, q in pairs), default=Fraction(0)
    )


@pytest.mark.parametrize(("n", "rounds"), [(2, 4), (3, 3), (4, 2)])
def test_smallest_entries(n: int, rounds: int) -> None:
    words(
        "beyond.chazelle.entries",
        "no nonzero entry",
        "is less than 1/n! for c_i = 1/(d_i+1)",
        "2^{n-2}/(3^{n-1} (n-1)!)",
        "these values occur",
    )
    bounds = {
        vicsek: Fraction(1, math.factorial(n)),
        lazy: Fraction(2 ** (n - 2), 3 ** (n - 1) * math.factorial(n - 1)),
    }
    for weight, bound in bounds.items():
        factors = [transition(n, graph, weight) for graph in graphs(n)]
        # Rows e_i P(t) .. P(s) of products by all sequences, the first factor last.
        rows = {tuple(Fraction(int(i == k)) for k in range(n)) for i in range(n)}
        least = Fraction(1)
        for _ in range(rounds):
            rows = {tuple(times([list(row)], factor)[0]) for row in rows for factor in factors}
            # Among rows with the same places of zeros those that are larger everywhere cannot become less.
            minimal: list[tuple[Fraction, ...]] = []
            for row in sorted(rows):
                support = [x > 0 for x in row]
                if not any(
                    [x > 0 for x in other] == support and all(x <= y for x, y in zip(other, row, strict=True))
                    for other in minimal
                ):
                    minimal.append(row)
            rows = set(minimal) if n > 3 else rows if len(rows) < 4000 else set(minimal)
            least = min(least, *(x for row in rows for x in row if x > 0))
        assert least >= bound
        if rounds >= n - 1:
            assert least == bound


def test_windows_contract() -> None:
    words(
        "beyond.chazelle.recurrent",
        "(1 - alpha^(n-1))^floor(m/(n-1))",
        "with an arc from i to j where p_ij > 0",
        "(1 - alpha^((n-1)B))^floor(t/((n-1)B))",
    )
    for case in range(60):
        choose = random.Random(case)
        n = choose.choice([2, 3, 3, 4])
        # Model D with weights of each bird's own, and windows that become connected as late as they please.
        product: Matrix = [[Fraction(int(i == j)) for j in range(n)] for i in range(n)]
        alpha, windows, union = Fraction(1), 0, set[tuple[int, int]]()
        for _ in range(40):
            graph = random_graph(n, choose, choose.choice([0.2, 0.6]))
            factor = [[Fraction(0)] * n for _ in range(n)]
            for i in range(n):
                d = degree(graph, i)
                own = Fraction(choose.randint(1, 9), 10 * d) if d else Fraction(0)
                factor[i] = [own if (i, j) in graph else Fraction(0) for j in range(n)]
                factor[i][i] = 1 - own * d
                alpha = min([alpha, *(x for x in factor[i] if x > 0)])
            product = times(factor, product)
            union |= graph
            if is_connected(n, union):
                windows, union = windows + 1, set()
        # What is left of a difference is at most tau_1 in every norm, and is that for some velocities.
        assert tau_1(product) <= (1 - alpha ** (n - 1)) ** (windows // (n - 1))
    for case in range(60):
        choose = random.Random(1000 + case)
        n, length = choose.choice([2, 3, 4]), choose.choice([1, 2, 3])
        factors: list[Matrix] = []
        while len(factors) < 14:
            rows = []
            for i in range(n):
                shares = [
                    Fraction(choose.randint(1, 9)) if i == j or choose.random() < 0.4 else Fraction(0) for j in range(n)
                ]
                rows.append([x / sum(shares) for x in shares])
            last = [*factors[max(0, len(factors) - length + 1) :], rows]
            arcs = {(i, j) for factor in last for i in range(n) for j in range(n) if factor[i][j] > 0}
            # A path from every bird to one bird.
            if len(last) < length or any(len(reached(n, [(j, i) for i, j in arcs], root)) == n for root in range(n)):
                factors.append(rows)
        alpha = min(x for factor in factors for row in factor for x in row if x > 0)
        product = factors[0]
        for t, factor in enumerate(factors):
            product = factor if t == 0 else times(factor, product)
            assert tau_1(product) <= (1 - alpha ** ((n - 1) * length)) ** ((t + 1) // ((n - 1) * length))


def test_fixed_networks_contract_in_every_norm() -> None:
    words(
        "beyond.chazelle.fiedler.rate",
        "at least 4/(n(n-1))",
        "they are at most n 2^{-t/n^3} times it after t steps",
        "in any norm",
    )
    for n in range(2, 6):
        for graph in graphs(n) if n < 5 else (random_graph(n, random.Random(case)) for case in range(60)):
            if not is_connected(n, graph):
                continue
            laplacian = np.array(
                [[degree(graph, i) if i == j else -int((i, j) in graph) for j in range(n)] for i in range(n)]
            )
            assert np.linalg.eigvalsh(laplacian)[1] >= 4 / (n * (n - 1)) - 1e-9
            for weight in (lazy, vicsek):
                factor = np.array([[float(x) for x in row] for row in transition(n, graph, weight)])
                power = np.eye(n)
                for t in range(1, 4 * n**3, max(1, n // 2)):
                    power = np.linalg.matrix_power(factor, t)
                    left = max(np.abs(power[i] - power[j]).sum() / 2 for i in range(n) for j in range(n))
                    assert left <= n * 2 ** (-t / n**3) * (1 + 1e-9), (graph, t)


def places(n: int) -> list[Fraction]:
    return [Fraction(2 * (i // 2)) + (Fraction(2, 3) if i % 2 else 0) for i in range(n)]


def near(x: Sequence[Fraction]) -> Graph:
    return frozenset((i, j) for i in range(len(x)) for j in range(len(x)) if i != j and abs(x[i] - x[j]) <= 1)


def networks(x: list[Fraction], v: list[Fraction], until: int, threshold: Fraction) -> list[Graph]:
    """Networks of a flock on the line with the weight 1/3 of one's own, at 0, .., until, with hysteresis."""
    found = [near(x)]
    for t in range(until):
        if t > 0:
            v = [
                v[i] / 3
                + sum((v[j] for j in range(len(x)) if (i, j) in found[-1]), Fraction(0))
                * Fraction(2, 3 * degree(found[-1], i))
                if degree(found[-1], i)
                else v[i]
                for i in range(len(x))
            ]
        y = [a + b for a, b in zip(x, v, strict=True)]
        kept = {(i, j) for i, j in found[-1] if abs(abs(y[i] - y[j]) - abs(x[i] - x[j])) < threshold}
        found.append(near(y) | kept)
        x = y
    return found


@pytest.mark.parametrize("power", ["8", "9", "10", "17/2", "12", "25", "31/3", "64"])
@pytest.mark.parametrize("n", [4, 8])
def test_the_lower_bound_has_one_switch(n: int, power: str) -> None:
    words(
        "beyond.chazelle.lower_bound",
        "the network changes at t = ceil(n^c/3)",
        "with or without hysteresis",
        "(n a multiple of 4, n^c >= 8)",
        "at no other time",
    )
    # n^c may be any number from 8 on: c is any constant.
    speed = 1 / Fraction(power)
    v = [speed * [1, 0, -1, 0][i % 4] for i in range(n)]
    at = math.ceil(Fraction(power) / 3)
    for threshold in (Fraction(0), Fraction(1, n ** (n**4)) if n == 4 else Fraction(1, 10**40), Fraction(1)):
        found = networks(places(n), v, at + 40, threshold)
        assert [t for t in range(1, len(found)) if found[t] != found[t - 1]] == [at]


def test_sixteen_birds_change_first_at_171() -> None:
    words(
        "beyond.chazelle.tower",
        "v(1) = (0, 8, 0, -8, 7, 1, -9, 1, -1, 9, -1, -7, 8, 0, -8, 0)/4096",
        "the network changes first at t = 171",
    )
    v = [Fraction(k, 4096) for k in (0, 8, 0, -8, 7, 1, -9, 1, -1, 9, -1, -7, 8, 0, -8, 0)]
    for threshold in (Fraction(0), Fraction(1, 2**60)):
        found = networks(places(16), v, 172, threshold)
        assert [t for t in range(1, len(found)) if found[t] != found[t - 1]][:1] == [171]


def test_stabilisers_and_the_count_of_changes() -> None:
    words(
        "beyond.chazelle.lem3.1.count",
        "P(t) stochastic with a positive diagonal and, off it, positive entries exactly at the edges of G_t",
        "+ 1 + binom(|V_k|,2) + M",
    )
    words(
        "beyond.chazelle.eq3.5",
        "T_k the first time after T_{k-1} from which on the footprint",
        "Then for k >= 1 and t > T_k",
    )
    tried = 0
    for case in range(1500):
        choose = random.Random(case)
        n = choose.choice([2, 3, 4, 5])
        changing = [random_graph(n, choose, choose.choice([0.1, 0.3, 0.5])) for _ in range(choose.randint(1, 6))]
        # The last network stays; after n more steps nothing new is reached.
        until = len(changing) + 3 * n
        net = [frozenset(), *changing, *[changing[-1]] * until]

        def rows(t: int, net: list[Graph] = net, n: int = n) -> list[set[int]]:
            return [{i} | {j for a, j in net[t] if a == i} for i in range(n)]

        stages, after, members = [(0, set(range(n)))], 0, set(range(n))
        for _ in range(3):
            reach, last = [{i} for i in range(n)], after + 1
            history: list[list[set[int]]] = []
            for t in range(after + 1, after + until):
                step = rows(min(t, len(net) - 1))
                reach = [set().union(*(reach[j] for j in step[i])) for i in range(n)]
                history.append([reach[i] & members for i in range(n)])
            final = history[-1]
            for k, seen in enumerate(history):
                if any(seen[i] != final[i] for i in members):
                    last = after + 1 + k + 1
            members = {i for i in members if 0 in final[i]}
            after = last
            stages.append((after, members))
        changes = [u for u in range(2, len(net)) if net[u] != net[u - 1]]
        for k in range(1, 4):
            time, inside = stages[k]
            later = range(time + 1, len(net) - 1)
            if any((i, j) not in net[u + 1] for u in later for i, j in net[u] if i in inside and j in inside):
                continue
            tried += 1
            outside = lambda graph, inside=inside: {(i, j) for i, j in graph if i not in inside and j not in inside}  # noqa: E731
            rest = sum(1 for u in range(time + 2, len(net)) if outside(net[u]) != outside(net[u - 1]))
            ends = [1, *(stages[stage][0] for stage in range(1, k + 1))]
            between = sum(sum(1 for u in changes if a < u <= b) for a, b in itertools.pairwise(ends))
            assert len(changes) <= between + 1 + math.comb(len(inside), 2) + rest, (case, k)
    assert tried > 500
