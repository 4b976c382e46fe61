# tanner1.eq7 tanner1.eq6b tanner1.eq9 tanner1.Vt_inv: agents at (0, 0), (1, 1) with velocities (0, 2), (0, 1), V = 1/s + log s, both headings pi/2: the heading rates, $(v x a)/|v|^2$; the sum of (r_i . v_i) rate_i; and the rate of V_t, by (9)
# correct: Where v_i is not 0 and no heading jumps, thetadot_i = - sum_{j~i} (theta_i - theta_j)/|r_ij|^2 - (v_i x grad_{r_i} V_i)/|v_i|^2. So Vdot_t = - theta^T L_w theta - sum_i theta_i (v_i x grad_{r_i} V_i)/|v_i|^2, which can be positive. The mechanical energy (1/2) sum_i (V_i + v_i^T v_i) is constant.
# fails: two linked agents at (0, 0) and (1, 1) with velocities (0, 2) and (0, 1), V = 1/s + log s with s the squared distance. The headings are equal, so that (7) says 0 for both rates. They are -1/4 and 1/2. The sum before (7) is 1/2, and the rate of V_t is pi/8 > 0: {V_t <= c} is left for the c of this state
# why: thetadot_i = (v_i x a_i)/|v_i|^2. The alignment force gives the printed sum, but the potential force has a part normal to v_i too and turns the heading as well. The derivation replaces a_i by omega_i x v_i in the angular momentum, in which potential forces cancel, but the part along v_i, which omega_i x v_i leaves out, has a torque of its own; and one scalar equation cannot give N of them. With the true rates the potentials add a sum of either sign to the rate of V_t. What is constant along every motion is the mechanical energy, V_t without the theta_i^2.
import numpy as np
r, v = np.array([[0, 0], [1, 1]]), np.array([[0, 2], [0, 1]])
s = 2
pull = -2 * (-1 / s**2 + 1 / s) * (r[0] - r[1])
a = np.array([pull, -pull])
rates = (v[:, 0] * a[:, 1] - v[:, 1] * a[:, 0]) / (v**2).sum(axis=1)
print(rates, (r * v).sum(axis=1) @ rates, round(np.pi / 2 * rates.sum(), 4), round(np.pi / 8, 4))  # [-0.25  0.5 ] 0.5 0.3927 0.3927

# tanner1.propIV3a: an equilateral triangle of squared side 2 that turns with omega^2 = 3/2, V = 1/s + log s: the wrapped differences of heading of agent 1 sum to 0, and the potential force on it is -omega^2 r_1
# kind: open
# correct: Neither proved nor refuted, with headings as in (2), for motions in which no agent is ever at rest.
# why: The proof of the first half of the proposition rests on the display after (9), which fails (tanner1.eq7). It may hold by another argument: the mechanical energy is no obstacle, since it can go into the common motion. If the differences theta_i - theta_j are taken modulo 2 pi, in (-pi, pi], it is false: three linked agents on an equilateral triangle that turns about its centre have headings a third of a turn apart for ever, as the alignment forces cancel.
import numpy as np
s, w = 2, 1.5**0.5
r = (s / 3)**0.5 * np.exp(2j * np.pi * np.arange(3) / 3)
v = 1j * w * r
wrapped = np.angle(v[0] / v)
force = -2 * (-1 / s**2 + 1 / s) * sum(r[0] - r[j] for j in (1, 2))
print(round(wrapped.sum(), 9) + 0.0, np.isclose(force, -w**2 * r[0]))  # 0.0 True

# tanner1.propIV3b tanner1.proof_cases: two agents at 0 and 2 with speed 2 both, along their line: the signs of V' at s = 4 and s = 1/2; least and greatest distance between the times 500 and 1000
# correct: The mechanical energy (1/2) sum_i (V_i + v_i^T v_i) is constant, and the distances need not tend to a limit. On the set of equal constant headings potential forces are along the velocities, as the proof says; neither sign of -grad_{r_i} V_i . v_i need last.
# fails: two linked agents at (0, 0) and (2, 0), both with velocity (2, 0), V = 1/s + log s: both headings stay 0, and the distance swings for ever between 0.62 and 2
# why: The alignment forces do no work, so that the mechanical energy is constant: the potential energy can settle only if the surplus goes into the common motion. Two agents that move along the line through both have equal headings for ever and no alignment force; their distance swings for ever. In each swing -grad V_1 . v_1 takes both signs, so that neither case of the proof lasts; nor does a vanishing gradient make a minimum. (In case 2 the gradient by v_i should be that by r_i.)
slope = lambda s: -1 / s**2 + 1 / s
d, u, h = 2.0, 0.0, 1e-3
force = lambda d: -4 * slope(d**2) * d
late = []
for step in range(1_000_000):
    u += h / 2 * force(d)
    d += h * u
    u += h / 2 * force(d)
    if step >= 500_000:
        late.append(d)
