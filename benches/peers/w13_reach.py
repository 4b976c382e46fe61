"""W13: worst cases of a periodic order of modes against SciPy: a simulation of the witness, and a search from random starts.

usage: python w13_reach.py [SYSTEM.toml] [STARTS] [STATE]     (default assets/systems/platoon_plad01.toml, 1000 starts, all states asked for)

Runs target/release/flockproof. Prints, for each check: the enclosure, the witness's value by DOP853 (rtol 1e-13) and how far it is from the enclosure,
and the best value of `scipy.optimize.minimize` over the end time and three instants at which the input jumps between its ends (modes solved by
`scipy.linalg.expm`). Fails where the simulation is off by more than 1e-8 or a search comes beyond the enclosure by more than 1e-8.
"""
import json
import os
import subprocess
import sys
import time
import tomllib
from fractions import Fraction

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import minimize

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
JUMPS = 3


def matrix(rows):
    return np.array([[float(Fraction(str(x))) for x in row] for row in rows])


def read(path):
    with open(path, "rb") as file:
        system = tomllib.load(file)
    modes = {mode["name"]: (matrix(mode["A"]), matrix(mode["B"])) for mode in system["mode"]}
    switching = system["switching"]
    assert switching["kind"] == "periodic" and len(system["system"]["inputs"]) == 1
    assert all(Fraction(str(x)) == 0 for x in system["system"]["start"].values())
    ends = [float(Fraction(str(x))) for x in next(iter(system["system"]["inputs"].values()))]
    return (system["system"]["states"], modes, switching["order"], float(Fraction(str(switching["period"]))), ends,
            float(system["run"]["until"]))


def at(pairs, key, t):
    return [pair[key] for pair in pairs if float(Fraction(pair["from"])) <= t][-1]


def simulated(modes, witness):
    """The states at the end of the witness, by pieces of one mode and one input."""
    end, values = float(Fraction(witness["at"])), witness["inputs"][0]["values"]
    cuts = sorted({float(Fraction(pair["from"])) for pair in witness["modes"] + values} | {end})
    x = np.zeros(next(iter(modes.values()))[0].shape[0])
    for start, stop in zip(cuts, cuts[1:]):
        if stop > end:
            break
        (a, b), u = modes[at(witness["modes"], "mode", start)], float(Fraction(at(values, "value", start)))
        rate = lambda t, x, a=a, b=b[:, 0] * u: a @ x + b
        x = solve_ivp(rate, (start, stop), x, method="DOP853", rtol=1e-13, atol=1e-13).y[:, -1]
    return x


def value(point, first, setting):
    """The states at the end: an end time, and instants at which the input jumps."""
    augmented, order, period, ends, until = setting
    end = min(max(point[0], 0.0), until)
    jumps = sorted(min(max(x, 0.0), end) for x in point[1:])
    x = np.zeros(augmented[order[0], 0].shape[0])
    x[-1] = 1.0
    cuts = sorted(set(jumps) | {k * period for k in range(int(end / period) + 1)} | {end})
    for start, stop in zip(cuts, cuts[1:]):
        if stop > end:
            break
        middle = (start + stop) / 2
        mode = order[int(middle / period) % len(order)]
        side = (first + sum(jump < middle for jump in jumps)) % 2
        x = expm(augmented[mode, side] * (stop - start)) @ x
    return x[:-1]


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "assets/systems/platoon_plad01.toml")
    starts = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    states, modes, order, period, ends, until = read(path)
    augmented = {}
    for name, (a, b) in modes.items():
        for side, u in enumerate(ends):
            augmented[name, side] = np.block([[a, b * u], [np.zeros((1, a.shape[0] + 1))]])
    setting = (augmented, order, period, ends, until)
    binary = os.path.join(ROOT, "target/release/flockproof")
    answer = json.loads(subprocess.run([binary, "reach", path, "--json"], capture_output=True, text=True).stdout)
    random = np.random.default_rng(13)
    seen, failed = set(), False
    for check in answer["checks"]:
        left, relation, _ = check["holds"].split()
        if left in seen or left not in (sys.argv[3:4] or states):
            continue
        seen.add(left)
        index, sign = states.index(left), 1.0 if relation == ">=" else -1.0
        lo, hi = float(check["worst"]["lo"]), float(check["worst"]["hi"])
        run = simulated(modes, check["witness"])[index]
        begun, best = time.perf_counter(), np.inf
        for _ in range(starts):
            first = int(random.integers(2))
            point = random.uniform(0, until, JUMPS + 1)
            found = minimize(lambda p: sign * value(p, first, setting)[index], point, method="Nelder-Mead", options={"maxfev": 120})
            best = min(best, found.fun)
        beyond = (lo if sign > 0 else -hi) - best
        failed |= not lo - 1e-8 <= run <= hi + 1e-8 or beyond > 1e-8
        print(json.dumps({"check": left, "lo": lo, "hi": hi, "simulated": run, "off": max(lo - run, run - hi, 0.0),
                          "starts": starts, "best_found": sign * best, "beyond": beyond, "seconds": round(time.perf_counter() - begun, 1)}))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
