"""W11: a sweep of 100 000 main resonances, followers 2..41, f and g in -0.5, -0.6, .., -5.4, by the Python package, against python-control.

usage: python w11_sweep.py [MEMBERS]

Needs the package (`python3 -m pip install ./python`) and `control` with NumPy and SciPy. Ours: `flockproof.sweep` on one thread, peak and its
frequency enclosed to 15 digits, all of the table written and read. Theirs, for MEMBERS of the grid (40) spread evenly over it: the frequency response
on 2000 frequencies between 10^-3 and 10, then SciPy's bounded search around the largest to 10^-6; the time for all is that of these, multiplied.
Prints the ratio, and in how many of these members the two amplitudes differ by more than 10^-6 of ours.
"""
import sys
import time

import flockproof
from common import emit

GAINS = ["-%d/10" % k for k in range(5, 55)]
QUESTION = {
    "question": {"id": "w11.peaks"},
    "for": {"followers": "2..41", "f": GAINS, "g": GAINS},
    "values": {"peak": "peak", "frequency": "peak_frequency"},
}


def peak_of_control(followers, f, g):
    import control
    import numpy as np
    from scipy.optimize import minimize_scalar
    from w3_peak import state_space

    system = control.ss(*state_space(followers, f, g), 0)
    grid = np.logspace(-3, 1, 2000)
    k = int(np.argmax(np.abs(control.frequency_response(system, grid).frdata[0, 0])))
    ends = (grid[max(k - 1, 0)], grid[min(k + 1, len(grid) - 1)])
    return -minimize_scalar(lambda w: -abs(system(1j * w)), bounds=ends, method="bounded", options={"xatol": 1e-6}).fun


def main():
    import control

    sample = int(sys.argv[1]) if len(sys.argv) > 1 else 40
    start = time.perf_counter()
    table = flockproof.sweep(QUESTION, threads=1)
    ours = time.perf_counter() - start
    members = range(0, len(table), len(table) // sample)
    start = time.perf_counter()
    found = [peak_of_control(int(table[i]["followers"]), float(table[i]["f"]), float(table[i]["g"])) for i in members]
    theirs = (time.perf_counter() - start) * len(table) / len(found)
    differ = int(sum(abs(a / float(table[i]["peak"]) - 1) > 1e-6 for a, i in zip(found, members)))
    version = "flockproof %s, control %s" % (flockproof.__version__, control.__version__)
    emit("W11", "control_freq", version, "%d peaks" % len(table), ours, "", peer_seconds=float("%.4g" % theirs),
         ratio=float("%.3g" % (ours / theirs)), looked_at=len(found), differ=differ)


if __name__ == "__main__":
    main()