print(slope(4) > 0, slope(0.5) > 0, f"{min(late):.2f} {max(late):.2f}")  # True False 0.62 2.00

# tanner1.anyV: V = 0, headings 0, on a line: at 0 with speed 2 and at 1 with speed 1: the places after a unit of time
# fails: V = 0, which is symmetric: two agents that follow each other on a line with equal headings, the rear one faster, collide
# why: Every function of |r_ij| is symmetric. Collision avoidance needs V to be unbounded at 0, and cohesion needs it unbounded at infinity: the mechanical energy is constant, so that a bounded barrier is passed by a fast agent. With V = 1/(1 + s), s the squared distance, a rear agent at distance 1 that is faster by 2 has the energy 1 of relative motion, and V(0) - V(1) = 1/2. The potential that the paper proposes, 1/s + log s, has both.
print(0 + 2 * 1, 1 + 1 * 1)  # 2 2

# tanner1.Vmono: the derivative of V = 1/s + log s at s = |r_ij|^2 = 1/2
# why: A potential that repels near agents decreases with growing distance there: 1/s + log s decreases for |r_ij| < 1 and increases from there on. For the bound of distances, the use that is made of it, it is enough that V is unbounded at infinity.
s = 0.5
print(-1 / s**2 + 1 / s)  # -2.0

# tanner1.L.ones: two vertices without an edge: (1, 0) is an eigenvector of L for 0
# fails: two vertices without an edge: (1, 0) is an eigenvector for 0
# why: A graph in two pieces has further eigenvectors for 0, constant on each piece. For connected graphs the sentence is true (up to a factor), and the paper uses it for those.
import numpy as np
L = np.zeros((2, 2))
print(L @ [1, 0])  # [0. 0.]

# tanner1.collision: the path 1-2-3 with agents 1 and 3 at (1, 0) and agent 2 at 0: the potentials of the links
# why: V_t contains V_ij for linked pairs only. On the path 1-2-3 agents 1 and 3 may meet with V_t finite, and do so from suitable starts. For linked agents the conclusion is true, by the conserved mechanical energy. (The journal paper of 2007 says so: collisions are avoided between all agents if the graph is complete.)
from math import log
print(1 / 1 + log(1), 1 / 1 + log(1))  # 1.0 1.0

# tanner1.smooth: the heading (2) of velocities next to the negative x axis, below and above it; and the acceleration of the second agent along x at both, theta_2 - theta_1
# fails: linked agents at (0, 0) and (1, 0), where the paper's potential exerts no force, the second one with velocity (0, 1): when the velocity of the first one passes (-1, 0) from below the axis, theta_1 jumps from -pi to pi, and the acceleration of the second one from (3 pi/2, 0) to (-pi/2, 0)
from math import atan2
below, above, second = atan2(-1e-12, -1), atan2(1e-12, -1), atan2(1, 0)
print(f"{below:.4f} {above:.4f}")  # -3.1416 3.1416
print(f"{second - below:.4f} {second - above:.4f}")  # 4.7124 -1.5708

# tanner1.Lw: one edge: D is 2 by 1 and W is 1 by 1, so that D W D has no value
# kind: scan
# fails: one edge: D is 2 by 1 and W is 1 by 1, so that D W D is not defined
import numpy as np
D, W = np.array([[-1], [1]]), np.array([[1]])
print((D @ W).shape, D.shape)  # (2, 1) (2, 1)

# tanner1.proof_ratio: the quotients of that motion: yddot/xddot, yddot/xdot, ydot/xdot
# kind: scan
# fails: ydot = xdot at all times (k = 1) with xdot = 1, xddot = yddot = -1: yddot/xdot is -1, and ydot/xdot is 1
# why: d/dt (ydot/xdot) = 0 says yddot xdot = ydot xddot, so yddot/xddot = ydot/xdot = k where xddot != 0; the printed denominator xdot lacks a dot. On the set of equal constant headings the alignment forces vanish and the acceleration is -grad_{r_i} V_i, which gives the last quotient. (Where xdot = 0, headings along y, or xddot = 0, the equation of products says what the quotients are meant to say.)
x1, x2, y1, y2 = 1, -1, 1, -1
print(y2 / x2, y2 / x1, y1 / x1)  # 1.0 -1.0 1.0
