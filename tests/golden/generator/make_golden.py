"""Makes golden cases: random problems from a seed, with everything that is expected of them.

    python make_golden.py OUT_DIR [--case K ...] [--seed S]

writes OUT_DIR/case-K.json, a problem of the same sizes as the stored case K with other numbers. Without --case, all four;
without --seed, the seed of case K is K.
"""

import argparse
import json
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import bound
import case


class Part(NamedTuple):
    latent: int  # Q
    observed: int  # D
    pose_inputs: int  # inducing points of the pose map


class Sizes(NamedTuple):
    parts: list[Part]
    dynamics_inputs: int  # inducing points of every expert
    lengths: list[int]
    order: int


CASES = [
    Sizes([Part(2, 5, 5)], 4, [12], 2),
    Sizes([Part(2, 4, 5), Part(3, 6, 6)], 5, [11, 8], 2),
    Sizes([Part(2, 3, 4), Part(1, 3, 4)], 4, [14], 1),
    Sizes([Part(1, 3, 4), Part(2, 4, 5), Part(2, 2, 4)], 4, [9, 7, 6], 2),
]
STEPS = 20  # of each rollout
LEAST_EIGENVALUE = 1e-5  # of the covariance of inducing outputs, relative to the signal variance


def inducing_inputs(count: int, squared_lengthscales: list[float], rng: np.random.Generator) -> Any:
    """Random inputs, drawn again while some lie so close that two programs would agree on few digits only."""
    while True:
        inputs = 1.5 * rng.normal(size=(count, len(squared_lengthscales)))
        covariance = bound.kernel(bound.Process(inputs, np.array(squared_lengthscales), np.array(1.0)), inputs)
        if np.linalg.eigvalsh(covariance)[0] > LEAST_EIGENVALUE:
            return inputs.tolist()


def draw(sizes: Sizes, rng: np.random.Generator) -> tuple[case.Json, list[case.Json]]:
    """A problem with a point in its parameter space, and the rollouts to ask for: as learned, and with other couplings."""
    frames, count = sum(sizes.lengths), len(sizes.parts)

    def between(low: float, high: float, *shape: int) -> Any:
        """Positive numbers, evenly spread in their logarithm."""
        return np.exp(rng.uniform(np.log(low), np.log(high), shape)).tolist()

    def normal(*shape: int) -> Any:
        return rng.normal(size=shape).tolist()

    def part(sizes: Part) -> case.Json:
        squared_lengthscales = between(0.5, 2, sizes.latent)
        return {
            "mu": normal(frames, sizes.latent),
            "s": between(0.01, 0.3, frames, sizes.latent),
            "r": inducing_inputs(sizes.pose_inputs, squared_lengthscales, rng),
            "kin_lambda": squared_lengthscales,
            "kin_var": between(0.5, 2),
            "beta": between(0.05, 0.5),
        }

    def expert(source: Part) -> case.Json:
        squared_lengthscales = between(0.7, 3, sizes.order * source.latent)
        return {
            "z": inducing_inputs(sizes.dynamics_inputs, squared_lengthscales, rng),
            "lambda": squared_lengthscales,
            "var": 1.0,  # fixed: otherwise it could be traded for the coupling
        }

    parts = [part(its_sizes) for its_sizes in sizes.parts]
    experts = [[expert(source) for _ in sizes.parts] for source in sizes.parts]
    alpha = between(0.02, 1.5, count, count)
    observations = []
    for its_sizes in sizes.parts:
        y = rng.normal(size=(frames, its_sizes.observed))
        observations.append((y - y.mean(axis=0)).tolist())
    given = {
        "params": {"parts": parts, "dyn": experts, "alpha": alpha},
        "y": observations,
        "lengths": sizes.lengths,
        "order": sizes.order,
    }
    start = [values["mu"][: sizes.order] for values in parts]
    other = (np.array(alpha) * between(0.2, 5, count, count)).tolist()
    return given, [{"alpha": couplings, "x0": start, "steps": STEPS} for couplings in (alpha, other)]


def make(number: int, seed: int) -> case.Json:
    given, rollouts = draw(CASES[number], np.random.default_rng((number, seed)))
    return {
        "about": f"vCGPDM bound in natural parameters; no jitter; tests/golden/generator, case {number}, seed {seed}",
        "input": given,
        "expected": case.evaluate(given, rollouts),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description="Makes golden cases of the vCGPDM bound.")
    parser.add_argument("out", type=Path, metavar="OUT_DIR")
    parser.add_argument("--case", type=int, action="append", choices=range(len(CASES)), help="may be given several times")
    parser.add_argument("--seed", type=int, help="the seed of all cases made; without it, each case has its number as its seed")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    for number in arguments.case or range(len(CASES)):
        file = arguments.out / f"case-{number}.json"
        file.write_text(json.dumps(make(number, number if arguments.seed is None else arguments.seed)) + "\n", encoding="utf-8")
        print(f"wrote {file}", flush=True)


if __name__ == "__main__":
    main()
