"""Reading study files, plain or with their models packed inside."""

import os
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from zipfile import is_zipfile

from core.io import LoadError
from core.statistics_view import NO_SECOND
from core.study import Study
from core.study_files.document import MOST_BYTES, read_document
from core.study_files.errors import ChangedModelError, MissingModelError, StudyFileError
from core.study_files.fingerprints import Fingerprint, fingerprint, model_path
from core.study_files.packing import MOST_MODEL_BYTES, packed_document, unpack
from core.study_files.places import (
    PACKED_PREFIX,
    Role,
    models_of,
    place_name,
    read_place,
    with_models,
)

STUDY_SUFFIX = ".burnish"

_TITLES: dict[Role, str] = {
    "model": "model", "noisy": "noisy file", "second": "second model",
}  # fmt: skip


@dataclass(frozen=True)
class StudyFile:
    """A study as read from a file, before its models are looked for.

    Attributes
    ----------
    path : Path
        The file.
    study : Study
        The study, its models named as in the file.
    fingerprints : dict of str to Fingerprint
        What the models were when the study was saved.
    packed : bool
        Whether the models are inside the file.
    """

    path: Path
    study: Study
    fingerprints: dict[str, Fingerprint]
    packed: bool = False

    def locate(
        self,
        unpack_to: Path,
        *,
        chosen: Mapping[Role, str] | None = None,
        accepted: Collection[Role] = (),
        with_second: bool = True,
    ) -> Study:
        """Return the study with its models found and their content compared.

        A model is read any further only if its content is what the study says, or if the person
        said that another content will do. So a study from a stranger opens no other file.

        Parameters
        ----------
        unpack_to : Path
            Folder for packed models; each goes into a folder named by its content.
        chosen : mapping, optional
            Models to take instead of those that the file names: path or ``sample:ID`` by role.
        accepted : collection of {"model", "noisy", "second"}
            Models whose content may differ from what the study says.
        with_second : bool
            Look for the second model where it is a file; without it the study has none.

        Returns
        -------
        Study
            Its models are absolute paths or ``sample:ID``.

        Raises
        ------
        MissingModelError, ChangedModelError
            If a model is not there or is another; says which and where.
        StudyFileError
            If a packed model is damaged or cannot be put into `unpack_to`.
        """
        study = self.study if with_second else _without_second_file(self.study)
        found = {
            role: self._found(role, (chosen or {}).get(role), unpack_to, role in accepted)
            for role in models_of(study)
        }
        return with_models(study, found)

    def _found(self, role: Role, chosen: str | None, unpack_to: Path, accepted: bool) -> str:
        place = chosen or self._place(role, unpack_to)
        title, name = _TITLES[role], place_name(place)
        try:
            if not model_path(place).is_file():
                raise MissingModelError(
                    f"{self.path.name}: its {title} {name} is not at {place}.", role, place
                )
            if not (accepted or self._is_same(role, place)):
                raise ChangedModelError(
                    f"{self.path.name}: its {title} {name} is not the one the study was saved "
                    f"with ({place}).", role, place,
                )  # fmt: skip
        except LoadError as error:
            raise MissingModelError(f"{self.path.name}: {error}", role, place) from error
        except OSError as error:
            reason = error.strerror or error
            raise MissingModelError(
                f"{self.path.name}: its {title} {place} cannot be read ({reason}).", role, place
            ) from error
        return place

    def _place(self, role: Role, unpack_to: Path) -> str:
        text = models_of(self.study)[role]
        try:
            if not (self.packed and text.startswith(PACKED_PREFIX)):
                return read_place(text, self.path.parent)
            member = text.removeprefix(PACKED_PREFIX)
            return str(unpack(self.path, member, self.fingerprints[role], unpack_to))
        except (ValueError, OSError) as error:
            raise StudyFileError(f"{self.path.name}: {error}.") from error

    def _is_same(self, role: Role, place: str) -> bool:
        wanted = self.fingerprints[role]
        same_size = model_path(place).stat().st_size == wanted.size
        return same_size and fingerprint(place) == wanted


def read_study_file(path: str | os.PathLike[str]) -> StudyFile:
    """Read a study file; its models are not touched yet.

    Parameters
    ----------
    path : str or path-like
        The file; plain and packed ones are told apart by their content.

    Returns
    -------
    StudyFile
        To be followed by :meth:`StudyFile.locate`.

    Raises
    ------
    StudyFileError
        One sentence: no such file, not a study, unknown version or field, value not allowed.
    """
    file = Path(path)
    try:
        if not file.is_file():
            raise StudyFileError(f"{file.name or file}: there is no such file.")
        packed = is_zipfile(file)
        content = _packed_content(file) if packed else _plain_content(file)
    except OSError as error:
        reason = error.strerror or error
        raise StudyFileError(f"{file.name}: cannot be read ({reason}).") from error
    return parse_study(content, file, packed=packed)


def parse_study(content: bytes, path: Path, *, packed: bool = False) -> StudyFile:
    """Read a study from the content of a plain file, or from the document of a packed one.

    Raises
    ------
    StudyFileError
        One sentence that names the file.
    """
    try:
        document = read_document(content)
    except ValueError as error:
        raise StudyFileError(f"{path.name}: {str(error).removesuffix('.')}.") from error
    return StudyFile(path, document.study, document.files, packed)


def _without_second_file(study: Study) -> Study:
    return with_models(study, {"second": NO_SECOND}) if study.statistics.second_file else study


def _plain_content(file: Path) -> bytes:
    with file.open("rb") as stream:
        return stream.read(MOST_BYTES + 1)


def _packed_content(file: Path) -> bytes:
    try:
        if file.stat().st_size > 2 * MOST_MODEL_BYTES:
            raise ValueError("is larger than a packed study can be")
        return packed_document(file)
    except ValueError as error:
        raise StudyFileError(f"{file.name}: {error}.") from error
