"""The evidence lower bound of the vCGPDM, written for reading and comparing, not for speed.

P1 is Velychko, Knopp, Endres 2017 with its supplement (S), P2 is Velychko, Knopp, Endres 2018 with its appendices (A).
README.md lists the equations and the differences from the papers.

The program in Rust takes each Gaussian process's term with its inducing outputs already integrated out. Here the inducing
outputs stay: q(u) is a Gaussian that is written down, and the term is an expected log likelihood minus a Kullback-Leibler
divergence. At the best q(u) both are the same number; the formulas have little in common.

All Gaussian processes are whitened: with K = L L^T, u = L e and e ~ N(0, I). The value at an input x is then a linear
regression, e^T phi(x) plus an independent rest, on the features phi(x) = L^-1 k(x).
"""

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax.scipy.linalg import block_diag, solve_triangular

jax.config.update("jax_enable_x64", True)

Array = jax.Array
Params = dict[str, Any]


# --- The kernel and its expectations -------------------------------------------------------------------------------------


class Process(NamedTuple):
    """A Gaussian process with mean zero and an ARD squared exponential kernel, at its inducing inputs."""

    inputs: Array  # [K x P]
    squared_lengthscales: Array  # [P]
    signal_variance: Array


def log_normal(x: Array, mean: Array, variance: Array) -> Array:
    """log N(x; mean, diag(variance)) over the last axis."""
    return -0.5 * jnp.sum(jnp.log(2 * jnp.pi * variance) + (x - mean) ** 2 / variance, axis=-1)


def log_normaliser(process: Process) -> Array:
    """The logarithm of the factor between kernel and normal density: log Z(lambda) of P2 (A15)."""
    return 0.5 * jnp.sum(jnp.log(2 * jnp.pi * process.squared_lengthscales))


def kernel(process: Process, x: Array) -> Array:
    """k(x_t, z_a), P2 (A9): x [T x P] -> [T x K]."""
    difference = x[:, None, :] - process.inputs
    return process.signal_variance * jnp.exp(-0.5 * jnp.sum(difference**2 / process.squared_lengthscales, axis=-1))


def psi1(process: Process, mean: Array, variance: Array) -> Array:
    """E[k(x_t, z_a)] for x_t ~ N(mean_t, diag(variance_t)), P2 (A16): [T x K]."""
    spread = process.squared_lengthscales + variance[:, None, :]
    density = log_normal(process.inputs, mean[:, None, :], spread)
    return process.signal_variance * jnp.exp(log_normaliser(process) + density)


def psi2(process: Process, mean: Array, variance: Array) -> Array:
    """E[k(x_t, z_a) k(x_t, z_b)], P2 (A17): [T x K x K]."""
    a, b = process.inputs[:, None, :], process.inputs[None, :, :]
    between = log_normal(a, b, 2 * process.squared_lengthscales)
    spread = process.squared_lengthscales / 2 + variance[:, None, None, :]
    around = log_normal(mean[:, None, None, :], (a + b) / 2, spread)
    return process.signal_variance**2 * jnp.exp(2 * log_normaliser(process) + between + around)


# --- One regression on whitened features ---------------------------------------------------------------------------------


def root(process: Process, jitter: float) -> Array:
    """L, the lower triangular root of the covariance of the inducing outputs."""
    covariance = kernel(process, process.inputs)
    return jnp.linalg.cholesky(covariance + jitter * process.signal_variance * jnp.eye(len(covariance)))


def whitening(lower: Array) -> Array:
    """L^-1, which turns k(x) into features."""
    return solve_triangular(lower, jnp.eye(len(lower)), lower=True)


class Features(NamedTuple):
    """What q(x) says about the features, for every row t."""

    first: Array  # E[phi_t], [T x K]
    second: Array  # E[phi_t phi_t^T], [T x K x K]
    rest: Array  # the expected variance of the function value when the inducing outputs are known, P2 (A25): [T]


def features(process: Process, mean: Array, variance: Array, jitter: float) -> Features:
    white = whitening(root(process, jitter))
    second = white @ psi2(process, mean, variance) @ white.T
    return Features(
        first=psi1(process, mean, variance) @ white.T,
        second=second,
        rest=process.signal_variance - jnp.trace(second, axis1=1, axis2=2),
    )


def weighted_sum(experts: list[Features], weights: Array) -> Features:
    """The features of a weighted sum of independent processes, whose inputs are independent of each other under q(x)."""

    def block(j: int, k: int) -> Array:
        if j == k:
            return weights[j] ** 2 * experts[j].second
        return weights[j] * weights[k] * experts[j].first[:, :, None] * experts[k].first[:, None, :]

    parts = range(len(experts))
    return Features(
        first=jnp.concatenate([weights[j] * experts[j].first for j in parts], axis=1),
        second=jnp.block([[block(j, k) for k in parts] for j in parts]),
        rest=sum(weights[j] ** 2 * experts[j].rest for j in parts),
    )


