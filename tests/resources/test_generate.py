import numpy as np
import pytest

from core.io import load_mesh
from core.mesh import primitives
from resources.models import generate
from resources.models.surface import Mesh


def sphere(inside_out: bool = False) -> Mesh:
    ball = primitives.sphere(1)
    faces = ball.faces.astype(np.int64)
    return Mesh(ball.vertices, faces[:, ::-1] if inside_out else faces)


def test_written_file_is_read_back(tmp_path):
    path = tmp_path / "ball.ply"
    path.write_bytes(generate.ply(sphere(), "ball"))
    mesh = load_mesh(path)
    np.testing.assert_array_equal(mesh.faces, sphere().faces)
    np.testing.assert_array_equal(mesh.vertices, sphere().vertices.astype(np.float32))


def test_main_writes_every_model_to_the_folder(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(generate, "MODELS", {"ball": (sphere, 0)})
    generate.main(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["ball.ply"]
    assert "42 vertices, 80 faces, genus 0" in capsys.readouterr().out


@pytest.mark.parametrize(("mesh", "genus"), [(sphere(), 1), (sphere(inside_out=True), 0)])
def test_check_refuses_a_wrong_genus_and_a_wrong_winding(mesh, genus):
    with pytest.raises(ValueError, match=f"is not one closed surface of genus {genus}"):
        generate.check(mesh, genus)
