"""W4: spectra in double precision.

usage: python w4_spectra.py CASE THREADS
CASE:
  circulant    n = 2^20, first column c_0 = 2 sum_j 1/j, c_{+-j} = -1/j, j = 1..8; numpy rfft (all
               eigenvalues follow by symmetry) ; also circulant_fft with the full complex fft
  ring_dense   n = 1000, dense Laplacian of the ring (2 on the diagonal), numpy.linalg.eigvalsh
  ring_perm    the same ring with its vertices relabelled by a Fisher-Yates shuffle (seed 4003: for
               i = n-1..1 swap p[i], p[u32 mod (i+1)]); same spectrum, and no profit
               from the almost tridiagonal shape of the plain ring
  path_tridiag n = 4000, Laplacian of the weighted path, weights 0.5 + u (n-1 draws, seed 4001),
               scipy.linalg.eigvalsh_tridiagonal
  path_family  n = 4000, the same with unit weights: a family with a closed form
  rational_full  n = 1000, symmetric, no entry zero: for i = 0..n-1, j = 0..i (seed 4004) two draws p = u32 mod 2000 - 1000 and
               q = u32 mod 997 + 1, entry (p if p < 0 else p + 1)/q; ours reads the rationals, numpy.linalg.eigvalsh has the floats
  rgg_dense    n = 500 points (x then y per point, seed 4002) in the unit square, edge if distance^2
               <= 0.08^2, self loops, rows divided by degree; numpy.linalg.eigvals (non-symmetric)
THREADS is the number of BLAS threads (set before numpy is loaded).
Building the matrix is not timed.
"""
import os
import sys

case = sys.argv[1]
threads = sys.argv[2] if len(sys.argv) > 2 else "1"
for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = threads

import math
import numpy as np
import scipy
import scipy.linalg
from common import Lcg, best_of, emit


def main():
    more = {"threads": int(threads)}
    peer, version = "numpy", "numpy " + np.__version__
    if case in ("circulant", "circulant_fft"):
        n = 1 << 20
        c = np.zeros(n)
        for j in range(1, 9):
            c[j] -= 1.0 / j
            c[n - j] -= 1.0 / j
            c[0] += 2.0 / j
        if case == "circulant":
            sec, h = best_of(lambda: np.fft.rfft(c).real, reps=5)
            lam2, lmax = h[1], h.max()
            sq = (2 * np.sum(h * h) - h[0] ** 2 - h[-1] ** 2) / n
            peer = "numpy rfft"
        else:
            sec, h = best_of(lambda: np.fft.fft(c).real, reps=5)
            lam2, lmax, sq = h[1], h.max(), np.sum(h * h) / n
            peer = "numpy fft"
        exact = sum(4.0 / j * math.sin(math.pi * j / n) ** 2 for j in range(1, 9))
        more["lambda2"] = "%.10e" % lam2
        more["lambda2_exact"] = "%.10e" % exact
        check = "max=%.10g meansq=%.10g" % (lmax, sq)
    elif case in ("ring_dense", "ring_perm"):
        n = 1000
        p = list(range(n))
        if case == "ring_perm":
            g = Lcg(4003)
            for i in range(n - 1, 0, -1):
                j = g.u32() % (i + 1)
                p[i], p[j] = p[j], p[i]
        A = 2 * np.eye(n)
        for i in range(n):
            a, b = p[i], p[(i + 1) % n]
            A[a, b] = A[b, a] = -1.0
        sec, h = best_of(lambda: np.linalg.eigvalsh(A), reps=5)
        peer = "numpy eigvalsh"
        check = "lambda2=%.8e max=%.10g sumsq=%.10g" % (h[1], h[-1], np.sum(h * h))
        more["lambda2_exact"] = "%.10e" % (4 * math.sin(math.pi / n) ** 2)
    elif case in ("path_tridiag", "path_family"):
        n = 4000
        g = Lcg(4001)
        w = np.array([0.5 + g.f64() for _ in range(n - 1)]) if case == "path_tridiag" else np.ones(n - 1)
        d = np.zeros(n)
        d[:-1] += w
        d[1:] += w
        sec, h = best_of(lambda: scipy.linalg.eigvalsh_tridiagonal(d, -w), reps=5)
        peer, version = "scipy eigvalsh_tridiagonal", "scipy " + scipy.__version__
        check = "lambda2=%.6e max=%.10g sumsq=%.10g" % (h[1], h[-1], np.sum(h * h))
    elif case == "rational_full":
        n = 1000
        g = Lcg(4004)
        A = np.zeros((n, n))
        for i in range(n):
            for j in range(i + 1):
                p, q = g.u32() % 2000 - 1000, g.u32() % 997 + 1
                A[i, j] = A[j, i] = (p if p < 0 else p + 1) / q
        sec, h = best_of(lambda: np.linalg.eigvalsh(A), reps=5)
        peer = "numpy eigvalsh"
        check = "lambda2=%.8e max=%.10g sumsq=%.10g" % (h[1], h[-1], np.sum(h * h))
    elif case == "rgg_dense":
        n = 500
        g = Lcg(4002)
        p = np.array([[g.f64(), g.f64()] for _ in range(n)])
        dd = (p[:, None, 0] - p[None, :, 0]) ** 2 + (p[:, None, 1] - p[None, :, 1]) ** 2
        A = (dd <= 0.08 ** 2).astype(float)
        more["edges"] = int((A.sum() - n) / 2)
        A /= A.sum(axis=1, keepdims=True)
        sec, h = best_of(lambda: np.linalg.eigvals(A), reps=5)
        peer = "numpy eigvals"
        h = h[np.argsort(-h.real)]
        more["max_imag"] = "%.1e" % np.max(np.abs(h.imag))
        ones = int(np.sum(h.real > 1 - 1e-9))
        more["components"] = ones
        check = "trace=%.10g sumsq=%.10g first_below_1=%.8g" % (
            h.sum().real, (h * h).sum().real, h[ones].real)
    else:
        raise SystemExit("unknown case")
    emit("W4", peer, version, "%s n=%d" % (case, n), sec, check, **more)


if __name__ == "__main__":
    main()
