"""Clips, trainings, models and rollouts."""

import copy
import json
import os
import pickle
import re
import signal
import threading
import time

import numpy as np
import pytest
from conftest import ROOT
from vcgpdm import Clip, Vcgpdm


def waves(frames=60, trials=2):
    """Trials of three columns: a circle, and a wave that follows it."""
    phases = [np.arange(frames) / 6 + start for start in range(trials)]
    return [np.column_stack([np.sin(phase), np.cos(phase), np.sin(phase - 1)]) for phase in phases]


def test_a_clip_has_positions_and_values(walk, tmp_path):
    assert "walk-1" in Clip.samples()
    positions = walk.positions()
    assert positions.dtype == np.float32
    assert positions.shape == (walk.frames, len(walk.parents), 3)
    assert walk.parents[0] == -1
    assert positions[..., 1].min() == pytest.approx(0, abs=1e-6)
    assert walk.values.shape[0] == len(walk) == walk.frames
    assert set(walk.presets["lower-upper"]) == {"lower", "upper"}
    path = tmp_path / "walk.bvh"
    walk.write(path)
    again = Clip.read(path)
    assert again.name == "walk.bvh"
    assert again.joints == walk.joints
    np.testing.assert_allclose(again.positions(), positions, atol=1e-4)
    slow = walk.resample(30).cut(10, 40)
    assert slow.frames == 30
    assert slow.frame_time == pytest.approx(1 / 30)


def test_a_rollout_has_columns_latents_positions_and_a_clip(model):
    assert model.parts == ["lower", "upper"]
    rollout = model.rollout(50)
    assert rollout.y.shape == (50, len(model.columns))
    assert {name: x.shape for name, x in rollout.latents.items()} == {"lower": (50, 3), "upper": (50, 3)}
    np.testing.assert_allclose(rollout.weights.sum(axis=0), 1)
    assert np.array_equal(rollout.weights, model.weights)
    assert rollout.positions().shape[0] == rollout.clip().frames == len(rollout) == 50
    assert rollout.health()["state"] in {"moves-on", "stands-still", "keeps-one-pose", "visits-few-poses"}
    start = model.latents[0]["lower"]
    assert start.shape[0] > 100
    np.testing.assert_allclose(rollout.latents["lower"][:2], start[:2], atol=1e-12)
    later = model.rollout(50, frame=20)
    np.testing.assert_allclose(later.latents["lower"][:2], start[20:22], atol=1e-12)


def test_long_clips_have_more_inducing_points_unless_told_otherwise(walk, tmp_path):
    path = tmp_path / "slow.bvh"
    walk.write(path)
    text = re.sub("Frame Time: .*", f"Frame Time: {8.1 / walk.frames}", path.read_text())
    path.write_text(text)
    slow = Clip.read(path)

    def points(clip, **sizes):
        model = Vcgpdm.fit(clip, fps=15, max_iterations=1, **sizes)
        settings = json.loads(model.to_json())["provenance"]["settings"]
        return settings["dynamics_ips"], settings["pose_ips"]

    assert points(walk) == (12, 12)
    assert points(slow) == (30, 30)
    assert points(slow, pose_ips=9) == (30, 9)


def test_the_usual_settings_give_the_bound_that_every_program_gives():
    golden = json.loads((ROOT / "tests/golden/defaults.json").read_text())
    clips = [Clip.sample(name) for name in golden["clips"]]
    model = Vcgpdm.fit(clips, max_iterations=golden["max_iterations"])
    assert model.bound == pytest.approx(golden["bound"], rel=1e-9)


def test_a_model_that_would_stop_learns_from_its_rollouts_unless_told_otherwise(walk):
    settings = {"parts": "lower,upper", "max_iterations": 40, "pose_weight": 1}
    plain = Vcgpdm.fit(walk, **{**settings, "as_in_papers": True, "pose_weight": None})
    assert plain.to_json() == Vcgpdm.fit(walk, own_rollouts=False, **settings).to_json()
    model = Vcgpdm.fit(walk, **settings)
    assert "rollout_rounds" not in plain.to_json() and "rollout_rounds" in model.to_json()
    assert model.bound == plain.bound


