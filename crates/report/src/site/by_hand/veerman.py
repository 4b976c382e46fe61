# veerman.gain_max: |1/gamma|^2 at w^2 = |f| = 1 and at w^2 = 3/4
from fractions import Fraction as F
f = g = F(-1)
gain2 = lambda y: (f**2 + g**2 * y) / ((y - abs(f))**2 + g**2 * y)
print(gain2(F(1)), gain2(F(3, 4)))  # 2 28/13

# veerman.table1_numeric: the largest amplitude of the last of N = 4 followers of system (2), and where; 0.2776801836 and 4.58527335 are printed
import numpy as np
def last(w, n, f=-1, g=-1):
    P = np.eye(n) - (np.eye(n, k=1) + np.eye(n, k=-1)) / 2
    P[-1, -2] = -1
    c = f + 1j * w * g
    return abs(np.linalg.solve(-w**2 * np.eye(n) - c * P, -c / 2 * np.eye(n)[0])[-1])
w = np.arange(0.25, 0.30, 1e-5)
a = [last(x, 4) for x in w]
print(f"{w[np.argmax(a)]:.4f} {max(a):.4f}")  # 0.2731 4.6549

# veerman.thm1_eps: the real part of the coefficient of w^2/2 in the bracket, f = g = -1; the printed one is -g^2/f^2 - 1/(2|f|) = -1.5
import cmath
w = 1e-3
gamma = 1 + w**2 / (-1 - 1j * w)
bracket = cmath.sqrt(gamma**2 - 1) / (1j * 2**0.5 * w)
print(round(((bracket - (1 - 1j * w / 2)) / (w**2 / 2)).real, 3))  # -1.25

# veerman.gain_iff: |1/gamma|^2 at w = 0 for f = g = -1: not greater than one, although 0 < 2|f|
f = g = -1
y = 0
print((f**2 + g**2 * y) / ((y - abs(f))**2 + g**2 * y))  # 1.0

# veerman.nth_neighbour: whom a chain of n-th neighbours joins to the leader, number 0, for n = 1 and n = 2
print(*(list(range(0, 6, n)) for n in (1, 2)))  # [0, 1, 2, 3, 4, 5] [0, 2, 4]

# veerman.specM: one follower of system (1), f = 0, g = -1: the union on the right contains 0, the left side leaves it out
import numpy as np
print(sorted(np.linalg.eigvals([[0.0, 1.0], [0.0, -1.0]])) == [-1, 0])  # True

# veerman.prop1: |1/gamma|^2 at the frequency w = |f| = 4 (g = -1): below one, so that nothing limits N
f, g, w = -4, -1, 4
print((f**2 + g**2 * w**2) / ((w**2 - abs(f))**2 + g**2 * w**2))  # 0.2

# veerman.sep_remark: a0 = 2 and gamma^-k e^(iwt) = gamma^-(k+1) e^(iwt) = 1: both cars are displaced by 2, their distance is 1
a0, h = 2, 1
print((h + a0) - a0, a0 * 1 - a0 * (1 + 1))  # 1 -2

# veerman.table1_theory: Theorem 1 for four followers, f = g = -1: what NFREQ and NAMP print
from math import pi, sqrt
print(f"{pi / (2 * sqrt(2) * 4):.10f} {8 * sqrt(2) * 4 / pi**2:.8f}")  # 0.2776801836 4.58527335

# veerman.thm1_x: A x/M at the principal resonance for M = 400 followers, f = -2, g = -1/2, with sqrt|f| and with the printed |f|
import numpy as np
f, g, M = -2.0, -0.5, 400
w = np.sqrt(-f) * np.pi / (2 * np.sqrt(2) * M)
P = np.eye(M) - (np.eye(M, k=1) + np.eye(M, k=-1)) / 2
P[-1, -2] = -1
c = f + 1j * w * g
A = abs(np.linalg.solve(-w**2 * np.eye(M) - c * P, -c / 2 * np.eye(M)[0])[-1])
x = lambda root: np.pi**2 * abs(g) / (8 * np.sqrt(2) * root)
print(f"{A * x(np.sqrt(-f)) / M:.3f} {A * x(-f) / M:.3f}")  # 1.000 0.707
