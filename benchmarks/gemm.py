"""The rate of NumPy's matrix product in float32: a line ``<flop/s> <instruction set>``.

    OPENBLAS_NUM_THREADS=1 [OPENBLAS_CORETYPE=SkylakeX] python benchmarks/gemm.py 2048 1 5

Arguments are the side of the matrices, seconds of a repeat and repeats. The product of n x n
matrices counts as 2 n^3 flop. A process of its own, since OpenBLAS chooses its instruction set as
it is loaded.
"""

from __future__ import annotations

import sys

import numpy as np

from timing import Clock

try:
    from threadpoolctl import threadpool_info
except ImportError:

    def threadpool_info() -> list[dict[str, str]]:
        """Nothing is known."""
        return []


def main() -> None:
    side, clock = int(sys.argv[1]), Clock(float(sys.argv[2]), int(sys.argv[3]))
    rng = np.random.default_rng(0)
    one, other = rng.standard_normal((2, side, side), dtype=np.float32)
    product = np.empty((side, side), np.float32)

    def play(_: int) -> int:
        np.matmul(one, other, out=product)
        return 2 * side**3

    sets = [pool.get("architecture", "unknown") for pool in threadpool_info()]
    print(clock.rate(play), *(sets or ["unknown"]))


if __name__ == "__main__":
    main()
