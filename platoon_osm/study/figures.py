"""The paper's four figures, as PNG and SVG."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

from ..atomic_file import whole_file
from ..report.language.speech import number, say
from .comparison import placing
from .example import Example
from .measures import Measures
from .monte_carlo import StudyResult
from .wording import figure as figure_of
from .wording import percent

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["cost_figure", "involvement_figure", "network_figure", "save_figure"]

# Okabe and Ito's colours, told apart with any kind of colour vision.
BLUE, RED, BLACK = "#0072B2", "#D55E00", "#000000"
MEMBERS = ("#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7A5195", "#8C6D1F", "#004D40", "#999999")
STYLES = ("-", (0, (5, 1.5)))
SURFACE_MAP = "cividis"
MIXING = {"printed": "study-figures.printed", "gain": "study-figures.gain"}

WIDTH_IN = 7.2
"""Both columns of a two-column page."""

STYLE: Mapping[str, Any] = {
    "font.family": "DejaVu Sans", "font.size": 8, "axes.titlesize": 8, "axes.labelsize": 8,
    "xtick.labelsize": 7, "ytick.labelsize": 7, "legend.fontsize": 7, "axes.linewidth": 0.6,
    "xtick.major.width": 0.6, "ytick.major.width": 0.6, "axes.titleweight": "normal",
    # Names of files and maps may hold dollar signs, and are no formulas.
    "text.parse_math": False,
    # The same figure is the same file.
    "svg.hashsalt": "platoon_osm",
}  # fmt: skip


@contextmanager
def _drawing() -> Iterator[None]:
    import matplotlib

    with matplotlib.rc_context(cast("Any", STYLE)):
        yield


def _new_figure(height_in: float, **options: Any) -> Figure:
    # Without pyplot: no window, no state that outlives the figure.
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure as NewFigure

    figure = NewFigure(figsize=(WIDTH_IN, height_in), **options)
    FigureCanvasAgg(figure)
    return figure


def save_figure(figure: Figure, stem: Path) -> tuple[Path, Path]:
    """Write a figure as `stem.png` (300 dpi) and `stem.svg`.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Drawn already.
    stem : Path
        The files' path without suffix.

    Returns
    -------
    png, svg : Path
        What was written.
    """
    png, svg = stem.with_suffix(".png"), stem.with_suffix(".svg")
    _speak(figure)
    with _drawing():
        with whole_file(png) as draft:
            figure.savefig(draft, dpi=300, metadata={"Software": None})
        with whole_file(svg) as draft:
            figure.savefig(draft, metadata={"Date": None, "Creator": "platoon_osm"})
    return png, svg


def _speak(figure: Figure) -> None:
    """Give the numbers of all axes the decimal sign of the language."""
    from matplotlib.ticker import ScalarFormatter

    sign = number(0, 1)[1]
    if sign == ".":
        return

    class Ticks(ScalarFormatter):
        def __call__(self, x: float, pos: int | None = None) -> str:
            return str(super().__call__(x, pos)).replace(".", sign)

    for panel in figure.axes:
        for axis in (panel.xaxis, panel.yaxis, getattr(panel, "zaxis", None)):
            if axis is not None and type(axis.get_major_formatter()) is ScalarFormatter:
                axis.set_major_formatter(Ticks())


def network_figure(examples: Sequence[tuple[str, Example]]) -> Figure:
    """Draw road graphs with the longest platoon in red, spawn points and member routes.

    Parameters
    ----------
    examples : sequence of (str, Example)
        A title and a run for each panel.

    Returns
    -------
    matplotlib.figure.Figure
        To be saved by `save_figure`.
    """
    with _drawing():
        figure = _new_figure(4.1 if len(examples) > 1 else 6.4, layout="constrained")
        panels = figure.subplots(1, len(examples), squeeze=False)[0]
        for panel, (label, example) in zip(panels, examples, strict=True):
            _network_panel(panel, example)
            km = 0.0
            if example.longest >= 0:
                together = example.routes[example.longest][1]
                km = float(example.draw.net.length_m[together].sum()) / 1000
            panel.set_title(
                say("study-figures.longest-km", label=label, km=figure_of(km, 0)) if km else label
            )
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=6, frameon=False)
    return figure


def _network_panel(panel: Axes, example: Example) -> None:
    from matplotlib.collections import LineCollection

    draw = example.draw
    net = draw.net
    xy = np.column_stack([draw.x_m, draw.y_m]) / 1000

    def lines(edges: NDArray[np.int64], **look: Any) -> None:
        ends = np.stack([xy[net.tail[edges]], xy[net.head[edges]]], axis=1)
        panel.add_collection(LineCollection(list(ends), capstyle="round", **look))

    roads = np.flatnonzero(~draw.access)
    dense = len(roads) > 5 * draw.net.n
    lines(
        roads,
        color="0.82" if dense else "0.6",
        linewidth=0.5,
        zorder=1,
        label=say("study-figures.road"),
    )
    junctions = np.unique(np.concatenate([net.tail[roads], net.head[roads]]))
    # On a real network junctions are many, and would hide the routes.
    few = len(junctions) < 300
    panel.scatter(
        xy[junctions, 0], xy[junctions, 1], s=7 if few else 0.8, color=BLUE, linewidth=0,
        zorder=5 if few else 1.5, label=say("study-figures.junction"),
    )  # fmt: skip
    others = [v for v in range(len(example.routes)) if v != example.master]
    lines(
        example.routes[example.master][0],
        color=BLACK,
        linewidth=3.2,
        zorder=2,
        label=say("study-figures.master"),
    )
    for k, vehicle in enumerate(others):
        whole = np.concatenate(example.routes[vehicle])
        lines(
            whole, color=MEMBERS[k % len(MEMBERS)], linewidth=1.1, zorder=4,
            linestyle=STYLES[k // len(MEMBERS) % len(STYLES)],
            label=say("study-figures.member-routes") if k == 0 else None,
        )  # fmt: skip
    if example.longest >= 0:
        together = example.routes[example.longest][1]
        lines(together, color=RED, linewidth=2.4, zorder=3)
        lines(together, color=RED, linewidth=1.6, zorder=6, label=say("study-figures.longest"))
    panel.scatter(
        xy[draw.origins, 0], xy[draw.origins, 1], s=22, facecolor="white", edgecolor=RED,
        linewidth=1.1, zorder=8, label=say("study-figures.spawn-point"),
    )  # fmt: skip
    if net.source.attribution:
        panel.text(
            0.995, 0.005, fill(net.source.attribution, 50), transform=panel.transAxes, fontsize=5,
            color="0.4", ha="right", va="bottom", zorder=9,
        )  # fmt: skip
    panel.set_aspect("equal")
    panel.autoscale_view()
    panel.set_xlabel("x [km]")
    panel.set_ylabel("y [km]")
    panel.spines[["top", "right"]].set_visible(False)


def cost_figure(result: StudyResult, method: int = 0) -> Figure:
    """Draw the cost surfaces alone and jointly, and the saving, for each mixing of a study.

    Parameters
    ----------
    result : StudyResult
        Of any study.
    method : int
        Position in the study's methods.

    Returns
    -------
    matplotlib.figure.Figure
        To be saved by `save_figure`.
    """
    study = result.study
    shape = study.grid_shape
    count = int(np.prod(shape))
    tau, xi = 100 * np.array(study.tau), 100 * np.array(study.xi)
    from matplotlib.patches import Patch

    with _drawing():
        figure = _new_figure(3.3 * len(study.mixings))
        surfaces = []
        for x in range(len(study.mixings)):
            alone, joint = Measures(result, method, x).cost_surfaces()
            surfaces.append([v[:count].reshape(shape) / 1000 for v in (alone, joint)])
        low = min(joint.min() for _, joint in surfaces)
        high = max(alone.max() for alone, _ in surfaces)
        for x, (mixing, (alone, joint)) in enumerate(zip(study.mixings, surfaces, strict=True)):
            rows = len(study.mixings)
            solid: Any = figure.add_subplot(rows, 2, 2 * x + 1, projection="3d")
            across, along = np.meshgrid(xi, tau)
            solid.plot_surface(
                along, across, alone, color="0.6", alpha=0.35, linewidth=0, shade=False
            )
            solid.plot_surface(
                along, across, joint, color=BLUE, edgecolor="white", linewidth=0.35,
                rstride=1, cstride=1, shade=False,
            )  # fmt: skip
            # Surfaces have no legend of their own in three dimensions.
            solid.legend(
                handles=[
                    Patch(color="0.8", label=say("study-figures.alone")),
                    Patch(color=BLUE, label=say("study-figures.joint")),
                ],
                loc="upper right", bbox_to_anchor=(1.08, 0.93), frameon=False,
            )  # fmt: skip
            solid.set_xlabel("τ [%]", labelpad=-4)
            solid.set_ylabel("ξ [%]", labelpad=-4)
            solid.set_zlabel(say("study-figures.axis-cost"), labelpad=2)
            solid.set_zlim(low * 0.98, high * 1.02)
            solid.tick_params(pad=-1)
            solid.view_init(elev=27, azim=-128)
            solid.set_box_aspect((1, 1, 0.85), zoom=0.9)
            solid.set_title(
                say("study-figures.surfaces", letter="ac"[x], mixing=say(MIXING[mixing])), y=1.0
            )
            flat = figure.add_subplot(rows, 2, 2 * x + 2)
            _heat(
                figure, flat, tau, xi, 100 * (1 - joint / alone), say("study-figures.axis-saving")
            )
            flat.set_title(say("study-figures.saving", letter="bd"[x], mixing=say(MIXING[mixing])))
            for one_tau, one_xi in study.points:
                flat.plot(100 * one_tau, 100 * one_xi, "o", mfc="none", mec=RED, mew=1.2,
                          clip_on=False, zorder=5)  # fmt: skip
        figure.subplots_adjust(
            left=0.02, right=0.93, top=0.94, bottom=0.07, hspace=0.28, wspace=0.22
        )
    return figure


def involvement_figure(results: Sequence[StudyResult], method: str, mixing: int = 0) -> Figure:
    """Draw the share of members that join, and that truly merge and separate, for each reading.

    Parameters
    ----------
    results : sequence of StudyResult
        A column of panels for each.
    method : {"dijkstra", "astar", "astar-closed-once"}
        One that all of them ran.
    mixing : int
        Position in the studies' mixings.

    Returns
    -------
    matplotlib.figure.Figure
        To be saved by `save_figure`.
    """
    shown: tuple[tuple[str, Any], ...] = (
        (say("study-figures.joined"), "joined"),
        (say("study-figures.merge"), "merges and separates"),
    )
    with _drawing():
        figure = _new_figure(1.75 * len(shown) + 0.35, layout="constrained")
        # Few panels make a narrow figure, not wide panels.
        figure.set_figwidth(min(WIDTH_IN, 2.2 + 1.6 * len(results)))
        panels = figure.subplots(len(shown), len(results), squeeze=False, sharex=True, sharey=True)
        picture = None
        for column, result in enumerate(results):
            study = result.study
            found = Measures(result, [*study.methods].index(method), mixing)  # type: ignore[arg-type]
            tau, xi = 100 * np.array(study.tau), 100 * np.array(study.xi)
            for row, (label, name) in enumerate(shown):
                panel = panels[row, column]
                count = int(np.prod(study.grid_shape))
                share = 100 * found.involvement(name)[0][:count].reshape(study.grid_shape)
                picture = panel.pcolormesh(
                    tau, xi, share.T, cmap=SURFACE_MAP, vmin=0, vmax=100, shading="nearest",
                    rasterized=True,
                )  # fmt: skip
                if min(share.shape) > 1 and np.ptp(share) > 10:
                    panel.contour(
                        tau, xi, share.T, colors="white", linewidths=0.5,
                        levels=np.arange(10, 100, 10),
                    )  # fmt: skip
                panel.set_title(
                    say("study-figures.mean", share=percent(share.mean(), 0)), fontsize=7, pad=3
                )
                panel.set_xticks([0, 50, 100])
                panel.set_yticks([0, 50, 100])
                if column == 0:
                    panel.set_ylabel(f"{label}\n\nξ [%]")
                if row == len(shown) - 1:
                    panel.set_xlabel("τ [%]")
            panels[0, column].set_title(
                f"{placing(result, short=True)}\n{panels[0, column].get_title()}",
                fontsize=7,
                pad=3,
            )
        assert picture is not None
        figure.colorbar(
            picture, ax=panels, label=say("study-figures.axis-involved"), aspect=30, pad=0.01
        )
    return figure


def _heat(
    figure: Figure, panel: Axes, tau: NDArray[np.float64], xi: NDArray[np.float64],
    values: NDArray[np.float64], label: str,
) -> None:  # fmt: skip
    picture = panel.pcolormesh(
        tau, xi, values.T, cmap=SURFACE_MAP, shading="nearest", rasterized=True
    )
    if len(tau) > 1 and len(xi) > 1 and np.ptp(values) > 0:
        lines = panel.contour(tau, xi, values.T, colors="white", linewidths=0.7, levels=6)
        panel.clabel(lines, fmt=percent, fontsize=6.5)
    bar = figure.colorbar(picture, ax=panel, label=label, aspect=25, pad=0.03)
    bar.outline.set_linewidth(0.4)
    panel.set_xlabel("τ [%]")
    panel.set_ylabel("ξ [%]")
