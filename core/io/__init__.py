"""Meshes in files: reading any common format with a report, writing, bundled models."""

from core.io.errors import LoadError, SaveError
from core.io.reading import SUPPORTED_READ, LoadedMesh, load_mesh, read_mesh
from core.io.samples import Sample, bundled_samples, load_sample, sample_path
from core.io.saving import SUPPORTED_WRITE, save_mesh

__all__ = [
    "SUPPORTED_READ",
    "SUPPORTED_WRITE",
    "LoadError",
    "LoadedMesh",
    "Sample",
    "SaveError",
    "bundled_samples",
    "load_mesh",
    "load_sample",
    "read_mesh",
    "sample_path",
    "save_mesh",
]
