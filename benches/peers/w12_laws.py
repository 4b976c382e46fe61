"""W12: laws of one's own against the same laws written by hand.

usage: python w12_laws.py PEER CASE
CASE: all     Cucker and Smale, K = 1, beta = 1/4, mean over all others: 2000 agents, 100 steps of order four, dt = 0.01
      near    the same, a sum over those within distance 2: 20 000 agents, 20 steps
      three   three agents to t = 40, tolerance 1e-10
PEER: numba (by hand for this law, two threads, fast mathematics, the fourth root by two square roots), dop853 (SciPy, right-hand side by numba),
      heyoka (Taylor series compiled for the law)

Start: as in W6 (a lattice of 50 x 40 or 200 x 100); of three agents x = (0,0), (1,0), (0,2), v = (1,0), (0,1), (0,0).
Compilation is not counted.
"""
import os
import sys

import numpy as np
from common import best_of, emit
from w6_flock2d import start

# W6 runs on one thread; numba, which is imported below, on two here.
os.environ["NUMBA_NUM_THREADS"] = "2"

R, DT = 2.0, 0.01


def make_all():
    import numba as nb

    @nb.njit(parallel=True, fastmath=True)
    def rate(y, out):
        n = y.shape[1]
        for i in nb.prange(n):
            ax = 0.0
            ay = 0.0
            x0, x1, v0, v1 = y[0, i], y[1, i], y[2, i], y[3, i]
            for j in range(n):
                dx = y[0, j] - x0
                dy = y[1, j] - x1
                w = 1.0 / np.sqrt(np.sqrt(1.0 + dx * dx + dy * dy))
                ax += w * (y[2, j] - v0)
                ay += w * (y[3, j] - v1)
            out[0, i] = v0
            out[1, i] = v1
            out[2, i] = ax / (n - 1)
            out[3, i] = ay / (n - 1)
    return rate


def make_near():
    import numba as nb

    @nb.njit(parallel=True, fastmath=True)
    def rate(y, out):
        n = y.shape[1]
        x0 = y[0].min()
        y0 = y[1].min()
        nx = int((y[0].max() - x0) / R) + 1
        ny = int((y[1].max() - y0) / R) + 1
        cell = np.empty(n, np.int64)
        begin = np.zeros(nx * ny + 1, np.int64)
        for i in range(n):
            c = int((y[1, i] - y0) / R) * nx + int((y[0, i] - x0) / R)
            cell[i] = c
            begin[c + 1] += 1
        for c in range(nx * ny):
            begin[c + 1] += begin[c]
        fill = begin[:-1].copy()
        order = np.empty(n, np.int64)
        p = np.empty((4, n))
        for i in range(n):
            k = fill[cell[i]]
            fill[cell[i]] = k + 1
            order[k] = i
            for d in range(4):
                p[d, k] = y[d, i]
        for row in nb.prange(ny):
            for cx in range(nx):
                c = row * nx + cx
                lox = max(cx - 1, 0)
                hix = min(cx + 1, nx - 1)
                for k in range(begin[c], begin[c + 1]):
                    ax = 0.0
                    ay = 0.0
                    for other in range(max(row - 1, 0), min(row + 1, ny - 1) + 1):
                        for m in range(begin[other * nx + lox], begin[other * nx + hix + 1]):
                            dx = p[0, m] - p[0, k]
                            dy = p[1, m] - p[1, k]
                            s = dx * dx + dy * dy
                            if s <= R * R:
                                w = 1.0 / np.sqrt(np.sqrt(1.0 + s))
                                ax += w * (p[2, m] - p[2, k])
                                ay += w * (p[3, m] - p[3, k])
                    i = order[k]
                    out[0, i] = p[2, k]
                    out[1, i] = p[3, k]
                    out[2, i] = ax
                    out[3, i] = ay
    return rate


