"""Fixtures that all tests share."""

from pathlib import Path

import pytest

from core.mesh import TriangleMesh, primitives

TESTS = Path(__file__).resolve().parent
SHARED_MODELS = TESTS.parents[1] / "shared" / "models"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Let the windows' tests come first: they are the slowest, and processes shall end together."""
    items.sort(key=lambda item: not item.path.is_relative_to(TESTS / "gui"))


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
