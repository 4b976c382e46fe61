# paley.bal.circ: the ring of four with the balanced phases (0, a, a + pi, pi), cos a = 3/5: the sum of the phasors, and the part of u_k - omega_0 that K1 multiplies
# fails: C_4, phases (0, a, a + pi, pi) with cos a = 3/5, which are balanced: u_k is not omega_0, so that the centres part and the solution leaves the set at once
# why: A stable closed set is invariant. On C_4 the phases (0, a, a + pi, pi) are balanced, but <i e^{i theta_k}, L_k e^{i theta}> is not 0: with all centres equal they move apart at once. Nor are all balanced equilibria stable: on C_N the pattern theta_k = 2 pi m k/N has unstable directions where cos(2 pi m/N) > 0. What is stable for K_1 > 0 are the formations that maximise W_1. On a circulant graph W_1 <= lambda_max/2 is attained by a Fourier column, and only by eigenvectors of lambda_max > 0, which are normal to 1, so balanced. On complete graphs they are all the balanced ones. Stable they are by V as corrected in paley.eq21: V plus a constant is 0 on that set of formations and positive elsewhere, and does not increase. Where its rate vanishes for all time, the centres are at rest, thetadot_k = w0, <e^{i theta_k}, L_k c> turns with the phases while <i e^{i theta_k}, L_k e^{i theta}> is constant; so both are 0, c = c_0 1, and theta is stationary for W_1, which takes finitely many values at its stationary points.
import numpy as np
a = np.arccos(3 / 5)
z = np.exp(1j * np.array([0, a, a + np.pi, np.pi]))
L = 2 * np.eye(4) - np.roll(np.eye(4), 1, axis=0) - np.roll(np.eye(4), -1, axis=0)
turn = (np.conj(1j * z) * (L @ z)).real / 4
print(round(abs(z.sum()), 9), np.round(turn, 3) + 0.0)  # 0.0 [-0.2  0.2  0.2 -0.2]

# paley.eig.sym paley.fig2.caption: the ring of four, phases 0, 7, 6, 1 twelfths of a turn: an eigenvector; the gaps between neighbours on the circle are not equal
# fails: C_4, phases 0, 7, 6, 1 twelfths of a turn; C_12, (u, v, -u, -v) three times over with u = 1, v = 3/5 + 4/5 i: eigenvectors with eigenvalue 2 and no symmetric patterns
# why: The columns of F are eigenvectors, and symmetric patterns, as the text says; but they are not the only ones, as most eigenvalues of an undirected circulant are double. With omega = e^{2 pi i/12} an eigenvector a omega^{mk} + b omega^{-mk}, 0 < m < 6, of C_12 has equal moduli exactly if a = 0 or b = 0, or if omega^{2m} = -1 and a conj(b) is imaginary: for m = 3, eigenvalue 2, the rhombi (u, v, -u, -v) with any phases of u and v. On K_N every balanced arrangement is an eigenvector.
import numpy as np
turns = np.array([0, 7, 6, 1])
z = np.exp(2j * np.pi * turns / 12)
L = 2 * np.eye(4) - np.roll(np.eye(4), 1, axis=0) - np.roll(np.eye(4), -1, axis=0)
print(np.allclose(L @ z, 2 * z), np.diff(np.sort(turns)))  # True [1 5 1]

