# veerman.gain_max: |1/gamma|^2 at w^2 = |f| = 1 and at w^2 = 3/4
# why: With y = w^2, |1/gamma|^2 = (f^2 + g^2 y)/((y - |f|)^2 + g^2 y). Its derivative vanishes where g^2 y^2 + 2 f^2 y = 2|f|^3. At y = |f| the left side exceeds the right one by g^2 f^2 > 0, so that the maximum always lies below |f|. For f = g = -1 it is at y = sqrt(3) - 1. (What is set off in the display, a_k at w^2 = |f|, is right.)
from fractions import Fraction as F
f = g = F(-1)
gain2 = lambda y: (f**2 + g**2 * y) / ((y - abs(f))**2 + g**2 * y)
print(gain2(F(1)), gain2(F(3, 4)))  # 2 28/13

# veerman.table1_numeric veerman.table1_theory veerman.table1.size: f = g = -1: Theorem 1 for four followers, which is what NFREQ and NAMP print; the true maximum of the amplitude of the last of four followers of system (2); the same for five
# kind: slip
# correct: Columns NFREQ and NAMP are Theorem 1, with N in the place of N + 1; columns TFREQ and TAMP, presumably, what was simulated. The rows are flocks of N followers, N + 1 cars with the leader. From the true resonances of N followers TFREQ deviates by at most 0.14 % in all rows and 0.001 % at N = 128, TAMP by at most 3.53 % and 0.006 %.
# fails: f = g = -1. Four followers: Theorem 1 gives 0.2776801836 and 4.58527335, which NFREQ and NAMP print; the true resonance is at 0.27310856 with the amplitude 4.65489954, and TFREQ and TAMP print 0.2727291 and 4.49064609. Five followers, as the caption has it: Theorem 1 gives 0.22214415 and 5.73159168, the true resonance is at 0.21982048 with 5.78652664
# why: The headings of the two pairs of columns are exchanged: every cell of NFREQ and NAMP is Theorem 1, omega = pi/(2 sqrt(2) M), A = 8 sqrt(2) M/pi^2, for M = N followers, to within one unit of its last digit. So the rows are for N followers, N + 1 cars with the leader: for N + 1 followers all four columns are off by a factor of about (N + 1)/N. TFREQ and TAMP are near the true resonance of N followers, TFREQ in every row nearer to it than to Theorem 1; but they are not correct to the digits that they show, and TAMP lies below the true amplitude in every row.
import numpy as np
def last(w, n, f=-1, g=-1):
    P = np.eye(n) - (np.eye(n, k=1) + np.eye(n, k=-1)) / 2
    P[-1, -2] = -1
    c = f + 1j * w * g
    return abs(np.linalg.solve(-w**2 * np.eye(n) - c * P, -c / 2 * np.eye(n)[0])[-1])
w = np.arange(0.20, 0.30, 1e-5)
print(f"{np.pi / (2 * 2**0.5 * 4):.10f} {8 * 2**0.5 * 4 / np.pi**2:.8f}")  # 0.2776801836 4.58527335
print(*(f"{w[np.argmax(a)]:.4f} {max(a):.4f}" for a in ([last(x, n) for x in w] for n in (4, 5))))  # 0.2731 4.6549 0.2198 5.7865

# veerman.thm1_eps: the real part of the coefficient of w^2/2 in the bracket, f = g = -1; the printed one is -g^2/f^2 - 1/(2|f|) = -1.5
# fails: f = g = -1: the coefficient of w^2/2 in the bracket has the real part -5/4, not -3/2
# why: With q = w^2/(|f| + i w |g|), gamma = 1 - q, so that eps^2 = gamma^2 - 1 = -2q + q^2 = -(2 w^2/|f|) S with S = (1 + i w |g|/|f|)^-1 (1 - q/2) = 1 + s_1 w + s_2 w^2 + O(w^3), s_1 = -i |g|/|f| and s_2 = -g^2/f^2 - 1/(2|f|). The square root of S is 1 + s_1 w/2 + (s_2/2 - s_1^2/8) w^2 + O(w^3). The paper has s_2/2 and drops -s_1^2/8 = g^2/(8 f^2), which makes -g^2/f^2 of -(3/4) g^2/f^2. In eps that is a term i w^3, which the line for mu_(+-) carries as O(w^3) in the imaginary part: the theorem is not changed. For w > 0 the imaginary part of gamma^2 - 1 is positive and its angle near pi, so that the root with angle in (-pi/2, pi/2] is the one with +i.
import cmath
w = 1e-3
gamma = 1 + w**2 / (-1 - 1j * w)
bracket = cmath.sqrt(gamma**2 - 1) / (1j * 2**0.5 * w)
print(round(((bracket - (1 - 1j * w / 2)) / (w**2 / 2)).real, 3))  # -1.25

# veerman.cor1.proof: w = 1, a_k = 2, t = 0: the rate of a_k e^{iwt} by a difference quotient, and the printed u_k
# fails: with u_k = i w e^{iwt} for all k the differences u_k - u_(k-1) vanish, and nothing is left of g in the equation that follows
# why: u_k is the derivative of a_k e^{iwt}, that is i w a_k e^{iwt}, as the proof of Lemma 2 has it. (As elsewhere in the paper a_k e^{iwt} stands for the deviation x_k - h_k.) The equation that follows is right.
from cmath import exp
h = 1e-6
print(f"{(2 * exp(1j * h) - 2 * exp(-1j * h)) / (2 * h):.3f} {1j * exp(0):.3f}")  # 0.000+2.000j 0.000+1.000j