def test_alpha_changes_rollouts_and_not_what_was_learned(model):
    learned = model.rollout(60)
    model = copy.deepcopy(model)
    model.alpha[0, 1] *= 100
    changed = model.rollout(60)
    assert not np.allclose(changed.y, learned.y)
    assert np.array_equal(model.rollout(60, alpha=model.learned_alpha).y, learned.y)
    again = pickle.loads(pickle.dumps(model))
    assert np.array_equal(again.alpha, model.alpha)
    assert np.array_equal(again.rollout(60).y, changed.y)
    model.alpha = model.learned_alpha
    assert np.array_equal(model.rollout(60).y, learned.y)
    for wrong in ([[1, -1], [1, 1]], [[1.0]], [1, 2, 3, 4]):
        with pytest.raises(ValueError, match="expected"):
            model.alpha = wrong
    model.alpha[1, 0] = 0
    with pytest.raises(ValueError, match="expected a positive coupling variance from part 1 to part 0"):
        model.rollout(60)


def test_a_model_is_saved_and_loaded(model, tmp_path):
    path = tmp_path / "model.json"
    model.save(path)
    loaded = Vcgpdm.load(str(path))
    assert loaded.bound == model.bound
    assert loaded.to_json() == model.to_json()
    assert np.array_equal(loaded.rollout(40).y, model.rollout(40).y)
    path.write_text("{}")
    with pytest.raises(ValueError, match="model.json: .*expected"):
        Vcgpdm.load(path)
    with pytest.raises(FileNotFoundError):
        Vcgpdm.load(tmp_path / "none.json")


def test_arrays_are_trained_with_parts_by_place_or_name():
    trials = waves()
    parts = {"machine": [0], "follower": np.array([1, 2])}
    model = Vcgpdm.fit(trials, parts, latent=1, max_iterations=30, fps=50)
    assert model.frame_time == 1 / 50
    assert model.columns == ["y0", "y1", "y2"]
    assert [trial["machine"].shape for trial in model.latents] == [(60, 1), (60, 1)]
    reconstruction = model.rollout(60).y
    assert np.sqrt(np.mean((reconstruction - trials[0]) ** 2)) < 0.2
    named = {"machine": ["x"], "follower": ["y", "z"]}
    same = Vcgpdm.fit(np.array(trials), named, columns=["x", "y", "z"], latent=1, max_iterations=30, fps=50)
    assert same.bound == model.bound
    one = Vcgpdm.fit(trials[0], max_iterations=2)
    assert one.parts == ["whole"]
    score = model.score(trials[1], sequence=1)
    assert 0 <= score["dtw_mse"] < score["variance"]
    with pytest.raises(ValueError, match="a model of a body"):
        model.rollout(10).positions()


def test_a_rollout_goes_on_from_observed_frames(model):
    trial = waves(trials=3)[2]
    own = Vcgpdm.fit(waves(), latent=2, max_iterations=60)
    goes_on = own.rollout(40, after=trial[:20])
    assert np.sqrt(np.mean((goes_on.y[:20] - trial[:20]) ** 2)) < 0.3
    assert np.sqrt(np.mean((goes_on.y[20:] - trial[20:40]) ** 2)) < np.std(trial)
    clip = Clip.sample("walk-2").cut(0, 20)
    assert len(model.rollout(60, after=clip)) == 60
    with pytest.raises(ValueError, match="expected an array of 3 columns, found 2"):
        own.rollout(40, after=trial[:20, :2])


def test_moments_and_samples_agree(model):
    mean, covariance = model.moments(12)["upper"]
    assert mean.shape == (12, 3)
    assert covariance.shape == (12, 3, 3)
    samples = np.array([sample.latents["upper"] for sample in model.rollout(12, samples=200, seed=1)])
    spread = np.sqrt(np.einsum("tqq->tq", covariance))
    # The standard error of a mean of 200 samples is a fourteenth of their spread.
    assert np.all(np.abs(samples.mean(axis=0) - mean)[2:] < 0.4 * spread[2:] + 1e-9)
    assert np.all(samples.std(axis=0)[2:] < 1.5 * spread[2:])


def test_the_same_seed_gives_the_same_model(walk, model):
    again = Vcgpdm.fit([walk], "upper,lower", max_iterations=15, seed=3, threads=2)
    assert again.parts == ["upper", "lower"]
    named = Vcgpdm.fit(walk, walk.presets["lower-upper"], max_iterations=15, seed=3, threads=2)
    assert named.to_json() == model.to_json()
    assert Vcgpdm.fit(walk, max_iterations=15, seed=4).bound != model.bound


