"""Worst cases against simulations and optimisations by SciPy, which know nothing of how they were found."""

from __future__ import annotations

import json
import tomllib
from fractions import Fraction
from pathlib import Path
from typing import Any

import flockproof
import numpy as np
import pytest
import scipy.integrate as scipy_integrate
import scipy.linalg as scipy_linalg
import scipy.optimize as scipy_optimize
import scipy.signal as scipy_signal

TWO = {
    "system": {"states": ["x", "v"], "inputs": {"u": [-1, 1]}, "start": {"x": 0, "v": 0}},
    "mode": {"only": {"A": [[0, 1], [-2, -1]], "B": [[0], [1]]}},
    "run": {"until": 6},
    "check": [{"holds": "x <= 1"}],
}


def latest(pairs: list[dict[str, str]], key: str, t: float) -> str:
    return [pair[key] for pair in pairs if float(Fraction(pair["from"])) <= t][-1]


def test_a_witness_is_a_motion() -> None:
    found = flockproof.reach(TWO)[0]
    assert found.witness is not None and found.worst is not None
    a, b = np.array([[0.0, 1], [-2, -1]]), np.array([0.0, 1])
    state, end = np.zeros(2), float(Fraction(found.witness["at"]))
    times = [float(Fraction(pair["from"])) for pair in found.witness["inputs"][0]["values"]] + [end]
    for start, stop in zip(times, times[1:], strict=False):
        u = float(Fraction(latest(found.witness["inputs"][0]["values"], "value", start)))
        run = scipy_integrate.solve_ivp(lambda t, x, u=u: a @ x + b * u, (start, stop), state, rtol=1e-12, atol=1e-12)
        state = run.y[:, -1]
    assert abs(state[0] - float(found.worst)) < 1e-8


def test_random_inputs_are_never_worse() -> None:
    found = flockproof.reach(TWO)[0]
    assert found.hi is not None
    random = np.random.default_rng(1)
    system = scipy_signal.StateSpace([[0, 1], [-2, -1]], [[0], [1]], np.eye(2), np.zeros((2, 1)))
    t = np.linspace(0, 6, 601)
    for _ in range(50):
        u = np.repeat(random.choice([-1.0, 1.0], 20), 31)[:601]
        _, y, _ = scipy_signal.lsim(system, u, t, interp=False)
        assert y[:, 0].max() <= float(found.hi) + 1e-9


def test_state_space_objects_are_modes() -> None:
    system = scipy_signal.StateSpace([[0.0, 1.0], [-2.0, -1.0]], [[0.0], [1.0]], [[1.0, 0.0]], [[0.0]])
    found = flockproof.reach({**TWO, "mode": {"only": system}})
    assert found.from_floats and not flockproof.reach(TWO).from_floats
    assert found[0].worst == flockproof.reach(TWO)[0].worst
    with pytest.raises(ValueError, match="discrete time"):
        flockproof.reach({**TWO, "mode": {"only": system.to_discrete(0.1)}})
    with pytest.raises(TypeError, match="A and B"):
        flockproof.reach({**TWO, "mode": {"only": 3}})


def test_systems_of_python_control_are_modes() -> None:
    control = pytest.importorskip("control")
    matrices = ([[0.0, 1.0], [-2.0, -1.0]], [[0.0], [1.0]], [[1.0, 0.0]], [[0.0]])
    found = flockproof.reach({**TWO, "mode": {"only": control.ss(*matrices)}})
    assert found.from_floats and found[0].worst == flockproof.reach(TWO)[0].worst
    with pytest.raises(ValueError, match="discrete time"):
        flockproof.reach({**TWO, "mode": {"only": control.ss(*matrices, 0.1)}})


def test_the_file_is_the_dictionary(tmp_path: Path) -> None:
    file = tmp_path / "two.toml"
    modes = [{"name": "only", **TWO["mode"]["only"]}]  # type: ignore[index]
    text = flockproof._runs.toml({**TWO, "mode": modes})
    file.write_text(text)
    assert flockproof.reach(file) == flockproof.reach(TWO)
    assert json.loads(json.dumps(dict(flockproof.reach(file)[0].witness or {})))


def test_a_platoon_has_its_graph_in_a_file(tmp_path: Path) -> None:
    (tmp_path / "cars.txt").write_text("a b\nb leader\n")
    keys = {"f": -1, "g": -1, "acceleration": [-1, 1]}
    rest = {"run": {"until": 9}, "check": [{"holds": "lag1 <= 1"}]}
    path = tmp_path / "system.toml"
    path.write_text(
        '[platoon]\ngraph = "file:cars.txt"\nf = -1\ng = -1\nacceleration = [-1, 1]\n'
        '[run]\nuntil = 9\n[[check]]\nholds = "lag1 <= 1"\n'
    )
    written = flockproof.reach({"platoon": {"tracks": [[2], [0, 1]], **keys}, **rest})
    assert flockproof.reach(path)[0].worst == written[0].worst
    assert flockproof.reach(path).tube(samples=4).shape == (4, 4)


