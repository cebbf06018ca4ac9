"""Makes golden cases: random problems from a seed, with their expected numbers.

    python make_golden.py OUT_DIR [--case K ...] [--seed S] [--movements | --stored]

writes OUT_DIR/case-K.json, a problem of the same sizes as the stored case K with other numbers. Without --case, all;
without --seed, the seed of case K is K. With --movements, OUT_DIR/movements-K.json: movements that share primitives. With
--stored, OUT_DIR/stored-K.json: new primitives next to stored ones.
"""

import argparse
import json
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import stored_primitives
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


class Sharing(NamedTuple):
    parts: list[Part]
    dynamics_inputs: int
    primitives: list[int]  # the part of each
    movements: list[tuple[list[int], list[int]]]  # lengths of the sequences, the primitive of each part
    order: int


MOVEMENTS = [
    # Two movements with the first part's primitive in common.
    Sharing([Part(2, 4, 5), Part(2, 5, 5)], 4, [0, 1, 1], [([10, 8], [0, 1]), ([9], [0, 2])], 2),
    # Three of the four combinations of two primitives of each of two parts.
    Sharing([Part(2, 3, 4), Part(1, 3, 4)], 3, [0, 0, 1, 1], [([9], [0, 2]), ([8], [1, 3]), ([7, 7], [0, 3])], 2),
    # One primitive in two movements of one part.
    Sharing([Part(2, 4, 4)], 4, [0], [([8], [0]), ([7], [0])], 1),
]
# The same with the number of first primitives that are stored.
STORED = [
    # New arms with stored legs, in one movement.
    (Sharing([Part(2, 4, 5), Part(2, 5, 5)], 4, [0, 1], [([10, 8], [0, 1])], 2), 1),
    # New primitives of both parts, each also with a stored primitive of the other part; one stored primitive is not used.
    (Sharing([Part(2, 3, 4), Part(1, 3, 4)], 3, [0, 1, 1, 0, 1], [([9], [0, 4]), ([8], [3, 1]), ([7], [3, 4])], 2), 3),
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


class Draw(NamedTuple):
    """Random values of the parameters."""

    rng: np.random.Generator
    frames: int

    def between(self, low: float, high: float, *shape: int) -> Any:
        """Positive numbers, evenly spread in their logarithm."""
        return np.exp(self.rng.uniform(np.log(low), np.log(high), shape)).tolist()

    def part(self, sizes: Part) -> case.Json:
        squared_lengthscales = self.between(0.5, 2, sizes.latent)
        return {
            "mu": self.rng.normal(size=(self.frames, sizes.latent)).tolist(),
            "s": self.between(0.01, 0.3, self.frames, sizes.latent),
            "r": inducing_inputs(sizes.pose_inputs, squared_lengthscales, self.rng),
            "kin_lambda": squared_lengthscales,
            "kin_var": self.between(0.5, 2),
            "beta": self.between(0.05, 0.5),
        }

    def expert(self, source: Part, count: int, order: int) -> case.Json:
        squared_lengthscales = self.between(0.7, 3, order * source.latent)
        return {
            "z": inducing_inputs(count, squared_lengthscales, self.rng),
            "lambda": squared_lengthscales,
            "var": 1.0,  # fixed: otherwise it could be traded for the coupling
        }

    def observations(self, sizes: Part) -> Any:
        y = self.rng.normal(size=(self.frames, sizes.observed))
        return (y - y.mean(axis=0)).tolist()


def draw(sizes: Sizes, rng: np.random.Generator) -> tuple[case.Json, list[case.Json]]:
    """A problem with a point in its parameter space, and the rollouts to ask for: as learned, and with other couplings."""
    count = len(sizes.parts)
    random = Draw(rng, sum(sizes.lengths))
    parts = [random.part(its_sizes) for its_sizes in sizes.parts]
    experts = [
        [random.expert(source, sizes.dynamics_inputs, sizes.order) for _ in sizes.parts] for source in sizes.parts
    ]
    alpha = random.between(0.02, 1.5, count, count)
    given = {
        "params": {"parts": parts, "dyn": experts, "alpha": alpha},
        "y": [random.observations(its_sizes) for its_sizes in sizes.parts],
        "lengths": sizes.lengths,
        "order": sizes.order,
    }
    start = [values["mu"][: sizes.order] for values in parts]
    other = (np.array(alpha) * random.between(0.2, 5, count, count)).tolist()
    return given, [{"alpha": couplings, "x0": start, "steps": STEPS} for couplings in (alpha, other)]


def draw_movements(sizes: Sharing, rng: np.random.Generator) -> case.Json:
    """Movements that share primitives, with a point in their parameter space."""
    count = len(sizes.parts)
    random = Draw(rng, sum(sum(lengths) for lengths, _ in sizes.movements))
    parts = [random.part(its_sizes) for its_sizes in sizes.parts]
    primitives = [
        {"part": j, "dyn": [random.expert(sizes.parts[j], sizes.dynamics_inputs, sizes.order) for _ in sizes.parts]}
        for j in sizes.primitives
    ]
    alpha = random.between(0.02, 1.5, len(sizes.movements), count, count)
    return {
        "params": {"parts": parts, "primitives": primitives, "alpha": alpha},
        "y": [random.observations(its_sizes) for its_sizes in sizes.parts],
        "movements": [{"lengths": lengths, "uses": uses} for lengths, uses in sizes.movements],
        "order": sizes.order,
    }


def draw_stored(given: case.Json, primitives: int, rng: np.random.Generator) -> case.Json:
    """Gaussians of the inducing outputs of the pose maps and the first primitives."""
    _, params = case.shared_and_params(given)
    roots = stored_primitives.roots(params, primitives, 0.0)

    def gaussian(root: np.ndarray, columns: int) -> case.Json:
        size = len(root)
        axes, _ = np.linalg.qr(rng.normal(size=(size, size)))
        covariance = root @ (axes * rng.uniform(0.05, 0.9, size)) @ axes.T @ root.T
        mean = root @ rng.normal(size=(size, columns))
        return {"mean": mean.tolist(), "cov": ((covariance + covariance.T) / 2).tolist()}

    widths = [[len(y[0]) for y in given["y"]], [len(part["mu"][0]) for part in given["params"]["parts"]]]
    kinematics, dynamics = ([gaussian(np.array(r), c) for r, c in zip(*pair)] for pair in zip(roots, widths))
    return {"primitives": primitives, "kin": kinematics, "dyn": dynamics}


def make(number: int, seed: int) -> case.Json:
    given, rollouts = draw(CASES[number], np.random.default_rng((number, seed)))
    return {
        "about": f"vCGPDM bound in natural parameters; no jitter; tests/golden/generator, case {number}, seed {seed}",
        "input": given,
        "expected": case.evaluate(given, rollouts),
    }


def make_movements(number: int, seed: int) -> case.Json:
    given = draw_movements(MOVEMENTS[number], np.random.default_rng((number, seed, 1)))
    about = "bound of movements that share primitives, in natural parameters; no jitter"
    return {
        "about": f"{about}; tests/golden/generator, movements {number}, seed {seed}",
        "input": given,
        "expected": case.evaluate(given, []),
    }


def make_stored(number: int, seed: int) -> case.Json:
    sizes, primitives = STORED[number]
    rng = np.random.default_rng((number, seed, 2))
    given = draw_movements(sizes, rng)
    given["stored"] = draw_stored(given, primitives, rng)
    about = "bound of new primitives next to stored ones, in natural parameters; no jitter"
    return {
        "about": f"{about}; tests/golden/generator, stored {number}, seed {seed}",
        "input": given,
        "expected": case.evaluate(given, []),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description="Makes golden cases of the vCGPDM bound.")
    parser.add_argument("out", type=Path, metavar="OUT_DIR")
    parser.add_argument("--case", type=int, action="append", help="may be given several times")
    sorts = parser.add_mutually_exclusive_group()
    sorts.add_argument("--movements", action="store_true", help="movements that share primitives")
    sorts.add_argument("--stored", action="store_true", help="new primitives next to stored ones")
    parser.add_argument("--seed", type=int, help="the seed of all cases made; without it, each case has its number as its seed")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    sizes, name, make_one = CASES, "case", make
    if arguments.movements:
        sizes, name, make_one = MOVEMENTS, "movements", make_movements
    if arguments.stored:
        sizes, name, make_one = STORED, "stored", make_stored
    for number in arguments.case or range(len(sizes)):
        if number not in range(len(sizes)):
            parser.error(f"--case {number}: expected from 0 to {len(sizes) - 1}")
        file = arguments.out / f"{name}-{number}.json"
        expected = make_one(number, number if arguments.seed is None else arguments.seed)
        file.write_text(json.dumps(expected) + "\n", encoding="utf-8")
        print(f"wrote {file}", flush=True)


if __name__ == "__main__":
    main()
