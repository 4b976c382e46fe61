# chazelle.lower_bound: n = 8, c = 3: the times up to 3000 at which the network changes
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

# chazelle.Nts: integers u with s < u < t, for t = 2, s = 1: none, where one is claimed; and 1 of (1, 3) is in no part of (1, 2), (2, 3)
print(len(range(2, 2)), len(range(2, 3)))  # 0 1

# chazelle.lem3.1.count: birds 2 and 3 (bird 1 rests far away): whether they are linked at t = 1, 2, 3, 4: a switch after T_1 = 1
from fractions import Fraction as F
x, v, linked = [F(11), F(10)], [F(3), 3 + 1 / (1 - F(1, 4))], []
for t in range(4):
    x = [a + b for a, b in zip(x, v)]
    linked.append(abs(x[0] - x[1]) <= 1)
    if linked[-1]:
        v = [v[0] - F(1, 4) * (v[0] - v[1]), v[1] - F(1, 4) * (v[1] - v[0])]
print(linked)  # [True, True, False, False]