# paley.fig3.gain: C12, neighbours 5/12 of a turn apart, omega_0 = 0.1, K0 = 1.2 as in Figure 3: whether (22), linearised in the rotating frame, is stable but for rotation and translation, for K1 = 0.1, 1, 10
# fails: Read as a change of the gain during the run: C_12, theta_k = 2 pi 5 k/12 (the caption says splay; the stable splay arrangements of C_12 have neighbours 5/12 or 7/12 of a turn apart): a circular formation that is exponentially stable, up to rotation and translation, for every K_1 > 0
# why: At theta_k = 2 pi m k/N the Hessian of W_1 is (1/N) cos(2 pi m/N) L: negative definite up to rotation for m = 5 and for m = 6, the (2,N)-pattern. So V as corrected in paley.eq21 has there, up to rotation and translation, a minimum with a positive definite Hessian, and the linearised motion, along which V is constant at rest only, tends to it: both formations are exponentially stable for every K_1 > 0, and no gain turns Figure 3(c) into the other pattern. Which of the two is reached depends on the initial state, at every gain; started anew from one state, a larger gain can end in the other pattern.
import numpy as np
N, w, K0 = 12, 0.1, 1.2
L = 2 * np.eye(N) - np.roll(np.eye(N), 1, axis=0) - np.roll(np.eye(N), -1, axis=0)
inner = lambda a, b: (np.conj(a) * b).real
def field(y, K1):
    r, z = y[:N] + 1j * y[N:2 * N], np.exp(1j * y[2 * N:])
    c = r + 1j / w * z
    move = z - 1j * w * r
    turn = w / N * (K0 * inner(z, L @ c) + K1 / w * inner(1j * z, L @ z))
    return np.concatenate([move.real, move.imag, turn])
phase = 2 * np.pi * 5 * np.arange(N) / N
r = -1j / w * np.exp(1j * phase)
start = np.concatenate([r.real, r.imag, phase])
def stable(K1, h=1e-5):
    J = np.array([(field(start + h * e, K1) - field(start - h * e, K1)) / (2 * h) for e in np.eye(3 * N)]).T
    return bool(np.sort(np.linalg.eigvals(J).real)[-4] < -1e-6)
print([stable(K1) for K1 in (0.1, 1, 10)])  # [True, True, True]

# paley.fig8.pos: the factor that (29) gives to the orientation network at K1 = K0 = 0.1, N = 12
# correct: At K_1 = K_0 the law (29) does not depend on the orientation network. The caption needs K_1 > K_0, or K_0 on the attraction network (paley.eq29).
# fails: K_1 = K_0: the factor (K_1 - K_0)/N of the orientation network in (29) is 0, so that the runs for M = 2, 8 and 12 are one and the same from every start
# why: At K_1 = K_0 the law (29) does not contain the orientation network, and for 0 < K_1 < K_0 its term aligns. With K_0 on the attraction network the networks differ at these gains, and the text's account of the figure, symmetric clusters that need not be M in number, can be meant.
K0 = K1 = 0.1
print((K1 - K0) / 12)  # 0.0

# paley.figS3.difference: four fish at random places with random headings, 20000 times: mean of the difference, and how often it is positive
# fails: independent uniform headings of N fish at random places: the difference has the mean 1/2 - 1/N, that is 1/4 for four fish and 3/8 for eight, and is positive in 94 to 95 % and in 99.7 to 99.9 % of the draws, whether the nearest or the second nearest neighbour is taken
# why: Let A_n be the mean of 1 - cos theta_kj over the arcs of the network of the nearest n. W_1 = n A_n/2, so that the scaled potentials are (1 - 1/N) A_(N-1) and A_1/2: the difference is positive as soon as A_1 < 2(1 - 1/N) A_(N-1), that is, even where neighbours are up to 1.75 times less synchronised than the school (N = 8). (Which neighbour is taken where one is in the zone of repulsion depends on the places only, and the mean is the same.) So a difference that is nearly always positive is no evidence for local synchronisation. Scaled by 1/n, positive does mean A_1 < A_(N-1). Whether the fish are locally synchronised is not said here: that needs the tracks.
import numpy as np
random, N = np.random.default_rng(1), 4
place, z = random.random((20000, N, 2)), np.exp(2j * np.pi * random.random((20000, N)))
far = np.linalg.norm(place[:, :, None] - place[:, None], axis=3) + 9 * np.eye(N)
nearest = np.take_along_axis(z, far.argmin(axis=2), axis=1)
single = 2 / (1 + 1) * (1 - (np.conj(z) * nearest).real).sum(axis=1) / (2 * N)
whole = 1 - np.abs(z.mean(axis=1))**2
print(f"{(whole - single).mean():.2f} {(whole > single).mean():.2f}")  # 0.25 0.95