@pytest.mark.parametrize("change", [{"run": {"until": -1}}, {"check": [{"holds": "y <= 1"}]}, {"mode": []}])
def test_bad_systems_are_refused(change: dict[str, Any]) -> None:
    with pytest.raises(ValueError):
        flockproof.reach({**TWO, **change})


class Platoon:
    """PLAD01 in floats: the end of a motion by exponentials, the input jumping between its ends."""

    def __init__(self, path: Path) -> None:
        self.read = tomllib.loads(path.read_text())
        rows = {mode["name"]: [self.matrix(mode["A"]), self.matrix(mode["B"])] for mode in self.read["mode"]}
        self.modes = {name: (a, b[:, 0]) for name, (a, b) in rows.items()}
        self.order, self.period = self.read["switching"]["order"], float(self.read["switching"]["period"])
        self.until, self.states = float(self.read["run"]["until"]), self.read["system"]["states"]
        (ends,) = self.read["system"]["inputs"].values()
        self.ends = [float(Fraction(str(end))) for end in ends]
        # x' = A x + b u as V diag(exp(w t)) V^-1 of x and u.
        self.spectra = {}
        for name, (a, b) in self.modes.items():
            whole = np.block([[a, b[:, None]], [np.zeros((1, len(b) + 1))]])
            w, v = np.linalg.eig(whole)
            self.spectra[name] = (w, v, np.linalg.inv(v))

    @staticmethod
    def matrix(rows: list[list[Any]]) -> Any:
        return np.array([[float(Fraction(str(x))) for x in row] for row in rows])

    def end(self, jumps: Any, end: float, first: int, exactly: bool = False) -> Any:
        """The states at a time; from the first of two ends on, the input jumps at instants."""
        jumps = np.sort(np.clip(jumps, 0.0, end))
        cuts = np.unique([0.0, *jumps, *np.arange(0.0, end, self.period), end])
        x = np.zeros(len(self.states))
        for start, stop in zip(cuts, cuts[1:], strict=False):
            middle = (start + stop) / 2
            name = self.order[int(middle / self.period) % len(self.order)]
            u = self.ends[(first + int((jumps < middle).sum())) % 2]
            a, b = self.modes[name]
            if exactly:
                whole = np.block([[a, u * b[:, None]], [np.zeros((1, len(b) + 1))]])
                x = (scipy_linalg.expm(whole * (stop - start)) @ np.append(x, 1.0))[:-1]
            else:
                w, v, inverse = self.spectra[name]
                x = (v @ (np.exp(w * (stop - start)) * (inverse @ np.append(x, u)))).real[:-1]
        return x


@pytest.fixture(scope="module")
def platoon(assets: Path) -> Platoon:
    return Platoon(assets / "systems" / "platoon_plad01.toml")


def test_worst_cases_of_a_platoon_beside_scipy(platoon: Platoon, assets: Path) -> None:
    """A short form of benches/peers/w13_reach.py, which takes a thousand starts: the witness, and an optimiser."""
    found = flockproof.reach(assets / "systems" / "platoon_plad01.toml")
    random = np.random.default_rng(13)
    for check in found[:3]:
        index = platoon.states.index(check.holds.split()[0])
        assert check.witness is not None and check.lo is not None and check.hi is not None
        end = float(Fraction(check.witness["at"]))
        values = check.witness["inputs"][0]["values"]
        jumps = [float(Fraction(pair["from"])) for pair in values[1:]]
        first = platoon.ends.index(float(Fraction(values[0]["value"])))
        lo, hi = float(check.lo), float(check.hi)
        run = platoon.end(jumps, end, first, exactly=True)[index]
        assert lo - 1e-8 <= run <= hi + 1e-8
        best = np.inf
        for _ in range(60):
            begins = int(random.integers(2))
            start = random.uniform(0, platoon.until, 4)
            least = scipy_optimize.minimize(
                lambda p, i=index, u=begins: platoon.end(p[1:], float(np.clip(p[0], 0, platoon.until)), u)[i],
                start,
                method="Nelder-Mead",
                options={"maxfev": 80},
            )
            p = least.x
            best = min(best, platoon.end(p[1:], float(np.clip(p[0], 0, platoon.until)), begins, exactly=True)[index])
        # It never comes beyond the proved worst case, and is no blunt instrument: it comes near.
        assert lo - 1e-8 <= best <= 0.95 * lo
        # From the witness itself no optimiser finds anything worse, where its input jumps at all.
        if not jumps:
            continue
        least = scipy_optimize.minimize(
            lambda p, i=index, u=first: platoon.end(p, end, u)[i], jumps, method="Nelder-Mead", options={"maxfev": 200}
        )
        assert platoon.end(least.x, end, first, exactly=True)[index] >= lo - 1e-8
