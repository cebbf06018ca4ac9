# A marimo notebook with the figure of vcgpdm.widget: tests/clients/python.test.mjs opens it in a browser.
import marimo

app = marimo.App()


@app.cell
def _():
    import marimo as mo
    from vcgpdm import Clip, Vcgpdm
    from vcgpdm.widget import Figure

    model = Vcgpdm.fit(Clip.sample("walk-1"), "lower,upper", max_iterations=10)
    figure = mo.ui.anywidget(Figure(model, height=240))
    figure
    return figure, mo


@app.cell
def _(figure, mo):
    mo.md(f"alpha from lower to upper: {figure.value['alpha'][0][1]:.6g}")
    return


if __name__ == "__main__":
    app.run()