# paley.scale: four fish on a square, n = 2, each opposite to both neighbours: W_1 = (1/(2N)) sum over eight arcs of 1 - cos = 2; whether 2/(n+1) W_1 exceeds 1, and W_1/n
# fails: four fish at the corners (0, 0), (1, 0), (1, 1), (0, 1) of a square with headings 0, pi, 0, pi, n = 2: the scaled W_1 is 4/3
N, n = 4, 2
W1 = 8 * 2 / (2 * N)
print(2 / (n + 1) * W1 > 1, W1 / n)  # True 1.0

# paley.sync.par: omega_0 = 1, two equal phases: the rate of each phase under (6) with (9) is not 0
# why: The definition of a parallel formation asks for thetadot_k = 0. Phase locking gives equal rates only: under (6) with a control that vanishes at equal phases, such as (9) and (14), the common rate is omega_0. The caption of Figure 1(c) says rightly that the formation there is no relative equilibrium.
from math import sin
theta = [0.3, 0.3]
print([1.0 + sum(sin(b - a) for b in theta) / 2 for a in theta])  # [1.0, 1.0]

# paley.zero.dir: one arc between two particles, a quarter of a turn apart: W1 = (1/(2N)) sum over arcs of 1 - cos
# fails: two particles and one arc between them, phases a quarter of a turn apart: each strongly connected subgraph is a single node, so synchronised, and W_1 = 1/4
from math import cos, pi
print(round((1 - cos(pi / 2)) / (2 * 2), 9))  # 0.25

# paley.eq21: two joined particles, omega_0 = 2, K0 = K1 = 1: the rate of the printed V under (22), and the printed rate
# fails: two joined particles, omega_0 = 2, K_0 = K_1 = 1, r = (1 + i, 1 - i), theta = (pi/2, 2 arctan 2): the rate of the printed V is -49/20, and -41/25 is printed
import numpy as np
w, N = 2.0, 2
inner = lambda a, b: (np.conj(a) * b).real
L = np.array([[1, -1], [-1, 1]])
r, t, h = np.array([1 + 1j, 1 - 1j]), np.array([np.pi / 2, 2 * np.arctan(2)]), 1e-6
c = lambda r, t: r + 1j / w * np.exp(1j * t)
form = lambda x: inner(x, L @ x).sum() / (2 * N)
V = lambda r, t: form(c(r, t)) + form(np.exp(1j * t)) / w
z = np.exp(1j * t)
part = inner(z, L @ c(r, t)) + inner(1j * z, L @ z) / w
u = w + w / N * part
print(f"{(V(r + h * z, t + h * u) - V(r - h * z, t - h * u)) / (2 * h):.4f} {-(part**2).sum() / N**2:.4f}")  # -2.4500 -1.6400

# paley.VMN: all-to-all, N = M = 2, omega_0 = K0 = 0.1, K1 = 1, K2 = -1/2, r = (0, 0), phases 0 and 2 arctan(1/2): the rate of the printed V
# why: With y_k = (K_0/N) <e^{i theta_k}, L_k c> and g_k = dU/dtheta_k, whose sum is 0, u_k - w0 = w0 y_k - g_k and (d/dt)(K_0 S + a U) = sum_k (-y_k/w0 + a g_k)(w0 y_k - g_k). For a = w0^-2 this is -w0^-2 sum_k (u_k - w0)^2. For the printed a = 1 it is sum_k (-y_k^2 + (w0 + 1/w0) y_k g_k - g_k^2), a form that takes both signs unless |w0| = 1 (its discriminant is (w0 - 1/w0)^2). Except for N = M = 2 it is positive also at states as near to the pattern as one likes: there L c can be chosen so that y_k = (w0 + 1/w0) g_k/2. The factor w0^-2 is missing; the argument theta too. Theorem 3 stands: the corrected V proves what the printed one was to prove.
import numpy as np
w, K0, K = 0.1, 0.1, {1: 1.0, 2: -0.5}
inner = lambda a, b: (np.conj(a) * b).real
L = np.array([[1, -1], [-1, 1]])
U = lambda t: sum(k * abs(np.exp(1j * m * t).mean() / m)**2 for m, k in K.items())
c = lambda r, t: r + 1j / w * np.exp(1j * t)
V = lambda r, t: K0 * inner(c(r, t), L @ c(r, t)).sum() / 4 + U(t)
r, t, h = np.zeros(2), np.array([0, 2 * np.arctan(0.5)]), 1e-6
z = np.exp(1j * t)
slope = np.array([(U(t + h * e) - U(t - h * e)) / (2 * h) for e in np.eye(2)])
u = w + w * K0 / 2 * inner(z, L @ c(r, t)) - slope
print(f"{(V(r + h * z, t + h * u) - V(r - h * z, t - h * u)) / (2 * h):.4f}")  # 1.7856

