"""Runs our workloads and the peers' in turn, several rounds in one run, and prints ratios of the best times.

usage: python3 benches/peers/run.py [ROUNDS] [FILTER] [--json FILE]     (default 3 rounds; from anywhere)

Needs requirements.txt; FILTER keeps the pairs whose line contains it. Checksums must agree; a ratio below 1 means that flockproof is faster.
"""
import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
# (workload, size, our peer name, their script and arguments, the bound that is aimed at)
PAIRS = [
    ("W1", "n=8,T=500", "flockproof_seq", ["w1_product.py", "flint_seq", "8"], 0.9),
    ("W1", "n=16,T=500", "flockproof_seq", ["w1_product.py", "flint_seq", "16"], 0.9),
    ("W1", "n=8,T=500", "flockproof_tree", ["w1_product.py", "flint_tree", "8"], 0.9),
    ("W1", "n=16,T=500", "flockproof_tree", ["w1_product.py", "flint_tree", "16"], 0.9),
    ("W1", "n=8,T=5000", "flockproof_tree", ["w1_product.py", "flint_tree", "8", "5000"], 0.9),
    ("W1", "n=16,T=5000", "flockproof_tree", ["w1_product.py", "flint_tree", "16", "5000"], 0.9),
    ("W2", "n=8,T=500", "flockproof", ["w2_tau.py", "flint", "8"], 1.0),
    ("W2", "n=16,T=500", "flockproof", ["w2_tau.py", "flint", "16"], 1.0),
    ("W3", "M=128", "flockproof", ["w3_peak.py", "arb", "128"], 0.5),
    ("W3", "M=10000", "flockproof", ["w3_peak.py", "arb", "10000"], 0.5),
    ("W3", "M=1000000", "flockproof", ["w3_peak.py", "arb", "1000000"], 0.5),
    ("W4", "circulant n=1048576", "flockproof", ["w4_spectra.py", "circulant", "1"], 1.0),
    ("W4", "path_family n=4000", "flockproof", ["w4_spectra.py", "path_family", "1"], 0.05),
    ("W4", "path_tridiag n=4000", "flockproof", ["w4_spectra.py", "path_tridiag", "1"], 0.25),
    ("W4", "ring_dense n=1000", "flockproof", ["w4_spectra.py", "ring_dense", "2"], 1.4),
    ("W4", "ring_perm n=1000", "flockproof", ["w4_spectra.py", "ring_perm", "2"], 1.4),
    ("W4", "rational_full n=1000", "flockproof", ["w4_spectra.py", "rational_full", "2"], 4.0),
    ("W4", "rgg_dense n=500", "flockproof", ["w4_spectra.py", "rgg_dense", "2"], 2.5),
    ("W5", "N=100000,steps=200", "flockproof", ["w5_phase.py", "numba2"], 0.667),
    ("W5", "N=100000,steps=200", "flockproof", ["w5_phase.py", "numpy"], 0.2),
    ("W6", "N=2000,steps=50", "flockproof", ["w6_flock2d.py", "numba_half", "2000"], 0.9),
    ("W6", "N=20000,steps=50", "flockproof", ["w6_flock2d.py", "numba_half", "20000"], 1.0),
    ("W6", "N=2000,steps=50", "flockproof", ["w6_flock2d.py", "ckdtree", "2000"], 0.1),
    ("W6", "N=20000,steps=50", "flockproof", ["w6_flock2d.py", "ckdtree", "20000"], 0.1),
    ("W7", "n=8,steps=1000", "flockproof", ["w7_exact_flock.py", "flint", "1000"], 0.33),
    ("W7", "n=8,steps=10923", "flockproof", ["w7_exact_flock.py", "flint"], 0.33),
    ("W7", "n=8,steps=10923", "flockproof", ["w7_exact_flock.py", "gmpy2"], 1.0),
    ("W9", "n=1000,steps=10000", "flockproof", ["w9_flock_log.py", "numba", "1000", "10000"], 3.0),
    ("W8", "M=128,t=2000", "flockproof", ["w8_platoon.py", "scipy"], 0.1),
    ("W8", "M=128,t=2000", "flockproof", ["w8_platoon.py", "expm"], 1.0),
    ("W12", "all N=2000,steps=100", "flockproof", ["w12_laws.py", "numba", "all"], 1.5),
    ("W12", "near N=20000,steps=20", "flockproof", ["w12_laws.py", "numba", "near"], 1.5),
    ("W12", "three t=40", "flockproof", ["w12_laws.py", "dop853", "three"], 1.0),
    ("W12", "three t=40", "flockproof", ["w12_laws.py", "heyoka", "three"], 10.0),
    # All graphs on 8 vertices against those on up to 7: a tenth as many.
    ("W10", "n=8,graphs=12346", "flockproof", ["w10_graphs.py", "atlas"], 3.0),
]


