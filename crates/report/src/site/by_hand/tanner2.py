# tanner2.appA_uniq: f = -1 for x < 0 and 0 for x >= 0: x = -t has the rate f(x) and so has x = 0: two solutions from 0
f = lambda x: -1 if x < 0 else 0
print([f(-t) for t in (0.1, 1, 10)], f(0))  # [-1, -1, -1] 0

# tanner2.arbswitch: the determinant of Cayley and Menger for four points with all six distances 1: 0 for points of a plane
# why: Q is no Lyapunov function for a switch that does not happen at |r_ij| = R: there energy may jump up. Suppose that in the example the velocities agreed in the limit. Take an edge of the path in use, the difference d of its ends, and the sum Y of v - mean over the agents on its side of the path. Forces within a side cancel, so that Ydot = -ddot - 2 V'(|d|^2) d, and d.Y has the rate -(2|d|^2 - 2/|d|^2) but for terms that tend to 0 like the velocities: at most e(1 + |d|), e small. Over one period T the vector d changes by at most e. If |d| stayed off 1 by a fixed amount, that rate would be off 0 all the period long, by at least a multiple of 1 + |d|, and d.Y, which is at most e |d|, could not follow it. So the three distances in use tend to 1, and at the ends of the periods those of the other path too: all six, which is impossible in the plane. So the velocities never agree, from any start. What Section 5 analyses is switching by distance.
import numpy as np
print(round(np.linalg.det(np.ones((5, 5)) - np.eye(5))))  # 4

# tanner2.cor2_rate: two agents, lambda_2 = 2, V = k (s + 1/s - 2), x the deviation of their distance from 1: x'' + 2 x' + 16 k x = 0: its slowest rates for k = 1 and k = 1/32 (across the line through both the relative velocity decays at the rate 2)
# fails: two agents, lambda_2 = 2, V = k (s + 1/s - 2), s the squared distance: with k = 1 every mode (but those of rate 0) decays faster than exp(-t/2), with k = 1/32 not
# why: dW/dt <= -lambda_2 |v^n|^2 bounds how fast energy is lost at a given disagreement, not how fast W or the velocities tend to their limits: that depends on the potentials too. Near an equilibrium a mode obeys x'' + l x' + h x = 0, with l from the Laplacian and h from the potentials; for h small its rate is about h/l, which decreases as l grows. Two agents have rates above and below 1/2 for different potentials at the same lambda_2 = 2, and closing the path of three to a triangle raises lambda_2 from 1 to 3 and lowers the rate. (Modes of rate 0, which keep the shape or move it along equilibria, are left out.) Without potentials lambda_2 is the rate, as the corollary has it.
import numpy as np
print(*(f"{-max(np.roots([1, 2, 16 * k]).real):.3f}" for k in (1, 1 / 32)))  # 1.000 0.293

# tanner2.eq10_exist: two agents at rest at the distance R = 2, V = s + 1/s - 2: V' at s = R^2 > 0: linked they approach, not linked they rest
print(1 - 1 / 4**2)  # 0.9375

# tanner2.lem1 tanner2.lem2: U at R = 2 for V = s + 1/s - 2: the quotient from R outwards is U', that from below R to R bounds U°(R; 1) from below
# correct: Let V have a continuous derivative and c > 0, with c the derivative of V_ij with respect to the distance, at R. Then at R the one-sided derivative is $U'(R; w) = min(0, c w)$ and the generalised one is U°(R; w) = max(0, c w): U_ij is regular at every distance but R, and the function -U_ij is regular at R too. The generalised gradient of U_ij at R is the interval $[0, c]$ as a function of the distance, and with respect to r_i, at |r_ij| = R, the segment from 0 to grad_{r_i} V_ij.
# fails: V = s + 1/s - 2 with s = r^2, R = 2, w = 1: U'(R; w) = 0, but U°(R; w) = 15/4. The generalised gradient of U at R is [0, 15/4], and not empty
# why: One-sided: U'(R; w) is 0 for w > 0 and c w for w < 0. Generalised: base points y < R give quotients that tend to c w, base points y > R give 0, and U°(R; w) is the larger one: it differs from U'(R; w) in both directions. The printed proof bounds U(y') by V_R, but for w > 0 then puts V_R for U(y' - t w) too, as if y' - t w >= R, and for w < 0 overlooks y > R. A kink where an increasing function becomes flat is concave; what is regular there is -U. The generalised gradient of a Lipschitz function is never empty (Clarke); the proof of Lemma 2 puts U' in the place of U°.
U = lambda r: min(r, 2)**2 + 1 / min(r, 2)**2 - 2
h = 1e-6
print(f"{(U(2 + h) - U(2)) / h:.2f} {(U(2) - U(2 - h)) / h:.2f}")  # 0.00 3.75