def test_progress_is_reported_and_can_end_the_training(walk):
    seen = []

    def watch(progress):
        seen.append((progress.iteration, progress.best, progress.bound))
        assert progress.max_iterations == 250
        assert progress.objective <= progress.best
        if progress.iteration == 5:
            raise StopIteration

    model = Vcgpdm.fit(walk, "whole", progress=watch)
    assert [iteration for iteration, _, _ in seen] == [1, 2, 3, 4, 5]
    assert model.iterations == 5
    assert (model.objective, model.bound) == seen[-1][1:]

    def wrong(progress):
        raise RuntimeError("my mistake")

    with pytest.raises(RuntimeError, match="my mistake"):
        Vcgpdm.fit(walk, "whole", progress=wrong)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no os.kill for SIGINT")
def test_ctrl_c_raises_with_the_best_model_so_far(walk):
    begun = threading.Event()

    def press():
        begun.wait()
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=press).start()
    with pytest.raises(KeyboardInterrupt) as interrupt:
        Vcgpdm.fit(walk, max_iterations=100_000, latent=6, progress=lambda _: begun.set())
    best = interrupt.value.model
    assert best.iterations > 0
    assert len(best.rollout(20)) == 20
    assert Vcgpdm.fit(walk, "whole", max_iterations=1).iterations == 1


def test_other_threads_run_while_a_model_is_trained(walk):
    counted = 0
    done = threading.Event()

    def train():
        Vcgpdm.fit(walk, max_iterations=30)
        done.set()

    thread = threading.Thread(target=train)
    thread.start()
    while not done.is_set():
        counted += 1
        time.sleep(0.001)
    thread.join()
    assert counted > 20


def test_warnings_are_user_warnings(walk):
    with pytest.warns(UserWarning, match="walk-1.* is given twice"):
        Vcgpdm.fit([walk, walk], "whole", max_iterations=1)


def test_refusals_have_the_words_of_the_library(walk, tmp_path):
    y = waves()[0]
    gap = y.copy()
    gap[4, 1] = np.nan
    for problem, call in {
        "expected a dict or a split of this body .*, found 'arms'": lambda: Vcgpdm.fit(walk, "arms"),
        "found no part for": lambda: Vcgpdm.fit(walk, {"hips": ["Hips"]}),
        r"part 1 \(\"hips\"\), joint 1: expected": lambda: Vcgpdm.fit(walk, {"hips": ["Hip"]}),
        "expected each column in one part, found no part for y2": lambda: Vcgpdm.fit(y, {"a": [0, 1]}),
        "part \"a\": expected a column from 0 to 2 or its name, found 3": lambda: Vcgpdm.fit(y, {"a": [3]}),
        r"trial 1: row 4, column 1 \(y1\): expected a number": lambda: Vcgpdm.fit([y, gap]),
        "trial 0: expected an array of two dimensions, found 1": lambda: Vcgpdm.fit(y[:, 0]),
        "trial 1: expected an array as the others, found a clip": lambda: Vcgpdm.fit([y, walk]),
        "expected at least one": lambda: Vcgpdm.fit([]),
        "expected one name for each column": lambda: Vcgpdm.fit(y, columns=["a"]),
        "fps: expected": lambda: Vcgpdm.fit(y, fps=0),
        "latent": lambda: Vcgpdm.fit(y, latent=0),
        "expected a number of 0 or more, found -1": lambda: Vcgpdm.fit(y, latent=-1),
        "seed: expected a number up to": lambda: Vcgpdm.fit(y, seed=2**32),
        "pose_weight: expected": lambda: Vcgpdm.fit(y, pose_weight="even"),
        "expected one of the samples": lambda: Clip.sample("run"),
        "expected x, y, z": lambda: walk.with_up("up"),
        "expected frames from 0 to": lambda: walk.cut(5, 5),
    }.items():
        with pytest.raises(ValueError, match=problem.replace("'", '"')):
            call()
    other = tmp_path / "other.bvh"
    other.write_text("a,b\n1,2\n")
    with pytest.raises(ValueError, match="other.bvh"):
        Clip.read(other)
    for wrong in (lambda: Vcgpdm.fit(3), lambda: Vcgpdm.fit(y, 3), lambda: Vcgpdm.fit(y, {"a": "y0"})):
        with pytest.raises(TypeError, match="expected"):
            wrong()


def test_models_of_other_kinds_are_refused():
    with pytest.raises(ValueError, match="expected a vcgpdm or vgpdm model, found a tmp model"):
        Vcgpdm.load(ROOT / "crate/vcgpdm/tests/library/documents/tmp.json")
