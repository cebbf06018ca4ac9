"""A figure that walks in a notebook: Jupyter, Colab, marimo, VS Code. It needs the package anywidget."""

from pathlib import Path

import anywidget
import numpy as np
import traitlets

from vcgpdm import Vcgpdm

_SCRIPT = Path(__file__).with_name("widget.js")
if not _SCRIPT.exists():
    raise ImportError(
        f"expected the script of the widget at {_SCRIPT}, found none: wheels have it; in a checkout, "
        "`node scripts/widget.mjs` builds it (it needs Node), then install the package again"
    )


class Figure(anywidget.AnyWidget):
    """The body of a model, walking, with a slider for each coupling.

    `Figure(model, seconds=10, samples=0, height=360)`: `seconds` is the length of the movement, which
    repeats; `samples` is the number of sampled movements that are drawn faintly; `height` is in pixels.

    `alpha` are the coupling variances [M x M] of the figure, at first those of the model. An array sets them,
    and so does a slider: `model.alpha = figure.alpha` gives them to the model. `playing` starts and stops the
    figure.
    """

    _esm = _SCRIPT
    document = traitlets.Unicode().tag(sync=True)
    alpha = traitlets.Any().tag(sync=True)
    playing = traitlets.Bool(True).tag(sync=True)
    seconds = traitlets.Float(10.0).tag(sync=True)
    samples = traitlets.Int(0).tag(sync=True)
    height = traitlets.Int(360).tag(sync=True)

    def __init__(self, model: Vcgpdm, **options):
        # A model of arrays has no body: this refuses it.
        model.rollout(1).positions()
        self._model = model
        alpha = options.pop("alpha", model.alpha)
        super().__init__(document=model.to_json(), alpha=alpha, **options)

    @traitlets.validate("alpha")
    def _check_alpha(self, proposal):
        alpha = np.asarray(proposal["value"], dtype=float)
        # The refusals are those of the library.
        self._model.rollout(1, alpha=alpha)
        return alpha.tolist()
