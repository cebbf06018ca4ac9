"""Compares docs/examples/rollout.py with the program: compare.py LATENTS.csv POSITIONS.csv THEIRS.csv THEIRS.bvh HEIGHT.

Prints how far the latents are apart, and how far the joints are, as a share of the body's height. The BVH is read here once more,
by nobody's code but numpy's.
"""

import sys

import numpy as np


def about(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    turn = np.eye(3)
    i, j = [k for k in range(3) if k != axis]
    sign = -1 if axis == 1 else 1
    turn[i, i], turn[j, j], turn[i, j], turn[j, i] = c, c, -s * sign, s * sign
    return turn


def joints_of(path):
    """Positions of all joints [frames x J x 3] of a BVH file whose joints have three rotation channels each."""
    words = open(path, encoding="utf-8").read().split()
    joints, stack, k, last = [], [], 0, None
    while words[k] != "MOTION":
        if words[k] in ("ROOT", "JOINT"):
            last = {"parent": stack[-1] if stack else None, "offset": None, "channels": []}
            joints.append(last)
        elif words[k] == "End":
            last = {"offset": None}
        elif words[k] == "OFFSET":
            last["offset"] = np.array(words[k + 1 : k + 4], dtype=float)
        elif words[k] == "CHANNELS":
            last["channels"] = words[k + 2 : k + 2 + int(words[k + 1])]
        elif words[k] == "{":
            stack.append(len(joints) - 1)
        elif words[k] == "}":
            stack.pop()
        k += 1
    frames = int(words[words.index("Frames:") + 1])
    values = np.array(words[words.index("Time:") + 2 :], dtype=float).reshape(frames, -1)
    out = np.zeros((frames, len(joints), 3))
    for t in range(frames):
        turns, c = [], 0
        for j, joint in enumerate(joints):
            turn, place = np.eye(3), joint["offset"].copy()
            for channel in joint["channels"]:
                axis = "XYZ".index(channel[0])
                if channel.endswith("rotation"):
                    turn = turn @ about(axis, values[t, c])
                else:
                    place[axis] = values[t, c]
                c += 1
            if joint["parent"] is None:
                out[t, j] = place
                turns.append(turn)
            else:
                out[t, j] = out[t, joint["parent"]] + turns[joint["parent"]] @ place
                turns.append(turns[joint["parent"]] @ turn)
    return out


if __name__ == "__main__":
    ours, places, theirs, motion, height = sys.argv[1:]
    latents = np.abs(np.loadtxt(ours, delimiter=",") - np.loadtxt(theirs, delimiter=",", skiprows=1)[:, 2:]).max()
    joints = joints_of(motion)
    apart = np.abs(np.loadtxt(places, delimiter=",").reshape(joints.shape) - joints).max()
    print(latents, apart / float(height))
