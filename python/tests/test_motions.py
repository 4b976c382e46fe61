"""Motions of `simulate` against SciPy, which integrates the law summed arc by arc from a plain list."""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import flockproof

solve_ivp = pytest.importorskip("scipy.integrate").solve_ivp

Arcs = list[tuple[int, int]]
Rate = Callable[[float, Any, Arcs], Any]
UNTIL = 1.0


def both_ways(edges: Arcs) -> Arcs:
    return [*edges, *((j, i) for i, j in edges)]


def networks(n: int, choose: random.Random, directed: bool) -> list[tuple[dict[str, Any], Arcs]]:
    """Each kind that depends on no distance, as a scenario has it and as arcs (k, j), k senses j, from 0."""
    pairs = list(itertools.combinations(range(n), 2))
    near = [(i, i + 1) for i in range(n - 1)]
    found: list[tuple[dict[str, Any], Arcs]] = [
        ({"kind": "complete"}, both_ways(pairs)),
        ({"kind": "path"}, both_ways(near)),
    ]
    if n > 2:
        found.append(({"kind": "ring"}, both_ways([*near, (n - 1, 0)])))
    for offset in range(1, n // 2 + 1):
        apart = [(i, j) for i, j in pairs if j - i in (offset, n - offset)]
        found.append(({"kind": "circulant", "offsets": [offset]}, both_ways(apart)))
    some = [pair for pair in pairs if choose.random() < 0.5]
    found.append(({"kind": "edges", "edges": one_based(some)}, both_ways(some)))
    if directed:
        arcs = both_ways(pairs)
        # As many as there are pairs, twice: a tournament, and any.
        one_way = [choose.choice([(i, j), (j, i)]) for i, j in pairs]
        lists = [one_way, choose.sample(arcs, len(pairs)), [arc for arc in arcs if choose.random() < 0.5], arcs]
        found.extend(({"kind": "edges", "directed": True, "edges": one_based(some)}, some) for some in lists)
    return found


def one_based(pairs: Arcs) -> list[list[int]]:
    return [[i + 1, j + 1] for i, j in pairs]


def reference(rate: Rate, start: Any, arcs: Arcs) -> Any:
    run = solve_ivp(rate, (0.0, UNTIL), np.array(start), args=(arcs,), method="DOP853", rtol=1e-11, atol=1e-12)
    return run.y[:, -1]


def end(model: str, graph: dict[str, Any], state: dict[str, Any], law: dict[str, Any]) -> Any:
    run = {"until": int(UNTIL), "rows": 1, "tolerance": "1e-12"}
    return flockproof.simulate({"model": model, "graph": graph, "state": state, "law": law, "run": run})


def drawn(choose: random.Random, *shape: int) -> Any:
    return np.array([choose.randint(-16, 16) / 8 for _ in range(int(np.prod(shape)))]).reshape(shape)


def apart(choose: random.Random, n: int) -> Any:
    cells = np.array(choose.sample(list(itertools.product(range(4), repeat=2)), n))
    return cells + np.abs(drawn(choose, n, 2)) / 8


SIZES = [1, 2, 3, 4, 5]


def test_three_arcs_of_three_phases() -> None:
    graph = {"kind": "edges", "edges": [[1, 2], [2, 3], [3, 1]], "directed": True}
    found = end("phase", graph, {"phases": [0, 1, 3]}, {"K1": -1}).phases[-1]
    assert found == pytest.approx([0.283545, 1.322225, 2.894064], abs=1e-6)


@pytest.mark.parametrize("n", SIZES)
def test_phases(n: int) -> None:
    choose = random.Random(n)
    for graph, arcs in networks(n, choose, True):
        theta, gain, omega = drawn(choose, n), choose.randint(-16, 16) / 8, choose.randint(-8, 8) / 8

        def rate(_: float, theta: Any, arcs: Arcs, gain: float = gain, omega: float = omega) -> Any:
            turning = np.full(len(theta), omega)
            for k, j in arcs:
                turning[k] += gain / len(theta) * np.sin(theta[k] - theta[j])
            return turning

        found = end("phase", graph, {"phases": theta}, {"K1": gain, "omega0": omega})
        assert found.phases[-1] == pytest.approx(reference(rate, theta, arcs), abs=1e-8), graph


@pytest.mark.parametrize("n", SIZES)
def test_particles(n: int) -> None:
    choose = random.Random(n)
    omega, spacing, gain = 0.75, 0.5, -1.25

    def rate(_: float, state: Any, arcs: Arcs) -> Any:
        r, theta = state[: 2 * n].reshape(n, 2), state[2 * n :]
        heading = np.stack([np.cos(theta), np.sin(theta)], axis=1)
        centre = r + np.stack([-np.sin(theta), np.cos(theta)], axis=1) / omega
        turning = np.full(n, omega)
        for k, j in arcs:
            turning[k] += gain / n * np.sin(theta[k] - theta[j])
            turning[k] += omega * spacing / n * heading[k] @ (centre[k] - centre[j])
        return np.concatenate([heading.ravel(), turning])

    for graph, arcs in networks(n, choose, True):
        r, theta = apart(choose, n), drawn(choose, n)
        law = {"omega0": omega, "K0": spacing, "K1": gain}
        found = end("particles", graph, {"positions": r, "phases": theta}, law)
        expected = reference(rate, np.concatenate([r.ravel(), theta]), arcs)
        shown = np.concatenate([found.positions[-1].ravel(), found.phases[-1]])
        assert shown == pytest.approx(expected, abs=1e-8), graph


@pytest.mark.parametrize("n", SIZES)
@pytest.mark.parametrize("model", ["velocity-alignment", "heading-alignment"])
def test_alignment(model: str, n: int) -> None:
    choose = random.Random(n)
    headings = model == "heading-alignment"

    def rate(_: float, state: Any, arcs: Arcs) -> Any:
        r, v, theta = state[: 2 * n].reshape(n, 2), state[2 * n : 4 * n].reshape(n, 2), state[4 * n :]
        force = np.zeros((n, 2))
        for k, j in arcs:
            s = (r[k] - r[j]) @ (r[k] - r[j])
            # V = k (s + 1/s - 2), k = 1/4.
            force[k] -= 2 * 0.25 * (1 - 1 / s**2) * (r[k] - r[j])
            across = np.array([-v[k][1], v[k][0]])
            force[k] -= (theta[k] - theta[j]) / s * across if headings else v[k] - v[j]
        turning = (v[:, 0] * force[:, 1] - v[:, 1] * force[:, 0]) / np.sum(v**2, axis=1) if headings else []
        return np.concatenate([v.ravel(), force.ravel(), turning])

    for graph, arcs in networks(n, choose, False):
        r, v = apart(choose, n), drawn(choose, n, 2) / 2
        # To the right, where no heading jumps.
        v[:, 0] = 1.5 + np.abs(v[:, 0])
        theta = np.arctan2(v[:, 1], v[:, 0]) if headings else []
        law = {"potential": "inverse-square-spring", "minimum": 1, "stiffness": "1/4"}
        found = end(model, graph, {"positions": r, "velocities": v}, law)
        expected = reference(rate, np.concatenate([r.ravel(), v.ravel(), theta]), arcs)[: 4 * n]
        shown = np.concatenate([found.positions[-1].ravel(), found.velocities[-1].ravel()])
        assert shown == pytest.approx(expected, abs=1e-8), graph


@pytest.mark.parametrize("n", SIZES)
def test_laws_of_ones_own(n: int) -> None:
    choose = random.Random(n)
    law = {
        "state": {"x": "vector", "v": "vector"},
        "parameters": {"K": "3/4"},
        "rates": {"x": "v", "v": "K*sum(j, (v[j] - v)/(1 + norm2(x[j] - x))) - x/8"},
    }

    def rate(_: float, state: Any, arcs: Arcs) -> Any:
        x, v = state.reshape(2, n, 2)
        force = -x / 8
        for k, j in arcs:
            force[k] += 0.75 * (v[j] - v[k]) / (1 + np.sum((x[j] - x[k]) ** 2))
        return np.concatenate([v.ravel(), force.ravel()])

    for graph, arcs in networks(n, choose, True):
        x, v = apart(choose, n), drawn(choose, n, 2) / 2
        found = end("own", graph, {"x": x, "v": v}, law)
        shown = np.concatenate([found.states[name][-1].ravel() for name in ("x", "v")])
        assert shown == pytest.approx(reference(rate, np.concatenate([x.ravel(), v.ravel()]), arcs), abs=1e-8), graph


@pytest.mark.parametrize("n", SIZES[1:])
def test_platoons(n: int) -> None:
    choose = random.Random(n)
    f, g, size, frequency = -1.25, -0.75, 0.25, 1.5
    for (graph, arcs), leader in itertools.product(networks(n, choose, True), range(n)):
        tracked = [[j for k, j in arcs if k == car] for car in range(n)]
        x, v = drawn(choose, n) / 8 - np.arange(n), drawn(choose, n) / 4
        y = x + np.arange(n)
        place, speed = y[leader], v[leader]

        def led(t: float, place: float = place, speed: float = speed) -> tuple[float, float]:
            w = frequency
            return place + speed * t + size * np.cos(w * t), speed - size * w * np.sin(w * t)

        def rate(t: float, state: Any, _: Arcs, tracked: Any = tracked, leader: int = leader, led: Any = led) -> Any:
            y, u = state[:n].copy(), state[n:].copy()
            y[leader], u[leader] = led(t)
            force = np.zeros(n)
            for k in range(n):
                # Who tracks nobody keeps its speed.
                if k != leader and tracked[k]:
                    force[k] = f * (y[k] - np.mean(y[tracked[k]])) + g * (u[k] - np.mean(u[tracked[k]]))
            return np.concatenate([u, force])

        law = {"f": f, "g": g, "leader": {"agent": leader + 1, "amplitude": size, "frequency": frequency}}
        found = end("platoon", graph, {"positions": x[:, None], "velocities": v[:, None]}, law)
        expected = reference(rate, np.concatenate([y, v]), [])
        expected[leader], expected[n + leader] = led(UNTIL)
        shown = np.concatenate([found.positions[-1].ravel() + np.arange(n), found.velocities[-1].ravel()])
        assert shown == pytest.approx(expected, abs=1e-8), (graph, leader)
        last = found.observables["last_deviation"][-1]
        assert last == pytest.approx(expected[n - 1] - expected[leader], abs=1e-8)


def stepped(choose: random.Random, n: int, side: float) -> tuple[Any, Any]:
    """Places and angles at random: discrete motions meet no threshold by design."""
    places = np.array([[choose.uniform(0, side) for _ in range(2)] for _ in range(n)])
    return places, np.array([choose.uniform(-3, 3) for _ in range(n)])


@pytest.mark.parametrize("steering", ["behaviours", "laplacians"])
@pytest.mark.parametrize("n", [1, 2, 3, 5, 8])
def test_fish(n: int, steering: str) -> None:
    """(26) to (28) with the signs of the declaration, zone by zone from the words of the paper."""
    choose = random.Random(n)
    step, turning, gains = 1 / 8, 0.25, (1.5, 0.75, 0.5)
    radii, blind = (1.0, 2.0, 4.0), 60.0
    for _ in range(4):
        places, angles = stepped(choose, n, 4.0)
        law = {"T": "1/8", "omega0": "1/4", "Krep": "3/2", "Kori": "3/4", "Katt": "1/2", "steering": steering}
        zones = {"repulsion": 1, "orientation": 2, "attraction": 4, "blind_angle": 60}
        run = {"until": 3, "rows": 1}
        state = {"positions": places, "phases": angles}
        found = flockproof.simulate({"model": "fish", "state": state, "law": {**law, **zones}, "run": run})
        r, theta = places.copy(), angles.copy()
        for _ in range(24):
            control = np.full(n, turning)
            for k in range(n):
                ahead = np.array([np.cos(theta[k]), np.sin(theta[k])])
                left = np.array([-ahead[1], ahead[0]])
                for j in range(n):
                    apart = r[j] - r[k]
                    distance = np.hypot(*apart)
                    if j == k or apart @ ahead < -distance * np.cos(np.radians(blind / 2)):
                        continue
                    mate = np.array([np.cos(theta[j]), np.sin(theta[j])])
                    if distance <= radii[0] and steering == "behaviours":
                        control[k] -= gains[0] * left @ apart / distance
                    if radii[0] <= distance <= radii[1]:
                        control[k] += gains[1] * left @ mate
                    if radii[1] <= distance <= radii[2]:
                        control[k] += gains[2] * left @ apart / (distance if steering == "behaviours" else 1)
            r, theta = r + step * np.stack([np.cos(theta), np.sin(theta)], axis=1), theta + step * control
        assert found.positions[-1] == pytest.approx(r, abs=1e-9)
        assert np.exp(1j * found.phases[-1]) == pytest.approx(np.exp(1j * theta), abs=1e-9)


@pytest.mark.parametrize("n", [1, 2, 5, 20])
def test_noisy_headings_without_noise(n: int) -> None:
    """Vicsek and others 1995 in a periodic square: places with the headings of now, then the mean heading of those near."""
    choose = random.Random(n)
    side, speed = 5.0, 0.25
    for _ in range(4):
        places, angles = stepped(choose, n, side)
        law = {"box": 5, "speed": "1/4", "noise": 0}
        state = {"positions": places, "phases": angles}
        found = flockproof.simulate(
            {"model": "vicsek-noise", "state": state, "law": law, "run": {"until": 12, "rows": 1}}
        )
        r, z = places.copy(), np.exp(1j * angles)
        for _ in range(12):
            apart = r[:, None, :] - r[None, :, :]
            apart -= side * np.round(apart / side)
            near = np.hypot(apart[..., 0], apart[..., 1]) < 1
            sums = near @ z
            r = (r + speed * np.stack([z.real, z.imag], axis=1)) % side
            z = sums / abs(sums)
        differences = found.positions[-1] - r
        assert np.abs(differences - side * np.round(differences / side)).max() < 1e-8
        assert np.exp(1j * found.phases[-1]) == pytest.approx(z, abs=1e-8)
