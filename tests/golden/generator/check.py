"""Computes the stored golden cases again from their inputs and compares every number.

    python check.py [CASE.json ...]

Without files, all cases in the folder above this one. Ends with 1 when a number is further away than it may be.
"""

import json
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import bound
import case

# How far a number may be from the stored one, relative to the largest number of its block. Not entry by entry: some
# inducing inputs of case 2 lie so close that a covariance has eigenvalues down to 5e-9, and what is left of the small
# entries of that gradient is rounding.
TOLERANCES = {
    "elbo": 1e-9,
    "terms": 1e-9,
    "gradient": 1e-7,
    "posterior": 1e-7,
    "rollouts": 1e-7,
    "elbo_given": 1e-9,
    "gradient_given": 1e-7,
}
QUADRATURE_TOLERANCE = 1e-12


def pairs(ours: case.Json, stored: case.Json, path: str) -> Iterator[tuple[float, float, str]]:
    """Each stored number with ours and its place; another structure gives an infinite difference."""
    if isinstance(stored, dict) and isinstance(ours, dict) and stored.keys() == ours.keys():
        for name in stored:
            yield from pairs(ours[name], stored[name], f"{path}.{name}")
    elif isinstance(stored, list) and isinstance(ours, list) and len(stored) == len(ours):
        for k, entries in enumerate(zip(ours, stored)):
            yield from pairs(*entries, f"{path}[{k}]")
    elif isinstance(stored, (int, float)) and isinstance(ours, (int, float)):
        yield ours, stored, path
    else:
        yield float("inf"), 0.0, path


def difference(ours: case.Json, stored: case.Json, block: str) -> tuple[float, str]:
    """The largest difference of a block, relative to its largest stored number, and its place."""
    numbers = list(pairs(ours, stored, block))
    largest = max(abs(expected) for _, expected, _ in numbers)
    # All comparisons with NaN are false, so NaN counts as infinitely far away.
    distances = [
        (abs(computed - expected) if np.isfinite(computed - expected) else float("inf"), path)
        for computed, expected, path in numbers
    ]
    furthest, path = max(distances)
    return furthest / largest, path


def without_requests(expected: case.Json) -> case.Json:
    """The expected numbers alone: of rollouts the latents and poses, without their settings."""
    if "rollouts" not in expected:
        return expected
    return {**expected, "rollouts": [{"x": rolled["x"], "y": rolled["y"]} for rolled in expected["rollouts"]]}


def quadrature_difference() -> float:
    """The largest relative difference between psi1 and psi2 and their integrals, taken numerically.

    The kernel is a product over dimensions and q(x) too, so each integral is a product of one-dimensional ones.
    """
    rng = np.random.default_rng(0)
    rows, inputs, dims = 6, 5, 4
    mean, variance = rng.normal(size=(rows, dims)), rng.uniform(0.01, 0.5, (rows, dims))
    process = bound.Process(rng.normal(size=(inputs, dims)), rng.uniform(0.7, 3, dims), np.array(1.4))

    nodes, weights = np.polynomial.hermite_e.hermegauss(80)
    weights = weights / np.sqrt(2 * np.pi)
    x = mean[:, None, :, None] + np.sqrt(variance)[:, None, :, None] * nodes  # [rows x 1 x dims x nodes]
    scaled = (x - process.inputs[:, :, None]) ** 2 / process.squared_lengthscales[:, None]
    factor = np.exp(-0.5 * scaled)  # the kernel's, of each dimension, [rows x inputs x dims x nodes]
    first = process.signal_variance * np.prod(factor @ weights, axis=-1)
    second = process.signal_variance**2 * np.prod((factor[:, :, None] * factor[:, None, :]) @ weights, axis=-1)
    return max(
        float(np.max(np.abs(bound.psi1(process, mean, variance) / first - 1))),
        float(np.max(np.abs(bound.psi2(process, mean, variance) / second - 1))),
    )


def main() -> int:
    files = [Path(name) for name in sys.argv[1:]] or sorted(Path(__file__).parent.parent.glob("*-*.json"))
    if not files:
        print("no golden cases found")
        return 1
    failed = 0

    distance = quadrature_difference()
    print(f"psi statistics and numerical integrals differ by {distance:.1e}, at most {QUADRATURE_TOLERANCE:.0e}")
    failed += not distance <= QUADRATURE_TOLERANCE

    print("\nLargest difference from the stored number, relative to the largest number of the block:\n")
    print(" " * 17 + "".join(f"{block:>15}" for block in TOLERANCES))
    print(f"{'at most':<17}" + "".join(f"{tolerance:>15.0e}" for tolerance in TOLERANCES.values()))
    for file in files:
        stored = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
        if "expected" not in stored:
            print(f"{file} is not a golden case with expected numbers")
            failed += 1
            continue
        ours = without_requests(case.evaluate(stored["input"], stored["expected"].get("rollouts", [])))
        expected = without_requests(stored["expected"])
        found = {block: difference(ours[block], expected[block], block) for block in TOLERANCES if block in expected}
        shown = [f"{found[block][0]:>15.1e}" if block in found else " " * 15 for block in TOLERANCES]
        print(f"{file.name:<17}" + "".join(shown), flush=True)
        for block, (distance, path) in found.items():
            if not distance <= TOLERANCES[block]:
                print(f"  too far: {path}")
                failed += 1
    print("\nall agree" if failed == 0 else f"\n{failed} failed")
    return 0 if failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
