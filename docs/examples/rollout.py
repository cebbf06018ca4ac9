"""Rolls a vCGPDM or vGPDM out from its file alone (docs/model-format.md). It needs numpy.

python rollout.py MODEL.json FRAMES LATENTS.csv POSITIONS.csv [SEQUENCE]
"""
import json
import sys

import numpy as np

# For each up axis, the rotation vector that turns the axes of the file so that y is up.
UP = {"x": (0, 0, 0.5), "y": (0, 0, 0), "z": (-0.5, 0, 0), "-x": (0, 0, -0.5), "-y": (1, 0, 0), "-z": (0.5, 0, 0)}


def gp(z, squared_lengthscales, mean, jitter, variance=1.0):
    """The mean of a sparse GP: a function from [N x P] to [N x Q]."""
    z, lam = np.array(z), np.array(squared_lengthscales)
    kernel = lambda x: variance * np.exp(-0.5 * np.sum((x[:, None] - z) ** 2 / lam, axis=2))
    coefficients = np.linalg.solve(kernel(z) + jitter * variance * np.eye(len(z)), np.array(mean))
    return lambda x: kernel(x) @ coefficients


def latents(model, frames, sequence):
    """The latents of each part [frames x Q]: the start, then the product of experts; w[source][target]."""
    order, jitter, precision = model["order"], model["jitter"], 1 / np.array(model["alpha"])
    w = precision / precision.sum(axis=0)
    experts = [[gp(e["z"], e["lambda"], e["u_mean"], jitter) for e in target["experts"]] for target in model["dynamics"]]
    x = [list(np.array(start)[:order]) for start in model["sequences"][sequence]["start"]]
    while len(x[0]) < frames:
        history = [np.concatenate(path[-order:])[None] for path in x]  # the oldest frame first
        step = [sum(w[j, i] * f(history[j])[0] for j, f in enumerate(into)) for i, into in enumerate(experts)]
        x = [path + [new] for path, new in zip(x, step)]
    return [np.array(path[:frames]) for path in x]


def columns(model, x):
    """All columns [frames x D]: each part's GP adds to the means of the columns of its joints."""
    joint_of = [0] * 6 + [j for j in range(1, len(model["pose"]["positions"])) for _ in range(3)]
    y = np.tile(model["column_means"], (len(x[0]), 1))
    for part, path in zip(model["parts"], x):
        mine = [d for d, joint in enumerate(joint_of) if joint in part["joints"]]
        y[:, mine] += gp(part["r"], part["lambda"], part["v_mean"], model["jitter"], part["variance"])(path)
    return y


def rotation(vector):
    """Rodrigues' formula."""
    angle = np.linalg.norm(vector)
    a, b, c = np.array(vector) / (angle or 1.0)
    k = np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def positions(model, y):
    """Joints [frames x J x 3] in the clip's axes and units; the body starts above the origin and faces z (y up)."""
    pose, leg, yaw, place, out = model["pose"], model["pose"]["stage"]["height"] / 2, 0.0, np.zeros(3), []
    w, v = pose["upright"][0], np.array(pose["upright"][1:])
    upright = rotation(2 * np.arctan2(np.linalg.norm(v), w) * v / (np.linalg.norm(v) or 1.0))
    to_file = rotation(np.pi * np.array(UP[pose["stage"]["up"]])).T
    for t, (turn, forward, sideways, height, pitch, roll) in enumerate(y[:, :6]):
        if t > 0:  # along the previous heading; row 0 has no step
            place, yaw = place + rotation((0, yaw, 0)) @ (sideways, 0, forward), yaw + turn
        if "climbs_from" in pose:  # the column holds changes of the height
            place[1] = place[1] + height if t > 0 else pose["climbs_from"]
        else:
            place[1] = height
        turns = [to_file @ rotation((0, yaw, 0)) @ rotation((pitch, 0, 0)) @ rotation((0, 0, roll)) @ upright]
        places = [to_file @ place * leg]
        for j, joint in enumerate(pose["skeleton"]["joints"][1:], start=1):
            places.append(places[joint["parent"]] + turns[joint["parent"]] @ pose["positions"][j])
            turns.append(turns[joint["parent"]] @ rotation(y[t, 3 + 3 * j : 6 + 3 * j]))
        out.append(places)
    return np.array(out)


if __name__ == "__main__":
    model = json.load(open(sys.argv[1], encoding="utf-8"))
    x = latents(model, int(sys.argv[2]), int(sys.argv[5]) if len(sys.argv) > 5 else 0)
    np.savetxt(sys.argv[3], np.hstack(x), delimiter=",", fmt="%.17g")
    np.savetxt(sys.argv[4], positions(model, columns(model, x)).reshape(len(x[0]), -1), delimiter=",", fmt="%.17g")
