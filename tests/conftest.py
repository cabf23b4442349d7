"""Fixtures that all tests share."""

from pathlib import Path

import pytest

from core.mesh import TriangleMesh, primitives

SHARED_MODELS = Path(__file__).resolve().parents[2] / "shared" / "models"


@pytest.fixture(scope="session")
def shared_models() -> Path:
    """Folder of the real test models, which are not part of the repository."""
    if not SHARED_MODELS.is_dir():
        pytest.skip("the real test models (../shared/models) are not on this machine")
    return SHARED_MODELS


@pytest.fixture(scope="session")
def ball() -> TriangleMesh:
    """Unit sphere of 642 vertices."""
    return primitives.sphere(3)
