"""Mesh tools: the model replaced by a finer or coarser one, as an undoable step."""

from collections.abc import Callable, Iterator
from functools import partial
from hashlib import sha256
from pathlib import Path

from platformdirs import user_cache_path

from app.session import Job, Session
from core.io import save_mesh
from core.mesh import TriangleMesh
from core.mesh.remesh import barycentric_subdivision, decimation_steps, midpoint_subdivision
from core.stepwise import Stepwise, at_once

TOOLS: dict[str, tuple[str, Callable[[TriangleMesh], Stepwise[TriangleMesh]]]] = {
    "midpoint": ("Midpoint subdivision (× 4)", at_once(midpoint_subdivision)),
    "barycentric": ("Barycentric subdivision (× 6)", at_once(barycentric_subdivision)),
    "half": ("Decimation to a half", partial(decimation_steps, share=0.5)),
    "quarter": ("Decimation to a quarter", partial(decimation_steps, share=0.25)),
}
"""Title of each tool, and what makes the mesh, by id."""


def remesh(session: Session, tool: str) -> None:
    """Replace the session's model by what a tool makes of it.

    The new model is written to the user's cache folder and opened from there, so that undo, redo
    and a saved study treat it as any other model.
    """
    title, make = TOOLS[tool]
    if session.meshes is None:
        return
    mesh, name = session.meshes.comparison.original, Path(session.meshes.name).stem

    def steps() -> Iterator[Path | None]:
        other = yield from make(mesh)
        # Undo goes back to the file, so no other model of that name may take its place.
        digest = sha256(mesh.vertices.tobytes() + mesh.faces.tobytes()).hexdigest()[:16]
        folder = user_cache_path("burnish") / "remeshed" / digest
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / f"{name}_{tool}.ply"
        save_mesh(other, path)
        yield path

    def made(path: Path) -> None:
        update = {"model": str(path), "noisy": None, "repairs": ()}
        session.apply(session.study.model_copy(update=update), title)

    session.jobs.start(Job(steps(), made, session.report, title=title), urgent=True)
