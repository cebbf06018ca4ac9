"""New primitives next to stored ones: what a library does when it learns a primitive of another one again under its own pose maps.

The pose maps and the first primitives are stored: their q(e) stay as they are. The experts of all other primitives have the best q(e)
for the movements, independent of the stored ones. Divergences of stored processes are constants and left out.

The best q(e) is not looked up in a formula. The bound that is written down here is quadratic in the mean, column by column alike: its
first and second derivatives at zero, taken automatically, say where it is highest, and the second one is minus the best precision.
"""

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
from jax.scipy.linalg import block_diag

import bound
import movements
from bound import Array, Gaussian, Params, Regression


class Stored(NamedTuple):
    """The fixed posteriors, whitened."""

    kinematics: list[Gaussian]  # of each part's pose map
    dynamics: list[Gaussian]  # into each part, the experts of the stored primitives stacked


def roots(params: Params, primitives: int, jitter: float) -> Stored:
    """The roots of the covariances of the stored processes, in the places of their Gaussians."""
    return Stored(
        [bound.root(bound.pose_process(part), jitter) for part in params["parts"]],
        [
            block_diag(*[bound.root(bound.expert_process(p["dyn"][i]), jitter) for p in params["primitives"][:primitives]])
            for i in range(len(params["parts"]))
        ],
    )


def whitened(lower: Array, q: Gaussian) -> Gaussian:
    white = bound.whitening(lower)
    return Gaussian(white @ q.mean, white @ q.covariance @ white.T)


def together(kept: Gaussian, new: Gaussian) -> Gaussian:
    return Gaussian(jnp.concatenate([kept.mean, new.mean]), block_diag(kept.covariance, new.covariance))


def term(kept: Gaussian, new: Gaussian, regressions: list[Regression]) -> Array:
    """The expected log likelihood of the rows under both, minus the divergence of the new experts."""
    q = together(kept, new)
    return sum(bound.expected_log_likelihood(q, regression) for regression in regressions) - bound.divergence(new)


def best_with_stored(kept: Gaussian, regressions: list[Regression]) -> Gaussian:
    """The q(e) of the new experts at which the term is highest."""
    features, columns = regressions[0].phi.first.shape[1], regressions[0].target.shape[1]
    new = features - len(kept.mean)

    def at(mean: Array) -> Array:
        return term(kept, Gaussian(mean, jnp.eye(new)), regressions)

    zero = jnp.zeros((new, columns))
    precision = -jax.hessian(lambda column: at(zero.at[:, 0].set(column)))(zero[:, 0])
    return Gaussian(jnp.linalg.solve(precision, jax.grad(at)(zero)), jnp.linalg.inv(precision))


def bound_and_terms(params: Params, kept: Stored, shared: movements.Shared) -> tuple[Array, dict[str, Any]]:
    groups = movements.regressions(params, shared)

    def dynamics(q: Gaussian, regressions: list[Regression]) -> Array:
        # At the best q(e) the bound does not change with q(e) to first order, so the gradient may treat q(e) as constant.
        return term(q, jax.lax.stop_gradient(best_with_stored(q, regressions)), regressions)

    terms = {
        "kinematics": [
            bound.expected_log_likelihood(q, *group) for q, group in zip(kept.kinematics, groups["kinematics"])
        ],
        "dynamics": [dynamics(*pair) for pair in zip(kept.dynamics, groups["dynamics"])],
        **bound.latent_terms(params, shared.problem),
    }
    return sum(jax.tree.leaves(terms)), terms
