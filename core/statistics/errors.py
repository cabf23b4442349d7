"""What the statistics cannot be computed for."""


class StatisticsError(ValueError):
    """Raised when a statistic does not exist for a mesh; one sentence says why."""
