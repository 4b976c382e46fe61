# chazelle.lower_bound: n = 8, c = 3: the times up to 3000 at which the network changes
# fails: n = 8, c = 3, with and without hysteresis: the network changes at t = 171 and never again
# why: All groups of four birds start alike, 4 apart, and are 4/3 apart at first: as long as no two groups meet they move alike, so that the distances between them stay as they are and they never meet. Inside a group the gap of the middle birds is 4/3 - t/n^c until it is at most 1, at t = ceil(n^c/3); from there on the path keeps its edges and gains none. So the network is steady after about n^c/3 steps. The lower bound itself is not refuted. What it needs is groups that approach each other: with the first of the two groups mirrored, v(1) = n^-c (0, 1, 0, -1, 1, 0, -1, 0), they drift towards each other and meet, after some 10^84 steps (n = 8, c = 3); with the second mirrored instead they drift apart.
import numpy as np
n, c = 8, 3
x = np.array([2 * (k // 2) + 2 / 3 * (k % 2) for k in range(n)])
v = np.array([1, 0, -1, 0] * (n // 4)) / n**c
near = lambda: (np.abs(x[:, None] - x) <= 1) & ~np.eye(n, dtype=bool)
old, changes = near(), []
for t in range(1, 3001):
    x = x + v
    new = near()
    if (new != old).any():
        changes.append(t)
    old, d = new, new.sum(axis=1)
    v = np.where(d > 0, v / 3 + 2 / 3 * (new @ v) / np.maximum(d, 1), v)
print(changes)  # [171]

# chazelle.Nts: integers u with s < u < t, for t = 2, s = 1: none, where one is claimed; and one integer, 2, lies in (1, 3) but in neither (1, 2) nor (2, 3)
# fails: t_k = 1, t_(k+1) = 2: no integer u has 1 < u < 2, so that N(2, 1) = 0, where 1 is used. A change at u = 2 is counted in N(3, 1), but neither in N(2, 1) nor in N(3, 2)
# why: With s < u <= t in the place of s < u < t the intervals are disjoint and fill (s, t_l], so that N is additive, and one step contains one u. A column can grow while the network rests (three birds at rest in a row), so that even then only N <= 1 is true, not N = 1. Nothing that follows depends on this.
print(len(range(2, 2)), len(range(2, 3)))  # 0 1

# chazelle.lem3.1.count: birds 2 and 3 (bird 1 rests far away): whether they are linked at t = 1, 2, 3, 4: a switch after T_1 = 1
# correct: If birds of V_k that are linked at a time t >= T_k + 1 are linked at all later times, the number of changes is at most N(T_k, T_{k-1}) + ... + N(T_1, 1) + 1 + binom(|V_k|, 2) + M, where N(t, s) counts those with s < u <= t, and M the changes after T_k + 1 of the network on the birds outside V_k.
# fails: k = 1; three birds on a line at 0, 11, 10 with v(1) = (0, 3, 13/3) and c_i = 1/4. Bird 1 is alone: V_1 = {1}, T_1 = 1, and the bound is N(1, 1) + binom(1, 2) = 0. But birds 2 and 3 are linked at t = 1 and 2 and not at t = 3: the network changes once (birds that rest far away may be added; for larger k a later switch of the birds outside does the same)
# why: binom(|V_k|, 2) counts pairs inside V_k. Birds outside V_k meet none of V_k after T_k, but can go on switching among themselves, whatever k is. Edges inside V_k last from T_k + 1 on, so that the network may also change once at T_k + 1. With both added the count is right, and the recursion for N(n) survives: the birds outside are fewer than n, and add at most N(n - 1) changes.
from fractions import Fraction as F
x, v, linked = [F(11), F(10)], [F(3), 3 + 1 / (1 - F(1, 4))], []
for t in range(4):
    x = [a + b for a, b in zip(x, v)]
    linked.append(abs(x[0] - x[1]) <= 1)
    if linked[-1]:
        v = [v[0] - F(1, 4) * (v[0] - v[1]), v[1] - F(1, 4) * (v[1] - v[0])]
print(linked)  # [True, True, False, False]

# chazelle.eq3.16: two birds with c = 1/4 that stay linked (lambda_2 = 1/2), v = (1, 0), t - t_1 = 5: how far bird 1 moves, and by the formula with the sum from k = 2
# kind: scan
# fails: k = 1: the printed term divides by 1 - lambda_1 = 0; there is no lambda_0
# why: The constant parts of the display before it, sum_{k>=2} Phi_k/(1 - lambda_k), are row i of Gamma times v(t_1 + 1), by (3.11). The sum that is left runs from k = 2 as well.
import numpy as np
P, v, s = np.array([[3, 1], [1, 3]]) / 4, np.array([1, 0]), 5
moved = sum(np.linalg.matrix_power(P, k) @ v for k in range(s))[0]
y, phi, root = 1 / 2, 1 / 2, 1 / 2
print(moved, phi / (1 - root) + s * y - root**s * phi / (1 - root))  # 3.46875 3.46875

# chazelle.eq3.5: the two sides of that example, times 9
# kind: scan
# fails: two birds, linked at t = 1 and 2 and no more, weights 1/3 and 2/3, s = 1, k = 3: T = (1, 2, 3), V_1 = V_2 = {1, 2}, V_3 = {1}. At t = 4 the left side is (5/9, 4/9), the right side (1/9, 2/9)
import numpy as np
P = np.array([[1, 2], [2, 1]])
print((P @ P)[0], (P[:, :1] @ P[:1])[0])  # [5 4] [1 2]

# chazelle.chi: that example; the printed chi(1, 2) is (-1, 0), if the second of its two values for one coordinate counts
# kind: scan
# fails: two birds with v(1) = (2, 7), t = 1, so that the product is the identity: v_1(1) - v_2(1) = -5, the right side is -2
v = (2, 7)
print(v[0] - v[1], -1 * v[0] + 0 * v[1])  # -5 -2

# chazelle.fiedler.rate: the printed rate at n = 2, c = 3, t = 40; and for the path of n = 8 birds with lazy weights tau_1(P^t) and n 2^(-t/n^3) at t = 2000
# kind: scan
# fails: 2^(t/n^c) grows with t for every c > 0: for n = 2, c = 3 it is 32 at t = 40
# why: The exponent has lost its minus sign, or "by a factor of" is meant. Then it is true: the Fiedler number is at least 4/(n(n - 1)), by Mohar's bound lambda_2 >= 4/(n diameter), the diameter at most n - 1, and the largest difference of velocities after t steps is tau_1(P^t) <= mu^t/(2 min pi) times the first one, with mu the second largest modulus of an eigenvalue. For t <= n^3 log_2 n the bound n 2^(-t/n^3) is at least 1, and tau_1 <= 1. Beyond, 1 - mu >= 8/(3 n^3) and 1/(2 min pi) <= n^2/2 for both weights, and (n^2/2) e^(-8t/(3 n^3)) <= n 2^(-t/n^3).
import numpy as np
n, t = 8, 2000
A = np.eye(n, k=1) + np.eye(n, k=-1)
P = np.linalg.matrix_power(np.eye(n) / 3 + 2 / 3 * A / A.sum(axis=1)[:, None], t)
tau = np.abs(P[:, None] - P).sum(axis=2).max() / 2
print(2 ** (40 / 2**3), tau < n * 2 ** (-t / n**3))  # 32.0 True
