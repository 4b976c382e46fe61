# tanner2.appA_uniq: f = -1 for x < 0 and 0 for x >= 0: x = -t has the rate f(x) and so has x = 0: two solutions from 0
f = lambda x: -1 if x < 0 else 0
print([f(-t) for t in (0.1, 1, 10)], f(0))  # [-1, -1, -1] 0

# tanner2.arbswitch: the determinant of Cayley and Menger for four points with all six distances 1: 0 for points of a plane
import numpy as np
print(round(np.linalg.det(np.ones((5, 5)) - np.eye(5))))  # 4

# tanner2.cor2_rate: two agents, lambda_2 = 2, V = k (s + 1/s - 2): x'' + 2 x' + 16 k x = 0: the slowest rates for k = 1 and k = 1/32
import numpy as np
print(*(f"{-max(np.roots([1, 2, 16 * k]).real):.3f}" for k in (1, 1 / 32)))  # 1.000 0.293

# tanner2.eq10_exist: two agents at rest at the distance R = 2, V = s + 1/s - 2: V' at s = R^2 > 0: linked they approach, not linked they rest
print(1 - 1 / 4**2)  # 0.9375

# tanner2.lem1: U at R = 2 for V = s + 1/s - 2: the quotient from R outwards is U', that from below R to R bounds U°(R; 1) from below
U = lambda r: min(r, 2)**2 + 1 / min(r, 2)**2 - 2
h = 1e-6
print(f"{(U(2 + h) - U(2)) / h:.2f} {(U(2) - U(2 - h)) / h:.2f}")  # 0.00 3.75

# tanner2.lem2: slopes of U on both sides of R = 2: their hull [0, 3.75] is the generalised gradient, which is not empty
U = lambda r: min(r, 2)**2 + 1 / min(r, 2)**2 - 2
h = 1e-6
print(f"{(U(2 + 2 * h) - U(2 + h)) / h:.2f} {(U(2 - h) - U(2 - 2 * h)) / h:.2f}")  # 0.00 3.75

# tanner2.sec4.flocking: the path 1-2-3 at (1, 0), (0, 0), (1, 0), V = s + 1/s - 2: the forces along x; agents 1 and 3 are in one place
slope = lambda s: 1 - 1 / s**2
x = [1, 0, 1]
force = lambda i, j: -2 * slope((x[i] - x[j])**2) * (x[i] - x[j])
print(force(0, 1), force(1, 0) + force(1, 2), force(2, 1))  # -0.0 0.0 -0.0

# tanner2.thm1c: three linked agents at -1, 0, 1, V = 4/(3 s) + log s: the force on agent 1, and its potential here and when it moves aside by 0.1
from math import log
m = 4 / 3
V, slope = lambda s: m / s + log(s / m), lambda s: -m / s**2 + 1 / s
print(round(-2 * slope(1) * -1 - 2 * slope(4) * -2, 12) + 0.0, V(1.01) + V(4.01) < V(1) + V(4))  # 0.0 True

# tanner2.thm2_pot: the same three agents with R = 3: all pairs are linked, V increases at R, they rest, and the potential of agent 1 is not least
from math import log
m = 4 / 3
V, slope = lambda s: m / s + log(s / m), lambda s: -m / s**2 + 1 / s
print(slope(9) > 0, round(-2 * slope(1) * -1 - 2 * slope(4) * -2, 12) + 0.0, V(1.01) + V(4.01) < V(1) + V(4))  # True 0.0 True

# tanner2.bound_r: three agents in a row, 2 apart, linked 1-2-3, at rest, V = s + 1/s - 2: W = c, and V_13 at |r_13| = 4 against c (N - 1)
V = lambda s: s + 1 / s - 2
c = V(4) + V(4)
print(c, V(16), 2 * c, V(16) <= 2 * c)  # 4.5 14.0625 9.0 False

# tanner2.bound_v: one agent of speed 1: W = c = 1/2, and its speed squared
v = 1.0
print(v**2 / 2, v**2)  # 0.5 1.0

# tanner2.eq13.interval: two linked agents with equal velocities: the right side of (13) is the number 0, no e < 0
import numpy as np
v, L = np.array([1, 1]), np.array([[1, -1], [-1, 1]])
print(v @ L @ v)  # 0

# tanner2.vdotB: agents at (1, 1), (1, -1), V' = 1: the acceleration of agent 1 along y, and -(B grad V) with -1 for the outgoing edge
gradient = 2 * 1 * (1 - -1)
print(-gradient, -(-1 * gradient))  # -4 4

# tanner2.cor1: V' = (s - 1)(s - 4)^2 (s + 2/3)/s^2 at s = 3, 4, 5: two agents at rest at |r|^2 = 4 stay, and V is not least there
slope = lambda s: (s - 1) * (s - 4)**2 * (s + 2 / 3) / s**2
print(slope(3) > 0, slope(4), slope(5) > 0)  # True 0.0 True

# tanner2.S_config: two linked agents 3/2 apart with equal velocities: dW/dt = -|v_1 - v_2|^2 vanishes, and r_12 does not
print(-(1 - 1)**2, 1.5)  # 0 1.5

# tanner2.cor2_sub: two agents with the same velocity 1 along x: dW/dt = -v L v, and the bound -lambda_2 |v_p|^2 with v_p = v
import numpy as np
v, L = np.array([1, 1]), np.array([[1, -1], [-1, 1]])
print(v @ L @ v, -2 * (v @ v))  # 0 -4

# tanner2.eq2: two opposite velocities: arctan of the quotient, and the two headings
from math import atan, atan2
print(f"{atan(1 / 1) == atan(-1 / -1)} {atan2(1, 1):.3f} {atan2(-1, -1):.3f}")  # True 0.785 -2.356