# tanner2.thm1c: three linked agents at -1, 0, 1, V = 4/(3 s) + log s: the force on agent 1, and its potential here and when it moves aside by 0.1
# fails: three agents at rest at (-1, 0), (0, 0), (1, 0), all linked, $V = m/s + log(s/m)$ with s the squared distance and m = 4/3: the agents stay there, though the potential of agent 1 is not least: it decreases when that agent moves aside
# why: The proof shows grad V_i = 0, which is what the corrected statement says. Three agents at rest in a row with all pairs linked are in equilibrium where 2 V'(a^2) a + 4 V'(4a^2) a = 0; with $V = m/s + log(s/m)$ this is a^2 = 3m/4. Agent 1 sits at a saddle of its own potential. By symmetry every start in a row with velocities along it stays in a row, so that a whole set of starts tends to such points. (Also: with four or more agents, all linked and with one desired distance, no configuration in the plane makes all V_ij least at once.)
from math import log
m = 4 / 3
V, slope = lambda s: m / s + log(s / m), lambda s: -m / s**2 + 1 / s
print(round(-2 * slope(1) * -1 - 2 * slope(4) * -2, 12) + 0.0, V(1.01) + V(4.01) < V(1) + V(4))  # 0.0 True

# tanner2.thm2_pot: the same three agents with R = 3: all pairs are linked, V increases at R, they rest, and the potential of agent 1 is not least
# fails: the three agents of tanner2.thm1c, at rest at (-1, 0), (0, 0), (1, 0) with $V = m/s + log(s/m)$, m = 4/3, and R = 3: all pairs are linked, the agents stay there, and the potential of agent 1 is not least: it decreases when that agent moves aside
# why: With R = 3 every pair is linked at distances up to 2, V is increasing at R, and the agents stay at rest. What survives is proved so. Call a pair at the distance R a tie. Along a Filippov solution the law holds at almost every time with a weight m_e in [0, 1] on each tie e, and m_e = 1 on the links. At almost every time at which |r_e| = R also d/dt |r_e|^2 = 0, so that the potential forces of ties do no work and dQ/dt = -sum_e m_e |v_e|^2 over links and ties, v_e the difference of velocities. (Q is not regular, tanner2.lem1, but -Q is, and the chain rule of Theorem 4 for -Q gives the same.) The links alone are a connected graph, so that dQ/dt <= -l |v - mean|^2 with l > 0 the least lambda_2 of a connected graph on N vertices. So |v - mean|^2 is integrable, and its rate is bounded: it tends to 0. Limit sets of Filippov solutions are weakly invariant: through each of their points goes a solution within them. On it velocities agree for all time, so that all accelerations are equal and, as their sum is 0, vanish: 0 lies in K[(grad_{r_i} V_i)_i].
from math import log
m = 4 / 3
V, slope = lambda s: m / s + log(s / m), lambda s: -m / s**2 + 1 / s
print(slope(9) > 0, round(-2 * slope(1) * -1 - 2 * slope(4) * -2, 12) + 0.0, V(1.01) + V(4.01) < V(1) + V(4))  # True 0.0 True

# tanner2.bound_r: three agents in a row, 2 apart, linked 1-2-3, at rest, V = s + 1/s - 2: W = c, and V_13 at |r_13| = 4 against c (N - 1)
# fails: three agents in a row, 2 apart, linked 1-2-3, at rest, V = s + 1/s - 2: W = c = 9/2, and |r_13|^2 = 16, but V <= c(N - 1) = 9 only for |r|^2 < 11
V = lambda s: s + 1 / s - 2
c = V(4) + V(4)
print(c, V(16), 2 * c, V(16) <= 2 * c)  # 4.5 14.0625 9.0 False

# tanner2.bound_v: one agent of speed 1: W = c = 1/2, and its speed squared
# fails: one agent of speed 1: W = c = 1/2, and |v|^2 = 1
v = 1.0
print(v**2 / 2, v**2)  # 0.5 1.0

# tanner2.eq13.interval: two linked agents with equal velocities: the right side of (13) is the number 0, no e < 0
# fails: two linked agents with equal velocities: the right side of (13) is {0}, which is no [e, 0] with e < 0
import numpy as np
v, L = np.array([1, 1]), np.array([[1, -1], [-1, 1]])
print(v @ L @ v)  # 0

# tanner2.vdotB: agents at (1, 1), (1, -1), V' = 1: the acceleration of agent 1 along y, and -(B grad V) with -1 for the outgoing edge
# fails: two linked agents at (1, 1) and (1, -1) with equal velocities, V' = 1 (the derivative by s = |r_12|^2): the acceleration of agent 1 along y is -4, the printed product gives 4
gradient = 2 * 1 * (1 - -1)
print(-gradient, -(-1 * gradient))  # -4 4

