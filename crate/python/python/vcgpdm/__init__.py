"""Coupled Gaussian process movement primitives: the vCGPDM of Velychko, Knopp and Endres (2017-2020).

`Vcgpdm.fit` trains a model on clips of a body or on numpy arrays, and `Vcgpdm.rollout` makes new movements.
Shapes are in brackets: M parts, Q latent dimensions, D columns. Frames, parts and trials count from 0.
"""

from vcgpdm._vcgpdm import Clip, Progress, Rollout, Vcgpdm, __version__

__all__ = ["Clip", "Progress", "Rollout", "Vcgpdm", "__version__"]