def ours(workload, size, peer):
    command = ["cargo", "bench", "--quiet", "-p", "flockproof-benches", "--bench", "peer_workloads", "--", workload, peer, size]
    out = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    lines = [json.loads(line) for line in out.splitlines() if line.startswith("{")]
    return next(line for line in lines if (line["peer"], line["size"]) == (peer, size))


def theirs(arguments):
    env = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    run = subprocess.run([sys.executable] + arguments, cwd=HERE, env=env, capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def same_result(workload, ours, theirs):
    """Exact text, or numbers of double precision: relative 1e-8, or one unit of the last printed digit."""
    if workload not in ("W4", "W5", "W6", "W12"):
        return ours.replace("-0", "-") == theirs.replace("-0", "-")
    a, b = (dict(part.split("=") for part in text.split()) for text in (ours, theirs))
    # LAPACK gives lambda2 of a path to no more digits.
    near = lambda key, x, y: abs(x - y) <= (2e-6 * abs(y) if key == "lambda2" else 1e-8 * max(1.0, abs(y)))
    return all(near(key, float(a[key]), float(b[key])) for key in b)


def ties(ours, theirs):
    """Where the peer decides in double precision: its near ties, and how many entries of the two logs differ."""
    if "ties" not in theirs:
        return ""
    a, b = (set(text.split(",")) for text in (ours["log"], theirs["log"]))
    return "  near ties of the peer: %d; entries that differ: %d of %d" % (theirs["ties"], len(a ^ b), len(a))


def main():
    arguments = sys.argv[1:]
    out = arguments.pop(arguments.index("--json") + 1) if "--json" in arguments else None
    rest = [a for a in arguments if a != "--json"]
    rounds = int(next((a for a in rest if a.isdigit()), "3"))
    wanted = next((a for a in rest if not a.isdigit()), "")
    pairs = [pair for pair in PAIRS if wanted in " ".join([*pair[:3], *pair[3]])]
    best = {}
    for _ in range(rounds):
        for pair in pairs:
            workload, size, peer, script, _bound = pair
            a, b = ours(workload, size, peer), theirs(script)
            same = same_result(workload, a["checksum"], b["checksum"])
            key = (workload, size, peer, script[1])
            old = best.get(key, (float("inf"), float("inf"), True))
            best[key] = (min(old[0], a["seconds"]), min(old[1], b["seconds"]), old[2] and same, ties(a, b))
    failed = False
    rows = []
    print("%-4s %-20s %-16s %-12s %10s %10s %6s  %s" % ("", "size", "ours", "theirs", "ours [s]", "theirs", "ratio", "aim"))
    for workload, size, peer, script, bound in pairs:
        a, b, same, more = best[(workload, size, peer, script[1])]
        failed |= not same
        note = more + ("" if same else "  CHECKSUMS DIFFER")
        print("%-4s %-20s %-16s %-12s %10.3g %10.3g %6.2f  < %g%s" % (workload, size, peer, script[1], a, b, a / b, bound, note))
        rows.append({"workload": workload, "size": size, "ours": peer, "theirs": script[1], "ratio": round(a / b, 3), "aim": bound})
    if out:
        with open(out, "w") as handle:
            json.dump(rows, handle, indent=1)
            handle.write("\n")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
