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
    def second_file(self) -> str | None:
        """Path of the second model where it is a file, else None."""
        known = {NO_SECOND, NOISY_SECOND, *(METHOD_PREFIX + method for method in METHODS)}
        is_known = self.second in known or self.second.startswith(SECOND_SAMPLE)
        return None if is_known else self.second
