"""The same numbers as the terminal program, to the last bit."""

import csv

import numpy as np
from vcgpdm import Clip, Vcgpdm


def columns(path):
    """The columns of a CSV file without frame and time."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return np.array([[float(number) for number in row[2:]] for row in rows[1:]])


def test_a_body_has_the_same_model_file_rollout_and_score(terminal, tmp_path, walk):
    there, here = tmp_path / "there.json", tmp_path / "here.json"
    options = ["--max-iterations", 15, "--seed", 3]
    summary = terminal("train", "sample:walk-1", "--parts", "lower,upper", *options, "--out", there)
    model = Vcgpdm.fit(walk, parts="lower,upper", max_iterations=15, seed=3)
    model.save(here)
    assert here.read_bytes() == there.read_bytes()
    assert model.bound == summary["elbo"]
    assert model.alpha.tolist() == summary["alpha"]

    y = tmp_path / "y.csv"
    changed = ["--alpha", "lower:upper=5", "--reading", "re-inferred"]
    terminal("rollout", there, "--frames", 80, *changed, "--columns", y, "--out", tmp_path / "there.bvh")
    alpha = model.alpha.copy()
    alpha[0, 1] = 5
    rollout = model.rollout(80, alpha=alpha, reading="re-inferred")
    assert np.array_equal(rollout.y, columns(y))
    rollout.clip("there.bvh").write(tmp_path / "here.bvh")
    assert (tmp_path / "here.bvh").read_bytes() == (tmp_path / "there.bvh").read_bytes()

    assert model.score(Clip.sample("walk-2")) == terminal("score", there, "sample:walk-2")


def test_samples_and_variances_are_the_same(terminal, tmp_path, model):
    file, y, variances = tmp_path / "model.json", tmp_path / "y.csv", tmp_path / "variances.csv"
    model.save(file)
    sampled = ["--samples", 2, "--seed", 7, "--variance", variances]
    terminal("rollout", file, "--frames", 20, "--columns", y, *sampled)
    first, second = model.rollout(20, samples=2, seed=7)
    assert np.array_equal(first.y, columns(tmp_path / "y-1.csv"))
    assert np.array_equal(second.y, columns(tmp_path / "y-2.csv"))
    mean, covariance = model.moments(20)["lower"]
    there = columns(variances)
    assert np.array_equal(mean, there[:, 0 : 2 * mean.shape[1] : 2])
    assert np.array_equal(covariance[:, 1, 1], there[:, 3])


def test_tables_have_the_same_model_as_arrays(terminal, tmp_path):
    phases = [np.arange(60) / 6 + start for start in (0, 1)]
    trials = [np.column_stack([np.sin(phase), np.cos(phase), np.sin(phase - 1)]) for phase in phases]
    for place, trial in enumerate(trials):
        rows = "\n".join(",".join(map(repr, row)) for row in trial.tolist())
        (tmp_path / f"{place}.csv").write_text(f"a,b,c\n{rows}\n")
    files = [tmp_path / "0.csv", tmp_path / "1.csv"]
    options = ["--parts", "x=a;y=b,c", "--fps", 50, "--max-iterations", 15, "--latent", 1]
    summary = terminal("train", "--columns", *files, *options, "--out", tmp_path / "model.json")
    parts = {"x": ["a"], "y": [1, 2]}
    model = Vcgpdm.fit(trials, parts, columns=["a", "b", "c"], fps=50, latent=1, max_iterations=15)
    assert model.bound == summary["elbo"]
    assert model.alpha.tolist() == summary["alpha"]
    loaded = Vcgpdm.load(tmp_path / "model.json")
    assert loaded.frame_time == model.frame_time == 1 / 50
    assert np.array_equal(model.rollout(90).y, loaded.rollout(90).y)
