"""W9: the network log of a flock of the plane, 1000 birds and 10 000 steps.

usage: python w9_flock_log.py PEER N STEPS       (PEER: numba, a cell list in double precision, one thread)

Box of side floor(1024 sqrt(N/2.5)) / 1024; per bird four draws (u32, seed N): the position is (u1 mod side, u2 mod side)/1024 with side in
units of 1/1024, the velocity ((u3 mod 1024) - 512, (u4 mod 1024) - 512)/8192.
Lazy weights, no hysteresis: x(t) = x(t-1) + v(t); i ~ j iff |x_i(t) - x_j(t)| <= 1; v_i(t+1) = v_i/3 + 2/(3 d_i) times
the sum over the neighbours, an isolated bird keeps its velocity. Checksum: sha256 of the changed pairs, `t:i-j` joined by commas in
the order of t, then of the larger and the smaller bird (from 0). Double precision may be wrong at ties: `ties` counts the pairs of birds and
times with | |x_i - x_j|^2 - 1 | < 1e-12, in a run that is not timed, and `log` is what the checksum is of, so that logs that differ
can be compared entry by entry. Compilation time of numba is not counted.
"""
import sys

import numpy as np
from common import Lcg, best_of, emit, sha


def start(n):
    side = int((n / 2.5) ** 0.5 * 1024)
    g = Lcg(n)
    x = np.empty((n, 2))
    v = np.empty((n, 2))
    for i in range(n):
        x[i] = [(g.u32() % side) / 1024 for _ in range(2)]
        v[i] = [((g.u32() % 1024) - 512) / 8192 for _ in range(2)]
    return x, v


def make():
    import numba as nb

    @nb.njit
    def run(x, v, steps, counting):
        n = x.shape[0]
        ties = 0
        most = 64
        near = np.zeros((n, most), np.int64)
        degree = np.zeros(n, np.int64)
        old = np.zeros((n, most), np.int64)
        old_degree = np.zeros(n, np.int64)
        log = [(0, 0, 0)]
        next_v = np.empty_like(v)
        for t in range(steps + 1):
            if t > 0:
                x += v
            # cells of side 1, not more than four a bird
            x0 = x[:, 0].min()
            y0 = x[:, 1].min()
            width = max(1.0, ((x[:, 0].max() - x0) * (x[:, 1].max() - y0) / (4 * n)) ** 0.5)
            nx = int((x[:, 0].max() - x0) / width) + 1
            ny = int((x[:, 1].max() - y0) / width) + 1
            head = np.full(nx * ny, -1, np.int64)
            following = np.empty(n, np.int64)
            for i in range(n):
                c = int((x[i, 1] - y0) / width) * nx + int((x[i, 0] - x0) / width)
                following[i] = head[c]
                head[c] = i
            for i in range(n):
                degree[i] = 0
            for cy in range(ny):
                for cx in range(nx):
                    i = head[cy * nx + cx]
                    while i >= 0:
                        # the rest of this cell, and half of the cells around
                        for k in range(5):
                            if k == 0:
                                j = following[i]
                            else:
                                dx = cx + (1 if k == 1 else k - 3)
                                dy = cy + (0 if k == 1 else 1)
                                j = head[dy * nx + dx] if 0 <= dx < nx and dy < ny else -1
                            while j >= 0:
                                a = x[i, 0] - x[j, 0]
                                b = x[i, 1] - x[j, 1]
                                if counting and abs(a * a + b * b - 1.0) < 1e-12:
                                    ties += 1
                                if a * a + b * b <= 1.0:
                                    near[i, degree[i]] = j
                                    degree[i] += 1
                                    near[j, degree[j]] = i
                                    degree[j] += 1
                                j = following[j]
                        i = following[i]
            if t > 0:
                for i in range(n):
                    for k in range(degree[i]):
                        j = near[i, k]
                        if j < i:
                            known = False
                            for m in range(old_degree[i]):
                                known |= old[i, m] == j
                            if not known:
                                log.append((t, i, j))
                    for m in range(old_degree[i]):
                        j = old[i, m]
                        if j < i:
                            stays = False
                            for k in range(degree[i]):
                                stays |= near[i, k] == j
                            if not stays:
                                log.append((t, i, j))
            for i in range(n):
                old_degree[i] = degree[i]
                for k in range(degree[i]):
                    old[i, k] = near[i, k]
            if t > 0:
                for i in range(n):
                    d = degree[i]
                    if d == 0:
                        next_v[i, 0] = v[i, 0]
                        next_v[i, 1] = v[i, 1]
                        continue
                    a = 0.0
                    b = 0.0
                    for k in range(d):
                        a += v[near[i, k], 0]
                        b += v[near[i, k], 1]
                    c = 2.0 / (3.0 * d)
                    next_v[i, 0] = v[i, 0] / 3.0 + c * a
                    next_v[i, 1] = v[i, 1] / 3.0 + c * b
                v, next_v = next_v, v
        return log, ties

    return run


def main():
    n, steps = int(sys.argv[2]), int(sys.argv[3])
    import numba
    x, v = start(n)
    run = make()
    run(x.copy(), v.copy(), 2, False)
    sec, (log, _) = best_of(lambda: run(x.copy(), v.copy(), steps, False), reps=2)
    ties = run(x.copy(), v.copy(), steps, True)[1]
    log = sorted(log[1:])
    text = ",".join("%d:%d-%d" % entry for entry in log)
    emit("W9", sys.argv[1], "numba " + numba.__version__, "n=%d,steps=%d" % (n, steps), sec, sha(text), changes=len(log), ties=ties, log=text)


if __name__ == "__main__":
    main()
