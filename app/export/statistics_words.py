"""What each plot of the statistics shows and how to read it, in one line of plain words."""

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from app.export.statistics_series import Series
from core.arrays import FloatArray

_NEUTRAL = 0.03


def plot_words(plot: str, series: Sequence[Series]) -> str:
    """Say what a plot shows; the numbers of two models stand side by side."""
    refused = [f"{one.name}: {one.refusals[plot]}" for one in series if plot in one.refusals]
    return " ".join([_WORDS[plot](series), *refused]) if series else ""


def vertex_words(series: Series, vertex: int, distances: FloatArray | None) -> str:
    """Say what is known of one vertex of a model.

    `distances` are those from the picked vertex, in ℓ̄.
    """
    known = series.connectivity
    parts = [f"vertex {vertex:,}", f"degree {known.degrees[vertex]}"]
    for name, values in (
        ("K_nn", known.neighbour_degrees), ("clustering", known.clustering),
    ):  # fmt: skip
        if np.isfinite(values[vertex]):
            parts.append(f"{name} {values[vertex]:.4g}")
    if distances is not None:
        far = distances[vertex]
        parts.append(f"distance {far:.4g} ℓ̄" if np.isfinite(far) else "not connected")
    return f"{series.name}: {', '.join(parts)}"


def _spectrum(series: Sequence[Series]) -> str:
    known = [one.spectrum for one in series if one.spectrum]
    if not known:
        return "Eigenvalues of the Laplacian, largest first."
    connectivity = _beside(f"{one.algebraic_connectivity:.2g}" for one in known)
    zeros = _beside(f"{one.zero_count:,}" for one in known)
    return (
        f"Eigenvalues, largest first: high means tightly knit. λ₂ = {connectivity}, "
        f"zeros (one a piece): {zeros}."
        f"{_accuracy(series)}"
    )


def _accuracy(series: Sequence[Series]) -> str:
    rough = [one.spectrum for one in series if one.spectrum and not one.spectrum.exact]
    return f" Approximate, within ±{max(one.error for one in rough):.2g} (shaded)." if rough else ""


def _degree(series: Sequence[Series]) -> str:
    mean = _beside(f"{one.connectivity.degrees.mean():.4g}" for one in series)
    tallest = [max(one.degree, key=one.degree.__getitem__) for one in series]
    most = _beside(
        f"{100 * one.degree[k]:.0f} % have {k}" for one, k in zip(series, tallest, strict=True)
    )
    return (
        f"Share of the vertices with k neighbours: {most}; on average {mean}. "
        "A regular mesh has a single bar at 6."
    )


def _assortativity(series: Sequence[Series]) -> str:
    found = [one.connectivity.assortativity_coefficient for one in series]
    verdicts = list(dict.fromkeys(map(_mixing, found)))
    numbers = _beside("–" if np.isnan(r) else f"{r:.2f}".replace("-", "−") for r in found)
    return (
        f"Average degree of the neighbours of a vertex with k of them. {_beside(verdicts)} "
        f"(r = {numbers}). Dashed: if neighbours' degrees were unrelated."
    )


def _mixing(coefficient: float) -> str:
    if np.isnan(coefficient):
        return "All degrees are equal"
    if abs(coefficient) < _NEUTRAL:
        return "Neither rises nor falls"
    return "Rises: assortative" if coefficient > 0 else "Falls: disassortative"


def _clustering(series: Sequence[Series]) -> str:
    mean = _beside(f"{one.connectivity.clustering.mean():.3g}" for one in series)
    return (
        f"Share of a vertex's neighbours that are joined to each other: 1 is all, {mean} on "
        "average. Dashed: 2/(k − 1), as inside a closed surface."
    )


def _geodesic(series: Sequence[Series]) -> str:
    known = [one.geodesic for one in series if one.geodesic]
    if not known:
        return "How far the vertices are from each other along the surface."
    peaks = _beside(_peaks(one.modes) for one in known)
    lost = _beside(f"{one.unreachable_pairs:,} of {one.pairs:,}" for one in known)
    # What is missing matters more than how to read the rest; both do not fit under the plot.
    if any(one.unreachable_pairs for one in known):
        return f"How far vertices are from each other: {peaks}. No path: {lost} pairs."
    return (
        f"How far vertices are from each other: {peaks}. "
        "Limbs and humps give further peaks or shoulders."
    )


def _peaks(modes: FloatArray) -> str:
    if not len(modes):
        return "no peak"
    places = ", ".join(f"{mode:.3g}" for mode in modes)
    return f"{'peaks' if len(modes) > 1 else 'one peak'} at {places} ℓ̄"


def _beside(words: Iterable[str]) -> str:
    return " | ".join(words)


_WORDS: dict[str, Callable[[Sequence[Series]], str]] = {
    "spectrum": _spectrum,
    "degree": _degree,
    "assortativity": _assortativity,
    "clustering": _clustering,
    "geodesic": _geodesic,
}
