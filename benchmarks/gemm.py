"""Rate of NumPy's matrix product in float32: prints ``<flop/s> <instruction set>``.

    OPENBLAS_NUM_THREADS=1 [OPENBLAS_CORETYPE=SkylakeX] python benchmarks/gemm.py 2048 1 5

The arguments are the side of the matrices, the seconds of a repeat and the number of repeats. The
product of n x n matrices counts as 2 n^3 flop. It is a separate process because OpenBLAS chooses
its instruction set when it is loaded.
"""

from __future__ import annotations

import sys

import numpy as np

from timing import Clock

try:
    from threadpoolctl import threadpool_info
except ImportError:

    def threadpool_info() -> list[dict[str, str]]:
        """Return no information: threadpoolctl is not installed."""
        return []


def main() -> None:
    side, clock = int(sys.argv[1]), Clock(float(sys.argv[2]), int(sys.argv[3]))
    rng = np.random.default_rng(0)
    one, other = rng.standard_normal((2, side, side), dtype=np.float32)
    # Allocated once: page faults of a new result would count as part of the product.
    product = np.empty((side, side), np.float32)

    def play(_: int) -> int:
        np.matmul(one, other, out=product)
        return 2 * side**3

    sets = [pool.get("architecture", "unknown") for pool in threadpool_info()]
    print(clock.rate(play), *(sets or ["unknown"]))


if __name__ == "__main__":
    main()