class Regression(NamedTuple):
    """A target that is a linear function of the features, and noise."""

    phi: Features
    target: Array  # its mean under q(x), [T x C]
    target_variance: Array  # its variance under q(x), [T x C]
    noise: Array  # the variance of the noise


class Gaussian(NamedTuple):
    """q(e): one mean for every column of the target, one covariance for all."""

    mean: Array  # [K x C]
    covariance: Array  # [K x K]


def best_gaussian(*regressions: Regression) -> Gaussian:
    """The q(e) that explains all these regressions on the same features best: Bayesian linear regression, each with its own noise.

    Of one regression P2 (A36), P1 (S36) in whitened form.
    """
    precision = jnp.eye(regressions[0].phi.first.shape[1])
    weighted = 0.0
    for phi, target, _, noise in regressions:
        precision += jnp.sum(phi.second, axis=0) / noise
        weighted += phi.first.T @ target / noise
    covariance = jnp.linalg.inv(precision)
    return Gaussian(covariance @ weighted, covariance)


def expected_log_likelihood(q: Gaussian, regression: Regression) -> Array:
    """Of the target under q(x) q(e): P2 (A22) with (A23) and (A28)."""
    phi, target, noise = regression.phi, regression.target, regression.noise
    rows, columns = target.shape
    # E[(target - e^T phi)^2] plus the rest, summed over rows and columns.
    error = jnp.sum(target**2 + regression.target_variance - 2 * target * (phi.first @ q.mean))
    error += jnp.einsum("tab,ac,bc->", phi.second, q.mean, q.mean)
    error += columns * (jnp.einsum("tab,ab->", phi.second, q.covariance) + jnp.sum(phi.rest))
    return -0.5 * rows * columns * jnp.log(2 * jnp.pi * noise) - error / (2 * noise)


def divergence(q: Gaussian) -> Array:
    """KL(q(e) || N(0, I))."""
    columns = q.mean.shape[1]
    log_determinant = jnp.linalg.slogdet(q.covariance)[1]
    return 0.5 * (jnp.sum(q.mean**2) + columns * (jnp.trace(q.covariance) - len(q.covariance) - log_determinant))


def regression_bound(q: Gaussian, *regressions: Regression) -> Array:
    """Expected log likelihood of all targets under q(x) q(e), minus KL(q(e) || N(0, I))."""
    return sum(expected_log_likelihood(q, regression) for regression in regressions) - divergence(q)


# --- The model -----------------------------------------------------------------------------------------------------------


class Problem(NamedTuple):
    """The observations, and the lengths of their sequences."""

    observations: list[Array]  # one [N x D] for every part, columns centred
    lengths: list[int]  # frames of every sequence; they add up to N
    order: int  # how many earlier frames the dynamics see
    jitter: float  # added to the diagonal of every covariance of inducing outputs, times its signal variance


