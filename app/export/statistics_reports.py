"""What the command line prints about the statistics of a model."""

import math
from dataclasses import asdict
from typing import Any

from app.export.statistics_plots import PLOTS
from app.export.statistics_series import Series
from app.export.statistics_words import plot_words
from core.statistics import GeodesicDistances, MeshStatistics, Spectrum, Summary


def statistics_json(name: str, statistics: MeshStatistics) -> dict[str, Any]:
    """Describe the statistics as one JSON object; lengths of `geodesic` are in units of ℓ̄."""
    return {
        "model": name,
        **asdict(statistics.summary),
        "degree": dict(statistics.degree),
        "assortativity": dict(statistics.assortativity),
        "assortativity_coefficient": _number(statistics.connectivity.assortativity_coefficient),
        "clustering": dict(statistics.clustering),
        "average_clustering": float(statistics.connectivity.clustering.mean()),
        "spectrum": statistics.spectrum and _spectrum_json(statistics.spectrum),
        "normalized_spectrum": (
            statistics.normalized_spectrum and _spectrum_json(statistics.normalized_spectrum)
        ),
        "geodesic": statistics.geodesic and _geodesic_json(statistics.geodesic),
        "refusals": dict(statistics.refusals),
    }


def statistics_text(name: str, statistics: MeshStatistics) -> str:
    """Describe the statistics for a terminal."""
    series = [Series.of_statistics(name, statistics)]
    words = [f"{spec.title}: {plot_words(spec.id, series)}" for spec in PLOTS.values()]
    facts = summary_rows(statistics.summary)
    width = max(len(label) for label, _ in facts)
    rows = [f"  {label:{width}}  {value}" for label, value in facts]
    return "\n".join([name, *rows, *words, *_normalized_refusal(statistics)])


def summary_rows(summary: Summary) -> list[tuple[str, str]]:
    """Return the summary as labels and values that a person reads."""
    s = summary
    return [
        ("vertices", f"{s.vertices:,}"),
        ("edges", f"{s.edges:,}"),
        ("faces", f"{s.faces:,}"),
        ("average degree", f"{s.average_degree:.4f}"),
        ("components", f"{s.components:,}"),
        ("boundary loops", f"{s.boundary_loops:,}"),
        ("Euler characteristic", f"{s.euler_characteristic:,}".replace("-", "−")),
        ("genus", "–" if s.genus is None else f"{s.genus:,}"),
        ("area", f"{s.area:.5g}"),
        ("volume", "–" if s.volume is None else f"{s.volume:.5g}"),
        ("mean edge length ℓ̄", f"{s.mean_edge_length:.4g}"),
        ("its deviation", f"{s.edge_length_deviation:.3g}"),
        ("shortest edge", f"{s.shortest_edge:.3g}"),
        ("longest edge", f"{s.longest_edge:.3g}"),
        ("smallest angle", f"{s.smallest_angle:.3g}°"),
        ("largest angle", f"{s.largest_angle:.4g}°"),
        ("degenerate faces", f"{s.degenerate_faces:,}"),
        ("non-manifold edges", f"{s.nonmanifold_edges:,}"),
        ("non-manifold vertices", f"{s.nonmanifold_vertices:,}"),
    ]


def _normalized_refusal(statistics: MeshStatistics) -> list[str]:
    """Name what has no plot of its own."""
    refused = statistics.refusals.get("normalized_spectrum")
    return [f"Spectrum of the normalised Laplacian: {refused}"] if refused else []


def _spectrum_json(spectrum: Spectrum) -> dict[str, Any]:
    return {
        "exact": spectrum.exact,
        "error": spectrum.error,
        "normalised_rank": spectrum.ranks.tolist(),
        "eigenvalues": spectrum.eigenvalues.tolist(),
        "low": spectrum.low.tolist(),
        "high": spectrum.high.tolist(),
        "smallest": spectrum.smallest.tolist(),
        "largest": spectrum.largest.tolist(),
        "algebraic_connectivity": spectrum.algebraic_connectivity,
        "zero_eigenvalues": spectrum.zero_count,
    }


def _geodesic_json(distances: GeodesicDistances) -> dict[str, Any]:
    return {
        **distances.params.model_dump(),
        "sources": distances.sources,
        "pairs": distances.pairs,
        "unreachable_pairs": distances.unreachable_pairs,
        "mean": distances.mean,
        "longest": distances.longest,
        "modes": distances.modes.tolist(),
        "edges": distances.histogram.edges.tolist(),
        "counts": distances.histogram.counts.tolist(),
    }


def _number(value: float) -> float | None:
    """JSON knows no number that is not one."""
    return None if math.isnan(value) else value
