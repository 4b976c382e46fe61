# tanner1.Vt_inv: agents at (0, 0), (1, 1) with velocities (0, 2), (0, 1), V = 1/s + log s, both headings pi/2: the rate of V_t is (pi/2) times the sum of the heading rates
import numpy as np
r, v = np.array([[0, 0], [1, 1]]), np.array([[0, 2], [0, 1]])
s = 2
pull = -2 * (-1 / s**2 + 1 / s) * (r[0] - r[1])
a = np.array([pull, -pull])
rates = (v[:, 0] * a[:, 1] - v[:, 1] * a[:, 0]) / (v**2).sum(axis=1)
print(rates, rates.sum() > 0)  # [-0.25  0.5 ] True

# tanner1.anyV: V = 0, headings 0, on a line: at 0 with speed 2 and at 1 with speed 1: the places after a unit of time
print(0 + 2 * 1, 1 + 1 * 1)  # 2 2

# tanner1.eq6b: the state of the erratum on V_t: agents at (0, 0), (1, 1), velocities (0, 2), (0, 1), heading rates -1/4, 1/2: the sum of (r_i . v_i) (rate + 0)
print((0 * 0 + 0 * 2) * -0.25 + (1 * 0 + 1 * 1) * 0.5)  # 0.5

# tanner1.eq7: agents at (0, 0), (1, 1) with velocities (0, 2), (0, 1), equal headings, V = 1/s + log s: the rate of the first heading, (v x a)/|v|^2
s = 2
a = -2 * (-1 / s**2 + 1 / s) * -1
print((0 * a - 2 * a) / 2**2)  # -0.25

# tanner1.eq9: the same state: theta^T L_w theta = 0, as the headings are equal, and the sum of theta_i times the rates -1/4 and 1/2
from math import pi
print((pi / 2) * (-0.25 + 0.5) > 0)  # True

# tanner1.proof_cases: V' at s = 4 and at s = 1/2, which two agents on a line pass in every swing: V' and with it -grad V . v has both signs
slope = lambda s: -1 / s**2 + 1 / s
print(slope(4), slope(0.5))  # 0.1875 -2.0

# tanner1.propIV3b: two agents at 0 and 2 with speed 2 both, along their line: least and greatest distance between the times 500 and 1000
d, u, h = 2.0, 0.0, 1e-3
force = lambda d: -4 * (-1 / d**4 + 1 / d**2) * d
late = []
for step in range(1_000_000):
    u += h / 2 * force(d)
    d += h * u
    u += h / 2 * force(d)
    if step >= 500_000:
        late.append(d)
print(f"{min(late):.2f} {max(late):.2f}")  # 0.62 2.00

# tanner1.Vmono: the derivative of V = 1/s + log s at s = |r_ij|^2 = 1/2
s = 0.5
print(-1 / s**2 + 1 / s)  # -2.0

# tanner1.L.ones: two vertices without an edge: (1, 0) is an eigenvector of L for 0
import numpy as np
L = np.zeros((2, 2))
print(L @ [1, 0])  # [0. 0.]

# tanner1.collision: the path 1-2-3 with agents 1 and 3 at (1, 0) and agent 2 at 0: the potentials of the links
from math import log
print(1 / 1 + log(1), 1 / 1 + log(1))  # 1.0 1.0

# tanner1.smooth: the heading (2) of velocities next to the negative x axis, below and above
from math import atan2
print(f"{atan2(-1e-12, -1):.4f} {atan2(1e-12, -1):.4f}")  # -3.1416 3.1416

# tanner1.Lw: one edge: D is 2 by 1 and W is 1 by 1, so that D W D has no value
import numpy as np
D, W = np.array([[-1], [1]]), np.array([[1]])
print((D @ W).shape, D.shape)  # (2, 1) (2, 1)
