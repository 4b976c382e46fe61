# paley.bal.circ: the ring of four with the balanced phases (0, a, a + pi, pi), cos a = 3/5: the sum of the phasors, and the part of u_k - omega_0 that K1 multiplies
import numpy as np
a = np.arccos(3 / 5)
z = np.exp(1j * np.array([0, a, a + np.pi, np.pi]))
L = 2 * np.eye(4) - np.roll(np.eye(4), 1, axis=0) - np.roll(np.eye(4), -1, axis=0)
turn = (np.conj(1j * z) * (L @ z)).real / 4
print(round(abs(z.sum()), 9), np.round(turn, 3) + 0.0)  # 0.0 [-0.2  0.2  0.2 -0.2]

# paley.eig.sym: the ring of four, phases 0, 7, 6, 1 twelfths of a turn: an eigenvector; the gaps between neighbours on the circle are not equal
import numpy as np
turns = np.array([0, 7, 6, 1])
z = np.exp(2j * np.pi * turns / 12)
L = 2 * np.eye(4) - np.roll(np.eye(4), 1, axis=0) - np.roll(np.eye(4), -1, axis=0)
print(np.allclose(L @ z, 2 * z), np.diff(np.sort(turns)))  # True [1 5 1]

# paley.eq29: omega_0 = K0 = K1 = 1, two particles in one place that attract and do not align: u_1 by (5) with (14) and (20), and by (29)
import numpy as np
z = np.exp(1j * np.array([np.pi / 2, 2 * np.arctan(2)]))
r = np.array([1 + 1j, 1 + 1j])
inner = lambda a, b: (np.conj(a) * b).real
u = 1 - inner(1j * z[0], z[0] - z[1]) / 2 + inner(z[0], r[0] - r[1]) / 2
printed = 1 + 0 + inner(z[0], r[0] - r[1]) / 2
print(round(u, 9), printed)  # 1.3 1.0

# paley.fig2.caption: C12 with (u, v, -u, -v) three times, u = 1, v = 3/5 + 4/5 i: an eigenvector, and the angles (degrees) between neighbours on the circle
import numpy as np
z = np.tile([1, 0.6 + 0.8j, -1, -0.6 - 0.8j], 3)
L = 2 * np.eye(12) - np.roll(np.eye(12), 1, axis=0) - np.roll(np.eye(12), -1, axis=0)
print(np.allclose(L @ z, 2 * z), np.diff(np.unique(np.round(np.degrees(np.angle(z)) % 360, 1))))  # True [ 53.1 126.9  53.1]

# paley.fig3.gain: C12, neighbours 5/12 of a turn apart, omega_0 = 0.1, K0 = 1.2 as in Figure 3: whether (22), linearised in the rotating frame, is stable but for rotation and translation, for K1 = 0.1, 1, 10
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
K0 = K1 = 0.1
print((K1 - K0) / 12)  # 0.0

# paley.figS3.difference: four fish at random places with random headings, 20000 times: mean of the difference, and how often it is positive
import numpy as np
random, N = np.random.default_rng(1), 4
place, z = random.random((20000, N, 2)), np.exp(2j * np.pi * random.random((20000, N)))
far = np.linalg.norm(place[:, :, None] - place[:, None], axis=3) + 9 * np.eye(N)
nearest = np.take_along_axis(z, far.argmin(axis=2), axis=1)
single = 2 / (1 + 1) * (1 - (np.conj(z) * nearest).real).sum(axis=1) / (2 * N)
whole = 1 - np.abs(z.mean(axis=1))**2
print(f"{(whole - single).mean():.2f} {(whole > single).mean():.2f}")  # 0.25 0.95

# paley.scale: four fish on a square, n = 2, each opposite to both neighbours: eight arcs with 1 - cos = 2
N, n = 4, 2
W1 = 8 * 2 / (2 * N)
print(2 / (n + 1) * W1 > 1, W1 / n)  # True 1.0

# paley.sync.par: omega_0 = 1, two equal phases: the rate of each phase under (6) with (9) is not 0
from math import sin
theta = [0.3, 0.3]
print([1.0 - sum(sin(b - a) for b in theta) / 2 for a in theta])  # [1.0, 1.0]

# paley.zero.dir: one arc between two particles, a quarter of a turn apart: W1 = (1/(2N)) sum over arcs of 1 - cos
from math import cos, pi
print(round((1 - cos(pi / 2)) / (2 * 2), 9))  # 0.25

# paley.VMN: all-to-all, N = M = 2, omega_0 = K0 = 0.1, K1 = 1, K2 = -1/2, r = (0, 0), phases 0 and 2 arctan(1/2): the rate of the printed V
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
N, m = 2, 2
p = 1 / m
print(0, N / 2 - N / 2 * p**2)  # 0 0.75

# paley.eq21: two joined particles, omega_0 = 2, K0 = K1 = 1: the rate of the printed V under (22), and the printed rate
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

# paley.eq26: T = 1/10: how far a particle of unit speed moves in a step of Euler's method, and by (26)
T = 0.1
print(T * 1.0, 1.0)  # 0.1 1.0

# paley.eq28: a fish at 0 with heading 0 and one neighbour on its left, at i: the attraction term of (28) turns it to the right
r, z = [0, 1j], 1
turn = (1j * z).conjugate() * (r[0] - r[1])
print(turn.real)  # -1.0

# paley.incid: the undirected graph 1-2 with a column for each directed edge: B B^T has the diagonal 2, L has 1
import numpy as np
B = np.array([[1, -1], [-1, 1]])
print((B @ B.T).tolist())  # [[2, -2], [-2, 2]]

# paley.length: 1-2 with x = (1 + i, 1 - i): <x, L x>/(2N), and the printed sum over both directed edges
x = [1 + 1j, 1 - 1j]
square = abs(x[0] - x[1])**2
print(square / 4, 2 * square / 4)  # 1.0 2.0

# paley.vatt: a fish at 0 and its neighbour at 1: the printed attraction points to -1
r = [0, 1]
print((r[0] - r[1]) / abs(r[0] - r[1]))  # -1.0

# paley.vrep: a fish at 0 and its neighbour at 1: the printed repulsion points to 1
r = [0, 1]
print(-(r[0] - r[1]) / abs(r[0] - r[1]))  # 1.0

# paley.scale.complete: two opposite fish, n = 1: (2/n + 1) W_1 with W_1 = (1/(2N)) (2 + 2), and 1 - |p|^2
print((2 / 1 + 1) * (2 + 2) / (2 * 2), 1 - 0)  # 3.0 1
