"""A golden case as JSON: a problem, a point in its parameter space and the expected numbers."""

from typing import Any

import jax
import jax.numpy as jnp

import stored_primitives
import bound
import movements

Json = Any


def arrays(value: Json) -> Any:
    """Numbers and nested lists of numbers become arrays; objects, and lists of objects or of lists of objects, stay."""
    if isinstance(value, dict):
        return {name: arrays(entry) for name, entry in value.items()}
    if isinstance(value, list) and holds_objects(value):
        return [arrays(entry) for entry in value]
    return jnp.asarray(value, dtype=jnp.float64)


def holds_objects(value: Json) -> bool:
    return isinstance(value, dict) or (isinstance(value, list) and any(map(holds_objects, value)))


def plain(value: Any) -> Json:
    return jax.tree.map(lambda entry: entry.tolist(), value)


def problem_of(given: Json) -> bound.Problem:
    observations = [jnp.asarray(y, dtype=jnp.float64) for y in given["y"]]
    return bound.Problem(observations, given["lengths"], given["order"], given.get("jitter", 0.0))


def evaluate(given: Json, rollouts: list[Json]) -> Json:
    """The expected numbers of a case. `given` is its input; of `rollouts` only alpha, x0 and steps count."""
    if "stored" in given:
        return evaluate_stored(given)
    return evaluate_movements(given) if "movements" in given else evaluate_plain(given, rollouts)


def shared_and_params(given: Json) -> tuple[movements.Shared, bound.Params]:
    """Movements that share primitives, and a point in their parameter space."""
    lengths = [length for movement in given["movements"] for length in movement["lengths"]]
    problem = problem_of({**given, "lengths": lengths})
    owners = [primitive["part"] for primitive in given["params"]["primitives"]]
    shared = movements.Shared(problem, given["movements"], owners)
    # The part of a primitive is a place, not a number to differentiate by.
    experts = [{"dyn": primitive["dyn"]} for primitive in given["params"]["primitives"]]
    return shared, arrays({**given["params"], "primitives": experts})


def latents_of(gradient: bound.Params) -> Json:
    return [{name: plain(part[name]) for name in ("mu", "s")} for part in gradient["parts"]]


def evaluate_stored(given: Json) -> Json:
    """The expected numbers of new primitives next to stored ones; fixed parameters have no gradient."""
    shared, params = shared_and_params(given)
    stored, jitter = given["stored"], shared.problem.jitter
    primitives = stored["primitives"]
    lower = stored_primitives.roots(params, primitives, jitter)

    def whitened(group: Json, roots: list[bound.Array]) -> list[bound.Gaussian]:
        return [stored_primitives.whitened(root, bound.Gaussian(arrays(q["mean"]), arrays(q["cov"]))) for q, root in zip(group, roots)]

    kept = stored_primitives.Stored(whitened(stored["kin"], lower.kinematics), whitened(stored["dyn"], lower.dynamics))
    differentiated = jax.value_and_grad(lambda params: stored_primitives.bound_and_terms(params, kept, shared), has_aux=True)
    (value, terms), gradient = jax.jit(differentiated)(params)
    return {
        "elbo": plain(value),
        "terms": plain(terms),
        "gradient": {
            "parts": latents_of(gradient),
            "alpha": plain(gradient["alpha"]),
            "dyn": [plain(primitive["dyn"]) for primitive in gradient["primitives"][primitives:]],
        },
    }


def evaluate_movements(given: Json) -> Json:
    """The expected numbers of movements that share primitives."""
    shared, params = shared_and_params(given)
    differentiated = jax.value_and_grad(lambda params: movements.bound_and_terms(params, shared), has_aux=True)
    (value, terms), gradient = jax.jit(differentiated)(params)
    kept = jax.jit(lambda params: movements.best_gaussians(params, shared))(params)
    alone = jax.value_and_grad(lambda params: movements.bound_given(params, kept, shared))
    value_given, gradient_given = jax.jit(alone)(params)
    posteriors = jax.jit(lambda params: movements.posteriors(params, shared))(params)

    def gaussians(group: list[bound.Gaussian]) -> Json:
        return [{"mean": plain(q.mean), "cov": plain(q.covariance)} for q in group]

    return {
        "elbo": plain(value),
        "terms": plain(terms),
        "gradient": {
            "parts": plain(gradient["parts"]),
            "alpha": plain(gradient["alpha"]),
            "dyn": [plain(primitive["dyn"]) for primitive in gradient["primitives"]],
        },
        "posterior": {"kin": gaussians(posteriors["kinematics"]), "dyn": gaussians(posteriors["dynamics"])},
        "elbo_given": plain(value_given),
        "gradient_given": {
            "parts": latents_of(gradient_given),
            "alpha": plain(gradient_given["alpha"]),
        },
    }


def evaluate_plain(given: Json, rollouts: list[Json]) -> Json:
    """The expected numbers of the plain model."""
    params, problem = arrays(given["params"]), problem_of(given)
    differentiated = jax.value_and_grad(lambda params: bound.bound_and_terms(params, problem), has_aux=True)
    (value, terms), gradient = jax.jit(differentiated)(params)
    learned = jax.jit(lambda params: bound.functions(params, problem))(params)
    roll = jax.jit(bound.rollout, static_argnames="steps")

    def gaussians(group: list[bound.Function]) -> Json:
        return [{"mean": plain(q.mean), "cov": plain(q.covariance)} for q in map(bound.posterior, group)]

    def rolled(request: Json) -> Json:
        start = [jnp.asarray(rows, dtype=jnp.float64) for rows in request["x0"]]
        x, y = roll(learned, jnp.asarray(request["alpha"], dtype=jnp.float64), start, steps=request["steps"])
        return {"alpha": request["alpha"], "x0": request["x0"], "steps": request["steps"], "x": plain(x), "y": plain(y)}

    return {
        "elbo": plain(value),
        "terms": plain(terms),
        "gradient": plain(gradient),
        "posterior": {"kin": gaussians(learned["kinematics"]), "dyn": gaussians(learned["dynamics"])},
        "rollouts": [rolled(request) for request in rollouts],
    }
