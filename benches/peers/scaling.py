"""How a sweep scales with the workers of a Dask cluster on this machine: W11's 100 000 peaks.

usage: python scaling.py [WORKERS ..]      (default: 1 2)

Needs the package with its extra: `python3 -m pip install './python[sweep]'`. Prints the elapsed time without a cluster on one thread, then for each
number of workers (processes of one thread), whether the merged file is the same byte for byte, and what one task costs the scheduler: 1000 tasks
that do nothing, divided by 1000.
"""
import hashlib
import sys
import tempfile
import time
from pathlib import Path

import flockproof
from distributed import Client, LocalCluster
from w11_sweep import QUESTION


def swept(client, threads):
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        flockproof.sweep(QUESTION, client, store=folder, shards=32, threads=threads)
        seconds = time.perf_counter() - start
        return seconds, hashlib.sha256((Path(folder) / "merged.jsonl").read_bytes()).hexdigest()


def main():
    alone, digest = swept(None, 1)
    print("no cluster, one thread: %.1f s" % alone)
    for workers in [int(n) for n in sys.argv[1:]] or [1, 2]:
        with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            seconds, found = swept(client, 1)
            start = time.perf_counter()
            client.gather(client.map(abs, range(1000), pure=False))
            task = (time.perf_counter() - start) / 1000
        print("%d workers: %.1f s, %.2f of the work of one; the same bytes: %s; an empty task %.2f ms"
              % (workers, seconds, alone / seconds, found == digest, 1e3 * task))


if __name__ == "__main__":
    main()