# veerman.prop1: |1/gamma|^2 at the frequency w = |f| = 4 (g = -1): below one, so that nothing limits N
# kind: scan
# why: At w^2 = |f|, Corollary 1 gives |a_k| = a_0 (1 + |f|/g^2)^{k/2}, which grows with k: the last car, number N + 1, stays within D exactly if N + 1 <= X, with X = 2 ln(D/a_0)/ln(1 + |f|/g^2). The printed N <~ X allows one car more, which the sign may cover. But the frequency is sqrt|f|, not |f|: at w = |f| one has |1/gamma|^2 = (1 + g^2)/((|f| - 1)^2 + g^2), which is below 1 for |f| > 2, so that there is no limit at all.
f, g, w = -4, -1, 4
print((f**2 + g**2 * w**2) / ((w**2 - abs(f))**2 + g**2 * w**2))  # 0.2

# veerman.sec7.system: system (1), f = g = -1: where |1/gamma| is largest, and the amplitude of car 128 there
# fails: f = g = -1: the last of M cars of system (1) responds most at w = 0.8556, with the amplitude (1 + 2/sqrt(3))^(M/2), some 10^21 for M = 128; every frequency in Table 1 is below 0.28, and the largest amplitude is 147
# why: The resonances of system (2) with N followers are within 2 % of the frequencies and 4 % of the amplitudes in Table 1. Section 3, to which the text refers for the other system, treats system (1). So (1) and (2) are exchanged, and "the differential equations given in (1)" of the next paragraph are those of (2), which the third paragraph names.
from math import sqrt
y = sqrt(3) - 1
print(f"{sqrt(y):.4f} {((1 + y) / ((y - 1)**2 + y))**64:.0e}")  # 0.8556 2e+21

# veerman.sep_remark: a0 = 2 and gamma^-k e^(iwt) = gamma^-(k+1) e^(iwt) = 1: both cars are displaced by 2, their distance is 1
# kind: scan
# fails: a_0 = 2, and gamma^{-k} e^{iwt} = gamma^{-k-1} e^{iwt} = 1 (both cars displaced by 2): the separation is 1, the printed formula gives -2
a0, h = 2, 1
print((h + a0) - a0, a0 * 1 - a0 * (1 + 1))  # 1 -2

# veerman.gain_iff: |1/gamma|^2 at w = 0 for f = g = -1: not greater than one, although 0 < 2|f|
# kind: convention
f = g = -1
y = 0
print((f**2 + g**2 * y) / ((y - abs(f))**2 + g**2 * y))  # 1.0

# veerman.nth_neighbour: whom a chain of n-th neighbours joins to the leader, number 0, for n = 1 and n = 2
# kind: convention
# correct: Let n >= 2, and let each of the agents 1 to N+1 behind the leader, number 0, keep track of only the n-th agent in front and the n-th behind it, as far as there are such agents. The communication graph is not connected, and the agents whose number is no multiple of n, agent 1 among them, are not joined to the leader: if they start at rest in their places, they stay there whatever the leader does.
# fails: n = 1 (with N = 0, for example): the graph is connected, and every follower moves
# why: Tracking joins agents whose numbers differ by n, so that it stays within the residue classes modulo n, and agents of other classes than the leader's see nothing that moves. So the sentence is true for n >= 2; n = 1 is system (2) itself, which is clearly not meant.
print(*(list(range(0, 6, n)) for n in (1, 2)))  # [0, 1, 2, 3, 4, 5] [0, 2, 4]

# veerman.specM: one follower of system (1), f = 0, g = -1: the union on the right contains 0, the left side leaves it out
# kind: convention
# fails: system (1) with one follower, f = 0, g = -1: the union on the right contains 0, the left side leaves it out
# why: As 0 is not in spec(P_i), the right side is all of spec(M), for all real f and g; for f other than 0 it does not contain 0 and the printed equation holds. (In the cited papers M contains the leader, which is where the 0 that is taken away comes from.)
import numpy as np
print(sorted(np.linalg.eigvals([[0.0, 1.0], [0.0, -1.0]])) == [-1, 0])  # True

# veerman.thm1_x: A x/M at the principal resonance for M = 400 followers, f = -2, g = -1/2, with sqrt|f| and with the printed |f|
# kind: scan
# fails: f = -2, g = -1/2, N + 1 = 400: A x/(N + 1) is 1.000 with sqrt|f| in x, and 0.707 with |f|
# why: |mu_(+-)|^2 = 1 +- sqrt(2) w^2 |g|/|f|^(3/2) at w = sqrt(|f|) pi/(2 sqrt(2) M) is 1 +- 2x/M^2 for x = pi^2 |g|/(8 sqrt(2|f|)). The text that was read has 4 sqrt(2) |f| and 8 sqrt(2) |f|, but sqrt(2|f|) in Theorem 1 and sqrt(2) sqrt(|f|) in Proposition 2, which follow from x: in print the radicals may well cover |f| in the proof too.
import numpy as np
f, g, M = -2.0, -0.5, 400
w = np.sqrt(-f) * np.pi / (2 * np.sqrt(2) * M)
P = np.eye(M) - (np.eye(M, k=1) + np.eye(M, k=-1)) / 2
P[-1, -2] = -1
c = f + 1j * w * g
A = abs(np.linalg.solve(-w**2 * np.eye(M) - c * P, -c / 2 * np.eye(M)[0])[-1])
x = lambda root: np.pi**2 * abs(g) / (8 * np.sqrt(2) * root)
print(f"{A * x(np.sqrt(-f)) / M:.3f} {A * x(-f) / M:.3f}")  # 1.000 0.707
