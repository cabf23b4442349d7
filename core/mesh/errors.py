"""What is wrong with a mesh, in one sentence."""


class MeshError(ValueError):
    """Raised when arrays do not describe a triangle mesh, or one that cannot be worked on."""