def make_rk4(rate):
    import numba as nb

    @nb.njit(fastmath=True)
    def run(y, steps):
        k1, k2, k3, k4 = np.empty_like(y), np.empty_like(y), np.empty_like(y), np.empty_like(y)
        for _ in range(steps):
            rate(y, k1)
            rate(y + DT / 2 * k1, k2)
            rate(y + DT / 2 * k2, k3)
            rate(y + DT * k3, k4)
            y = y + DT / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        return y
    return run


def checksum(y):
    speed = np.sum(y[2] ** 2 + y[3] ** 2) / (2 * y.shape[1])
    return "kinetic=%.9f x0=%.8f" % (speed, y[0, 0])


def large(case):
    import numba as nb
    n, steps = {"all": (2000, 100), "near": (20000, 20)}[case]
    x, v = start(n)
    y = np.ascontiguousarray(np.concatenate([x.T, v.T]))
    run = make_rk4(make_all() if case == "all" else make_near())
    run(y, 1)
    seconds, out = best_of(lambda: run(y, steps))
    emit("W12", "numba", nb.__version__, "%s N=%d,steps=%d" % (case, n, steps), seconds, checksum(out))


X3 = np.array([0.0, 0.0, 1.0, 0.0, 0.0, 2.0])
V3 = np.array([1.0, 0.0, 0.0, 1.0, 0.0, 0.0])


def three_scipy():
    import numba as nb
    import scipy
    from scipy.integrate import solve_ivp

    @nb.njit
    def rate(t, y):
        out = np.empty(12)
        out[:6] = y[6:]
        for i in range(3):
            ax = 0.0
            ay = 0.0
            for j in range(3):
                if j != i:
                    dx = y[2 * j] - y[2 * i]
                    dy = y[2 * j + 1] - y[2 * i + 1]
                    w = 1.0 / np.sqrt(np.sqrt(1.0 + dx * dx + dy * dy))
                    ax += w * (y[6 + 2 * j] - y[6 + 2 * i])
                    ay += w * (y[7 + 2 * j] - y[7 + 2 * i])
            out[6 + 2 * i] = ax / 2
            out[7 + 2 * i] = ay / 2
        return out

    y = np.concatenate([X3, V3])
    rate(0.0, y)
    seconds, out = best_of(lambda: solve_ivp(rate, (0, 40), y, method="DOP853", rtol=1e-10, atol=1e-10))
    emit("W12", "scipy_dop853", scipy.__version__, "three t=40", seconds, "x0=%.7f" % out.y[0, -1])


def three_heyoka():
    import heyoka as hy
    names = ["x%d%d" % (i, d) for i in range(3) for d in range(2)] + ["v%d%d" % (i, d) for i in range(3) for d in range(2)]
    s = dict(zip(names, hy.make_vars(*names)))
    system = [(s["x%d%d" % (i, d)], s["v%d%d" % (i, d)]) for i in range(3) for d in range(2)]
    for i in range(3):
        for d in range(2):
            terms = []
            for j in range(3):
                if j != i:
                    square = sum((s["x%d%d" % (j, e)] - s["x%d%d" % (i, e)]) ** 2 for e in range(2))
                    terms.append((1.0 + square) ** -0.25 * (s["v%d%d" % (j, d)] - s["v%d%d" % (i, d)]))
            system.append((s["v%d%d" % (i, d)], (terms[0] + terms[1]) / 2.0))
    y = np.concatenate([X3, V3])
    taylor = hy.taylor_adaptive(system, y, tol=1e-10)

    def run():
        taylor.time = 0.0
        taylor.state[:] = y
        taylor.propagate_until(40.0)
        return taylor.state.copy()
    seconds, out = best_of(run)
    emit("W12", "heyoka", hy.__version__, "three t=40", seconds, "x0=%.7f" % out[0])


if __name__ == "__main__":
    peer, case = sys.argv[1:3]
    if case != "three":
        large(case)
    elif peer == "dop853":
        three_scipy()
    else:
        three_heyoka()
