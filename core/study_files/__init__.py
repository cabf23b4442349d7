"""Study files: a study as JSON with its models by place and content, or packed in one file."""

from core.study_files.document import FORMAT_VERSION
from core.study_files.errors import ChangedModelError, MissingModelError, StudyFileError
from core.study_files.fingerprints import Fingerprint, fingerprint
from core.study_files.places import Role
from core.study_files.reading import STUDY_SUFFIX, StudyFile, parse_study, read_study_file
from core.study_files.writing import study_text, write_study_file

__all__ = [
    "FORMAT_VERSION",
    "STUDY_SUFFIX",
    "ChangedModelError",
    "Fingerprint",
    "MissingModelError",
    "Role",
    "StudyFile",
    "StudyFileError",
    "fingerprint",
    "parse_study",
    "read_study_file",
    "study_text",
    "write_study_file",
]
