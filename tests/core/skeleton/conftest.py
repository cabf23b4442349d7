"""Real models, each read once."""

from functools import cache

import pytest

from core.io import load_mesh

CLOSED = [
    "camel_2444.ply",
    "cow_2904.off",
    "double_torus_eight_766.off",
    "elephant_2775.off",
    "fandisk_6475.off",
    "fertility_4494.off",
    "frog_9555.obj",
    "heart_5634.obj",
    "horse_19851.off",
    "kitten_9447.obj",
    "octopus_7130.off",
    "rocker_arm_40177.obj",
    "skull_5154.obj",
    "spot_2930.obj",
    "awkward/blobby_shuffled_winding.off",
    "awkward/knot2_2comps.off",
]
"""Closed orientable models, genus 0 to 4."""

AWKWARD = [
    "cow_2903.obj",
    "spider_4670.ply",
    "teapot_3644.obj",
    "suzanne_507_quads.obj",
    "double_torus_820_open.obj",
    "thin_strip_8231_open.off",
    "awkward/bunny_res2_nonmanifold.ply",
    "awkward/conrod_soup.stl",
    "awkward/degenerate_faces.off",
    "awkward/elephant_with_holes.off",
    "awkward/many_small_holes.ply",
    "awkward/nonmanifold_hole.ply",
]
"""Open, pinched, non-manifold, collapsed or in many parts."""


@cache
def _read(path):
    return load_mesh(path)


@pytest.fixture(scope="session")
def model(shared_models):
    """Return a function that reads a real model by name."""
    return lambda name: _read(shared_models / name)


def pytest_generate_tests(metafunc):
    for name, models in (("closed", CLOSED), ("awkward", AWKWARD)):
        if name in metafunc.fixturenames:
            metafunc.parametrize(name, models)