# tanner2.sec4.flocking: the path 1-2-3 at (1, 0), (0, 0), (1, 0), V = s + 1/s - 2: the forces along x; agents 1 and 3 are in one place
# kind: hypothesis
# why: The sentence that opens Section 4 asks for a connected graph only. The authors say themselves after Corollary 2 that agents that are not linked are not aware of each other, and Corollary 3 asks for the complete graph. The first half of the opening sentence, that velocities agree in the limit and linked agents do not collide, is Theorem 1 and right. On the complete graph nobody collides, but the equilibria include saddles (three agents in a row), which are not stable; hence the minimum, isolated among the critical configurations, in the corrected statement.
slope = lambda s: 1 - 1 / s**2
x = [1, 0, 1]
force = lambda i, j: -2 * slope((x[i] - x[j])**2) * (x[i] - x[j])
print(force(0, 1), force(1, 0) + force(1, 2), force(2, 1))  # -0.0 0.0 -0.0

# tanner2.cor1: V' = (s - 1)(s - 4)^2 (s + 2/3)/s^2 at s = 3, 4, 5: two agents at rest at |r|^2 = 4 stay, and V is not least there
# correct: Under (4) on a fixed tree, with potentials of Definition 3 with a continuous gradient, from starts in which no linked agents are in one place, grad_{r_ij} V_ij tends to 0 for all linked pairs, as the columns of B are independent. If V_ij' vanishes at the minimum of V_ij only, every distance of linked agents tends to its desired value, and in equilibria all of them have it.
# fails: two linked agents at rest at |r_12|^2 = 4, with V' = (s - 1)(s - 4)^2 (s + 2/3)/s^2, the derivative by s = |r_12|^2, and V(1) = 0: an equilibrium with a squared distance 4, where V is least at 1
# why: A tree has N - 1 edges and B has independent columns, so that every grad V_ij vanishes in the limit. But V' = 0 does not say that V is least. The V' of the example has no term 1/s when it is multiplied out, so that V is rational; V tends to infinity at 0 (like 32/(3 s)) and at infinity, decreases up to s = 1 and increases from there on: a potential of Definition 3 with its unique minimum at s = 1. It has V'(4) = 0 all the same, and two agents at rest there stay.
slope = lambda s: (s - 1) * (s - 4)**2 * (s + 2 / 3) / s**2
print(slope(3) > 0, slope(4), slope(5) > 0)  # True 0.0 True

# tanner2.eq2: opposite velocities (1, 1) and (-1, -1): whether arctan of the quotient is the same; and the two headings
# kind: convention
# why: arctan of the quotient gives the same angle to opposite velocities and none to (0, 1). Meant is the angle of the vector, as in equation (2) of the authors' conference paper, which needs a velocity other than zero. Nothing else in the paper uses it.
from math import atan, atan2
print(f"{atan(1 / 1) == atan(-1 / -1)} {atan2(1, 1):.3f} {atan2(-1, -1):.3f}")  # True 0.785 -2.356

# tanner2.S_config: two linked agents 3/2 apart with equal velocities: dW/dt = -|v_1 - v_2|^2 vanishes, and r_12 does not
# kind: scan
print(-(1 - 1)**2, 1.5)  # 0 1.5

# tanner2.appA.def4: K[f](0) = [-1, 0] is the hull of the values -1 and 0 of f on both sides of 0; the rate 0 of x = 0 lies in it, and is not it
# kind: scan
# why: K[f](x) is a set, here [-1, 0] at 0, and a rate is a number: with an equality sign nothing starts from 0. The text after the definition has it right: the tangent vector belongs to the hull.

# tanner2.appA.thm4: count the arguments of V(x(t), t) for x in R^2: three (two of x, and t)

# tanner2.appA.thm5: read which of the two proofs refers to a nonsmooth principle
# fails: the graph of Theorem 1 is fixed, its law smooth, and its proof names "LaSalle's invariant principle" without more; the proof of Theorem 2 names "the nonsmooth version of LaSalle's principle proposed by Shevitz and Paden (1994)", which is Theorem 5
# why: Theorem 5 is for discontinuous right sides, which only the switching network of Theorem 2 has.

# tanner2.cor2_sub: two agents with the same velocity 1 along x: dW/dt = -v L v, and the bound -lambda_2 |v_p|^2 with v_p = v
# fails: two linked agents with the same velocity (1, 0): dW/dt = 0, and the printed bound is -lambda_2 |v^p|^2 = -4
import numpy as np
v, L = np.array([1, 1]), np.array([[1, -1], [-1, 1]])
print(v @ L @ v, -2 * (v @ v))  # 0 -4

# tanner2.sec6.figures: compare the captions of Figures 4, 5 and 6 with the five sentences of Section 6 that name Figure 6 (three on the fixed run, one on the dynamic one, one on the loss of connectivity)
