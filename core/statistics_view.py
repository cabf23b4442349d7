"""What the Statistics tab shows and how it measures. A part of a study, so undo covers it."""

from typing import Literal

from core.parameters import Params, build_params, param
from core.smoothing import METHODS
from core.statistics import GeodesicParams, SpectrumParams

NO_SECOND, NOISY_SECOND, METHOD_PREFIX, SECOND_SAMPLE = "none", "noisy", "method:", "sample:"


class StatisticsSettings(Params):
    """The Statistics tab: the second model, what colours both, and how distances are measured."""

    second: str = param(
        NO_SECOND, help="Model laid over the first: none, noisy, method:ID, sample:ID or a path."
    )
    colour: Literal["none", "degree", "assortativity", "clustering", "distance"] = param(
        "none", help="Quantity of the vertices that colours the models."
    )
    matrix: Literal["laplacian", "normalized_laplacian"] = param(
        "laplacian", help="Matrix whose eigenvalues are plotted."
    )
    relative: bool = param(False, help="Distances as shares of the longest, instead of in ℓ̄.")
    geodesic: dict[str, float | int | bool | str | None] = param(
        {}, help="Parameters of the geodesic distances that differ from their declared defaults."
    )

    @property
    def geodesic_params(self) -> GeodesicParams:
        """The validated parameters of the geodesic distances."""
        params: GeodesicParams = build_params(GeodesicParams, self.geodesic, "geodesic")
        return params

    @property
    def spectrum_params(self) -> SpectrumParams:
        """Which spectrum is shown."""
        return SpectrumParams(matrix=self.matrix)

    @property
    def portable(self) -> "StatisticsSettings":
        """The settings for a file: without a second model that is a file of this computer.

        Only models whose content a study knows are opened with it, and it knows none of this one.
        """
        known = {NO_SECOND, NOISY_SECOND, *(METHOD_PREFIX + method for method in METHODS)}
        if self.second in known or self.second.startswith(SECOND_SAMPLE):
            return self
        return self.model_copy(update={"second": NO_SECOND})
