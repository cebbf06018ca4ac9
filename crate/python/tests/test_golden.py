"""Rollouts of the golden cases, whose numbers are those of an independent implementation."""

import json

import numpy as np
import pytest
from conftest import ROOT
from vcgpdm import Vcgpdm


def model_of(golden):
    """A model with the numbers of a case: a small model of arrays of this shape, and its file rewritten."""
    given, posterior = golden["input"], golden["expected"]["posterior"]
    parts, experts = given["params"]["parts"], given["params"]["dyn"]
    widths = [np.shape(y)[1] for y in given["y"]]
    ends = np.cumsum([0, *widths])
    split = {f"part {i}": list(range(ends[i], ends[i + 1])) for i in range(len(widths))}
    noise = np.random.default_rng(1).standard_normal((60, sum(widths)))
    points = len(experts[0][0]["z"])
    sizes = {"pose_ips": len(parts[0]["r"]), "dynamics_ips": points, "order": given["order"]}
    shape = Vcgpdm.fit(noise, split, **sizes, latent=1, max_iterations=0)
    document = json.loads(shape.to_json())
    document["jitter"] = 0
    document["column_means"] = [0.0] * sum(widths)
    for column in document["columns"]:
        column["unit"] = 1.0
    for stored, part, v in zip(document["parts"], parts, posterior["kin"], strict=True):
        stored |= {"lambda": part["kin_lambda"], "variance": part["kin_var"], "r": part["r"]}
        stored |= {"beta": part["beta"], "v_mean": v["mean"], "v_covariance": v["cov"]}
    for target, u in enumerate(posterior["dyn"]):
        stored = document["dynamics"][target]
        stored["u_covariance"] = u["cov"]
        # For experts that are inferred again, which these rollouts do not need.
        stored["sum_psi1_mu"] = np.zeros(np.shape(u["mean"])).tolist()
        for source, expert in enumerate(stored["experts"]):
            own = experts[source][target]
            mean = u["mean"][source * points : (source + 1) * points]
            expert |= {"lambda": own["lambda"], "z": own["z"], "u_mean": mean}
    document["alpha"] = given["params"]["alpha"]
    start = golden["expected"]["rollouts"][0]["x0"]
    document["sequences"] = [{**document["sequences"][0], "start": start}]
    return Vcgpdm.from_json(json.dumps(document))


@pytest.mark.parametrize("case", range(4))
def test_rollouts_of_a_golden_case(case):
    golden = json.loads((ROOT / f"tests/golden/case-{case}.json").read_text())
    model = model_of(golden)
    rollouts = golden["expected"]["rollouts"]
    for expected in rollouts:
        # All of them have the same start.
        assert expected["x0"] == rollouts[0]["x0"]
        rollout = model.rollout(len(expected["x"][0]), alpha=expected["alpha"])
        for part, path in zip(rollout.latents.values(), expected["x"], strict=True):
            np.testing.assert_allclose(part, path, rtol=1e-6, atol=1e-8)
        np.testing.assert_allclose(rollout.y, np.hstack(expected["y"]), rtol=1e-6, atol=1e-8)
    model.alpha = rollouts[-1]["alpha"]
    assert np.array_equal(model.rollout(len(rollout)).y, rollout.y)
