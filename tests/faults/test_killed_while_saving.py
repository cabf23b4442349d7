"""Killed while it saves, at any moment: the old file or the new one, never half."""

import subprocess
import sys
import zipfile

import pytest

from core.io import load_mesh

# One process starts the others by forking, which takes a millisecond instead of a second.
_PROGRAM = """
import os, random, signal, sys, time
from pathlib import Path
from core.io import save_mesh
from core.mesh import primitives
from core.study import Study
from core.study_files import write_study_file

folder, rounds = Path(sys.argv[1]), int(sys.argv[2])
models = [primitives.sphere(3), primitives.torus(40, 20)]
save_mesh(primitives.sphere(4), folder / "packed.ply")
study = Study(model=str(folder / "packed.ply"))
longer = study.model_copy(update={"methods": study.methods * 50})
write = {
    "mesh.ply": lambda path, turn: save_mesh(models[turn], path),
    "mesh.obj": lambda path, turn: save_mesh(models[turn], path),
    "plain.burnish": lambda path, turn: write_study_file([study, longer][turn], path),
    "packed.burnish": lambda path, turn: write_study_file([study, longer][turn], path, packed=True),
}[sys.argv[3]]
path = folder / sys.argv[3]
whole = []
for turn in (0, 1):
    started = time.monotonic()
    write(path, turn)
    seconds = time.monotonic() - started
    whole.append(path.read_bytes())
rng = random.Random(5)
seen = set()
round = 0
# Where other work keeps the processes waiting, it takes more rounds until both were seen.
while round < rounds or len(seen) < 2:
    round += 1
    begun, begin = os.pipe()
    child = os.fork()
    if not child:
        os.write(begin, b"!")
        turn = round
        while True:
            turn += 1
            write(path, turn % 2)
    os.read(begun, 1)
    time.sleep(rng.uniform(0, 4 * seconds))
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    os.close(begun)
    os.close(begin)
    content = path.read_bytes()
    if content not in whole:
        sys.exit(f"half a file of {len(content)} bytes after round {round}")
    seen.add(whole.index(content))
print(sorted(seen))
"""
ROUNDS = 60


@pytest.mark.skipif(sys.platform == "win32", reason="processes are forked")
@pytest.mark.parametrize("name", ["mesh.ply", "mesh.obj", "plain.burnish", "packed.burnish"])
def test_a_file_is_the_old_one_or_the_new_one(name, tmp_path):
    words = [sys.executable, "-c", _PROGRAM, str(tmp_path), str(ROUNDS), name]
    result = subprocess.run(words, capture_output=True, text=True, timeout=60, check=False)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.strip() == "[0, 1]"
    if name.startswith("mesh"):
        assert len(load_mesh(tmp_path / name).faces)
    if name.startswith("packed"):
        assert zipfile.ZipFile(tmp_path / name).testzip() is None