def predicted_rows(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    """The frames that the dynamics predict [R], and those that each is predicted from, oldest first [R x order]."""
    rows, first = [], 0
    for length in problem.lengths:
        rows.extend(range(first + problem.order, first + length))
        first += length
    predicted = np.array(rows, dtype=int)
    return predicted, predicted[:, None] + np.arange(-problem.order, 0)


def initial_rows(problem: Problem) -> np.ndarray:
    """The frames that no dynamics predict: the first of every sequence."""
    predicted, _ = predicted_rows(problem)
    return np.setdiff1d(np.arange(sum(problem.lengths)), predicted)


def pose_process(part: Params) -> Process:
    return Process(part["r"], part["kin_lambda"], part["kin_var"])


def expert_process(expert: Params) -> Process:
    return Process(expert["z"], expert["lambda"], expert["var"])


def product_of_experts(alpha: Array, target: int) -> tuple[Array, Array]:
    """The weights w[source] of the experts about a part and the variance of their product, P2 (1) and (A26)."""
    precision = 1 / alpha[:, target]
    return precision / jnp.sum(precision), 1 / jnp.sum(precision)


def pose_regression(params: Params, problem: Problem, i: int) -> Regression:
    """g of part i: from its latents to its observations."""
    part, y = params["parts"][i], problem.observations[i]
    phi = features(pose_process(part), part["mu"], part["s"], problem.jitter)
    return Regression(phi, y, jnp.zeros_like(y), part["beta"])


def dynamics_regression(params: Params, problem: Problem, i: int) -> Regression:
    """All experts f[source][i] together: from the histories of all parts to the latents of part i."""
    predicted, history = predicted_rows(problem)

    def expert(j: int) -> Features:
        source = params["parts"][j]
        mean, variance = (source[name][history].reshape(len(history), -1) for name in ("mu", "s"))
        return features(expert_process(params["dyn"][j][i]), mean, variance, problem.jitter)

    weights, noise = product_of_experts(params["alpha"], i)
    phi = weighted_sum([expert(j) for j in range(len(params["parts"]))], weights)
    part = params["parts"][i]
    return Regression(phi, part["mu"][predicted], part["s"][predicted], noise)


def regressions(params: Params, problem: Problem) -> dict[str, list[Regression]]:
    parts = range(len(params["parts"]))
    return {
        "kinematics": [pose_regression(params, problem, i) for i in parts],
        "dynamics": [dynamics_regression(params, problem, i) for i in parts],
    }


def bound_and_terms(params: Params, problem: Problem) -> tuple[Array, dict[str, Any]]:
    """The bound and its terms, P2 (14)."""

    def term(regression: Regression) -> Array:
        # At the best q(e) the bound does not change with q(e) to first order, so the gradient may treat q(e) as constant.
        return regression_bound(jax.lax.stop_gradient(best_gaussian(regression)), regression)

    terms = {name: [term(regression) for regression in group] for name, group in regressions(params, problem).items()}
    terms = {**terms, **latent_terms(params, problem)}
    return sum(jax.tree.leaves(terms)), terms


def latent_terms(params: Params, problem: Problem) -> dict[str, Array]:
    """E[log N(x; 0, I)] of the first frames and the entropy of q(x), the last two integrals of P2 (16)."""
    start = initial_rows(problem)
    initial, entropy = jnp.array(0.0), jnp.array(0.0)
    for part in params["parts"]:
        mean, variance = part["mu"][start], part["s"][start]
        initial += jnp.sum(log_normal(mean, 0.0, jnp.ones_like(mean))) - 0.5 * jnp.sum(variance)
        entropy += 0.5 * jnp.sum(jnp.log(2 * jnp.pi * jnp.e * part["s"]))
    return {"initial": initial, "entropy": entropy}


# --- What follows from the bound -----------------------------------------------------------------------------------------


class Function(NamedTuple):
    """A pose map, or the experts about a part, as learned."""

    processes: list[Process]  # one for a pose map; one for each source for the experts
    roots: list[Array]  # of the covariances of their inducing outputs
    q: Gaussian  # of their whitened inducing outputs, stacked


def functions(params: Params, problem: Problem) -> dict[str, list[Function]]:
    """The pose map of every part and the experts about every part."""
    parts = range(len(params["parts"]))
    processes = {
        "kinematics": [[pose_process(part)] for part in params["parts"]],
        "dynamics": [[expert_process(params["dyn"][j][i]) for j in parts] for i in parts],
    }

    def learned(processes: list[Process], regression: Regression) -> Function:
        return Function(processes, [root(process, problem.jitter) for process in processes], best_gaussian(regression))

    return {
        name: [learned(*pair) for pair in zip(processes[name], group)]
        for name, group in regressions(params, problem).items()
    }


def posterior(function: Function) -> Gaussian:
    """The best q(v) or q(u), no longer whitened; of the experts about a part, stacked in the order of the sources."""
    lower = block_diag(*function.roots)
    return Gaussian(lower @ function.q.mean, lower @ function.q.covariance @ lower.T)


def coefficients(function: Function) -> list[Array]:
    """K^-1 E[u] of each of the stacked processes: the mean function is k(x) times these."""
    ends = np.cumsum([len(lower) for lower in function.roots])
    means = jnp.split(function.q.mean, ends[:-1])
    return [whitening(lower).T @ mean for lower, mean in zip(function.roots, means)]


def rollout(
    learned: dict[str, list[Function]], alpha: Array, start: list[Array], steps: int
) -> tuple[list[Array], list[Array]]:
    """Means of latents and poses, `steps` frames on from `start` (`order` rows a part), the start included.

    The functions stay as they were learned; `alpha` weighs the experts' predictions.
    """
    parts = range(len(start))
    dynamics, kinematics = learned["dynamics"], learned["kinematics"]
    weights = [product_of_experts(alpha, i)[0] for i in parts]
    expert_coefficients = [coefficients(function) for function in dynamics]

    def advance(history: list[Array], _: None) -> tuple[list[Array], list[Array]]:
        """All parts one frame on, together: each is predicted from what all were before."""
        inputs = [latents.reshape(1, -1) for latents in history]

        def mean(i: int) -> Array:
            predictions = [kernel(dynamics[i].processes[j], inputs[j]) @ expert_coefficients[i][j] for j in parts]
            return sum(weights[i][j] * predictions[j] for j in parts)

        frame = [mean(i) for i in parts]
        return [jnp.concatenate([past[1:], new]) for past, new in zip(history, frame)], [new[0] for new in frame]

    _, frames = jax.lax.scan(advance, start, length=steps)
    x = [jnp.concatenate(pair) for pair in zip(start, frames)]
    y = [kernel(kinematics[i].processes[0], x[i]) @ coefficients(kinematics[i])[0] for i in parts]
    return x, y
