"""Programs that use the window in processes of their own, and what they held over time."""

import json
import os
import statistics
import subprocess
import sys
from pathlib import Path

import pytest

_HERE = Path(__file__).parent


@pytest.fixture
def outcome(tmp_path):
    """Run one of the programs of this folder; its report, or a failure with all that it told."""

    def run(program, seconds, **words):
        log = tmp_path / "log"
        options = [f"--{name}={value}" for name, value in words.items()]
        process = subprocess.run(
            [sys.executable, _HERE / f"{program}.py", f"--log={log}", *options],
            capture_output=True, text=True, timeout=seconds, check=False,
            env={**os.environ, "QT_QPA_PLATFORM": "xcb"},
        )  # fmt: skip
        if process.returncode:
            last = "\n".join(log.read_text(encoding="utf-8").splitlines()[-30:])
            told = "\n\n".join(json.loads(process.stdout)["faults"]) if process.stdout else ""
            pytest.fail(f"{program} {words}\n{last}\n\n{told}\n{process.stderr}", pytrace=False)
        assert process.stderr == ""
        return json.loads(process.stdout)

    return run


@pytest.fixture
def growth():
    """How much a quantity grew, by medians of the second and the last third of what was measured.

    The first third is warm-up: caches fill, and what is imported late is imported.
    """

    def grown(measured, name):
        values = [each[name] for each in measured]
        third = len(values) // 3
        return statistics.median(values[-third:]) - statistics.median(values[third : 2 * third])

    return grown