# paley.Wm: two equal phases, m = 2: W_2 and the printed N/2 - U_2 with p_2 = (1/(2N)) sum e^(2i theta)
# fails: N = 2, equal phases, m = 2: W_2 = 0, but N/2 - U_2 = 3/4
N, m = 2, 2
p = 1 / m
print(0, N / 2 - N / 2 * p**2)  # 0 0.75

# paley.vatt paley.vrep paley.eq28: a fish at 0: the printed attraction to and repulsion from a neighbour at 1; and the attraction term of (28) for a neighbour at i, heading 0
# kind: slip
# correct: With r_kj = r_k - r_j as in the article: v_k^att = - sum_{j in N_k^att} rhat_kj, v_k^rep = sum_{j in N_k^rep} rhat_kj, and in (28) - K_att <i e^{i theta_k}, L_k^att r>. Then (27) steers towards the neighbours in the zone of attraction and away from those in the zone of repulsion.
# fails: a fish at 0 with heading 0: with a neighbour at 1 the printed v^att is -1 and the printed v^rep is 1; with a neighbour at i, on its left, the attraction term of (28) turns it to the right
# why: rhat_kj with r_kj = r_k - r_j (defined under shape control) points from the neighbour to fish k. Moving along v changes the sum of the distances to the neighbours at the rate <v, sum rhat_kj>: it grows at the rate |v|^2 along the printed v^att. The signs belong to r_j - r_k, as in reference [19]. (28) follows from the printed v^att by sum r_kj = L_k^att r.
unit = lambda k, j: (k - j) / abs(k - j)
print(unit(0, 1), -unit(0, 1), ((1j * 1).conjugate() * (0 - 1j)).real)  # -1.0 1.0 -1.0

# paley.eq29: omega_0 = K0 = K1 = 1, two particles in one place that attract and do not align: u_1 by (5) with (14) and (20), and by (29)
# kind: convention
# correct: (5) with (14) on the orientation network and (20) on the attraction network is u_k = omega_0 + (K_1/N) <i e^{i theta_k}, L_k^ori e^{i theta}> - (K_0/N) <i e^{i theta_k}, L_k^att e^{i theta}> + omega_0 (K_0/N) <e^{i theta_k}, L_k^att r>.
# fails: omega_0 = K_0 = K_1 = 1, two particles in one place, at 1 + i, with phases pi/2 and 2 arctan 2, that attract and do not align: u_1 is 13/10 by (5) with (14) and (20), and 1 by (29)
# why: In the coefficient K_1 - K_0 of (22) K_1 comes from (14) and -K_0 from the circle centres in (20). (29) puts both on the orientation network: a law of its own, which is not (5) with (14) and (20) unless K_0 = 0 or both terms agree. Under (29) circular formations need not be equilibria at K_1 = 0, and at K_1 = K_0 the orientation network has no effect.
import numpy as np
z = np.exp(1j * np.array([np.pi / 2, 2 * np.arctan(2)]))
r = np.array([1 + 1j, 1 + 1j])
inner = lambda a, b: (np.conj(a) * b).real
u = 1 - inner(1j * z[0], z[0] - z[1]) / 2 + inner(z[0], r[0] - r[1]) / 2
printed = 1 + 0 + inner(z[0], r[0] - r[1]) / 2
print(round(u, 9), printed)  # 1.3 1.0

