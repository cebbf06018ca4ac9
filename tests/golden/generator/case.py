"""A golden case: a problem and a point in its parameter space as JSON, and everything that is expected of it."""

from typing import Any

import jax
import jax.numpy as jnp

import bound

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
    """What is expected of a case: `given` is its input; of `rollouts` only alpha, x0 and steps are read."""
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
