"""Movements that share primitives: P2, section 5.5. A primitive belongs to one part and holds its predictions about every part.

params["primitives"][a]  {"part": j, "dyn": [expert about part 0, expert about part 1, ...]}
params["alpha"][m][j][i] coupling variance of part j's prediction about part i in movement m
movements[m]             {"lengths": frames of its sequences, "uses": the primitive of part 0, of part 1, ...}

The frames of all movements are stacked, movement after movement. An expert's inducing outputs are one set of random numbers that every
movement using it sees, each with its own noise: regressions on the same features, and one Kullback-Leibler divergence for all.
"""

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax.scipy.linalg import block_diag

import bound
from bound import Array, Features, Gaussian, Params, Problem, Regression

Movement = dict[str, Any]


class Shared(NamedTuple):
    """A problem whose sequences belong to movements."""

    problem: Problem
    movements: list[Movement]
    parts: list[int]  # to which part each primitive belongs


def rows_of(shared: Shared) -> list[tuple[np.ndarray, np.ndarray]]:
    """For each movement the frames that the dynamics predict, and those that each is predicted from."""
    predicted, history = bound.predicted_rows(shared.problem)
    out, first = [], 0
    for movement in shared.movements:
        end = first + sum(movement["lengths"])
        own = (predicted >= first) & (predicted < end)
        out.append((predicted[own], history[own]))
        first = end
    return out


def dynamics_regressions(params: Params, shared: Shared, i: int) -> list[Regression]:
    """The dynamics into part i, a regression for each movement, on the features of all primitives' experts."""
    out = []
    for m, (movement, (predicted, history)) in enumerate(zip(shared.movements, rows_of(shared))):
        weights, noise = bound.product_of_experts(params["alpha"][m], i)

        def features(a: int) -> tuple[Features, Array]:
            """Of primitive a, and the weight that it has in this movement: none where another one is used."""
            j, source = shared.parts[a], params["parts"][shared.parts[a]]
            mean, variance = (source[name][history].reshape(len(history), -1) for name in ("mu", "s"))
            process = bound.expert_process(params["primitives"][a]["dyn"][i])
            weight = weights[j] if movement["uses"][j] == a else 0.0
            return bound.features(process, mean, variance, shared.problem.jitter), weight

        experts, used = zip(*(features(a) for a in range(len(shared.parts))))
        part = params["parts"][i]
        phi = bound.weighted_sum(list(experts), jnp.array(used))
        out.append(Regression(phi, part["mu"][predicted], part["s"][predicted], noise))
    return out


def regressions(params: Params, shared: Shared) -> dict[str, list[list[Regression]]]:
    parts = range(len(params["parts"]))
    return {
        "kinematics": [[bound.pose_regression(params, shared.problem, i)] for i in parts],
        "dynamics": [dynamics_regressions(params, shared, i) for i in parts],
    }


def bound_and_terms(params: Params, shared: Shared) -> tuple[Array, dict[str, Any]]:
    """The bound of all movements together and its terms."""

    def term(group: list[Regression]) -> Array:
        return bound.regression_bound(jax.lax.stop_gradient(bound.best_gaussian(*group)), *group)

    terms = {name: [term(group) for group in groups] for name, groups in regressions(params, shared).items()}
    terms = {**terms, **bound.latent_terms(params, shared.problem)}
    return sum(jax.tree.leaves(terms)), terms


def best_gaussians(params: Params, shared: Shared) -> dict[str, list[Gaussian]]:
    """The best q(e) of every map: what a library keeps."""
    groups = regressions(params, shared)
    return {name: [bound.best_gaussian(*group) for group in groups[name]] for name in groups}


def bound_given(params: Params, kept: dict[str, list[Gaussian]], shared: Shared) -> Array:
    """The bound when the inducing outputs are kept as they are; their divergence, a constant, is left out."""
    likelihoods = [
        bound.expected_log_likelihood(q, regression)
        for name, groups in regressions(params, shared).items()
        for q, group in zip(kept[name], groups)
        for regression in group
    ]
    return sum(likelihoods) + sum(bound.latent_terms(params, shared.problem).values())


def posteriors(params: Params, shared: Shared) -> dict[str, list[Gaussian]]:
    """The best q(v) of each part and q(u) into each part, the experts of all primitives stacked."""
    jitter = shared.problem.jitter
    roots = {
        "kinematics": [[bound.root(bound.pose_process(part), jitter)] for part in params["parts"]],
        "dynamics": [
            [bound.root(bound.expert_process(primitive["dyn"][i]), jitter) for primitive in params["primitives"]]
            for i in range(len(params["parts"]))
        ],
    }

    def unwhitened(lower: list[Array], q: Gaussian) -> Gaussian:
        root = block_diag(*lower)
        return Gaussian(root @ q.mean, root @ q.covariance @ root.T)

    kept = best_gaussians(params, shared)
    return {name: [unwhitened(*pair) for pair in zip(roots[name], kept[name])] for name in roots}