# paley.eq26: T = 1/10: how far a particle of unit speed moves in a step of Euler's method, and by (26)
# kind: convention
# fails: T = 1/10: a particle of unit speed moves 1/10 in a step of Euler's method, and 1 by (26)
# why: One step of the forward Euler method is the same for both equations. (26) is that method with step 1 for (1), (2) under the control T u_k; or with step T for a particle of the speed 1/T. In the first reading, which unit speed suggests, the gains that are compared with those of (22) after (28) are off by the factor T.
T = 0.1
print(T * 1.0, 1.0)  # 0.1 1.0

# paley.length paley.incid: 1-2 with x = (1 + i, 1 - i): <x, L x>/(2N), the printed sum over both directed edges; and B B^T with a column for each
# kind: convention
# fails: the undirected graph 1-2: with both (1, 2) and (2, 1) in E the printed sum is twice Q_L, and B B^T, with a column for each, is 2 L
# why: The set E of the tutorial has both directions of each edge of an undirected graph. L = B B^T and the display after (11) are right with each edge counted once, in one direction.
import numpy as np
x, B = [1 + 1j, 1 - 1j], np.array([[1, -1], [-1, 1]])
square = abs(x[0] - x[1])**2
print(square / 4, 2 * square / 4, (B @ B.T).tolist())  # 1.0 2.0 [[2, -2], [-2, 2]]

# paley.fig6.gain: C_12, omega_0 = K_0 = 0.1: the largest real part of the linearised synchronised circular formation, three eigenvalues of symmetry left out, for K_1 = 0.1 and -0.1: its sign
# fails: C_12, omega_0 = K_0 = 0.1, K_1 = 0.1: the linearised synchronised circular formation has an eigenvalue with positive real part
# why: In a drift common to all the relative motion is that without drift. In the frame that turns with the synchronised formation let a + i b be the deviation of the centres and theta that of the phases, along an eigenvector of L for lambda > 0. With p = K_0 lambda/N and q = K_1 lambda/N: adot = w0 b - p a - q theta/w0, bdot = -w0 a, thetadot = w0 p a + q theta, with the characteristic polynomial z^3 + (p - q) z^2 + w0^2 z - w0^2 q. For K_1 > 0 it is negative at 0, so that it has a positive root, on every connected graph; for K_1 < 0 its roots lie in the left half plane (Hurwitz). The article says itself that K_1 < 0 synchronises.
import numpy as np
N, w, K0 = 12, 0.1, 0.1
L = 2 * np.eye(N) - np.roll(np.eye(N), 1, axis=0) - np.roll(np.eye(N), -1, axis=0)
inner = lambda a, b: (np.conj(a) * b).real
def field(y, K1):
    r, z = y[:N] + 1j * y[N:2 * N], np.exp(1j * y[2 * N:])
    c, move = r + 1j / w * z, z - 1j * w * r
    turn = w / N * (K0 * inner(z, L @ c) + K1 / w * inner(1j * z, L @ z))
    return np.concatenate([move.real, move.imag, turn])
start = np.concatenate([np.zeros(N), -np.ones(N) / w, np.zeros(N)])
def largest(K1, h=1e-5):
    J = np.array([(field(start + h * e, K1) - field(start - h * e, K1)) / (2 * h) for e in np.eye(3 * N)]).T
    real = np.linalg.eigvals(J).real
    return max(real[np.abs(real) > 1e-6])
print([float(np.sign(largest(K1))) for K1 in (0.1, -0.1)])  # [1.0, -1.0]

# paley.scale.complete: two opposite fish, n = 1: (2/n + 1) W_1 with W_1 = (1/(2N)) (2 + 2), and 1 - |p|^2
# kind: scan
# fails: two opposite fish, n = 1: (2/n + 1) W_1 = 3, and 1 - |p|^2 = 1
print((2 / 1 + 1) * (2 + 2) / (2 * 2), 1 - 0)  # 3.0 1
