"""A study from a stranger, and what is said when it is read."""

import json

import pytest

from core.io import save_mesh
from core.mesh import primitives
from core.study import Study
from core.study_files import StudyFileError, read_study_file, write_study_file


@pytest.fixture
def file(tmp_path):
    """A plain study of a tetrahedron, in a folder of its own."""
    (tmp_path / "study").mkdir()
    save_mesh(primitives.tetrahedron(), tmp_path / "study" / "t.ply")
    path = tmp_path / "study" / "a.burnish"
    write_study_file(Study(model=str(tmp_path / "study" / "t.ply")), path)
    return path


@pytest.fixture
def plain(file):
    return json.loads(file.read_text())


@pytest.fixture
def refused():
    """Sentence with which a file that must be refused is refused."""

    def refused(file, folder) -> str:
        with pytest.raises(StudyFileError) as caught:
            read_study_file(file).locate(folder)
        return str(caught.value)

    return refused


@pytest.fixture
def outcome():
    """Sentence with which a file is refused, empty if it is read."""

    def outcome(file, folder) -> str:
        try:
            read_study_file(file).locate(folder)
        except StudyFileError as error:
            return str(error)
        return ""

    return outcome
