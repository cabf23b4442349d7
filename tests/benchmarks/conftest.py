"""What the benchmarks share: the model, the unit, and the table at the end."""

import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

from core.io import load_mesh
from core.mesh import TriangleMesh, primitives
from core.noise import add_noise

ROUNDS = 30
# A peer's iteration is a long run less a short one, shared among the iterations between them.
FEW, MANY = 2, 12
_COLUMNS = ("units", "median", "work")


def times_of(call):
    """Seconds on the clock, and seconds of processor time of all threads."""
    clock, processor = time.perf_counter(), time.process_time()
    call()
    return time.perf_counter() - clock, time.process_time() - processor


@dataclass
class Ruler:
    """Measures calls in products of a mesh's adjacency matrix with its positions.

    Unit and call take turns, so that both are slowed down by what else the machine does.
    """

    mesh: TriangleMesh
    units: list[tuple[float, float]] = field(default_factory=list)

    def unit(self):
        adjacency, vertices = self.mesh.topology.adjacency, self.mesh.vertices
        self.units.append(times_of(lambda: adjacency @ vertices))

    def measure(self, benchmark, call, rounds=ROUNDS, of=1):
        """Run a call many times and note the times of one of the things that it does."""
        times = []
        call()
        benchmark.pedantic(lambda: times.append(times_of(call)), setup=self.unit, rounds=rounds)
        self.note(benchmark, np.min(times, axis=0) / of, np.median(times, axis=0) / of)

    def measure_iteration(self, benchmark, run, rounds=ROUNDS // 2):
        """Note the times of one iteration of `run(n)`, which carries out n, without its set-up."""
        few, many = [], []

        def prepare():
            self.unit()
            few.append(times_of(lambda: run(FEW)))

        run(FEW)
        benchmark.pedantic(
            lambda: many.append(times_of(lambda: run(MANY))), setup=prepare, rounds=rounds
        )
        least = np.min(many, axis=0) - np.min(few, axis=0)
        median = np.median(np.subtract(many, few), axis=0)
        self.note(benchmark, least / (MANY - FEW), median / (MANY - FEW))

    @staticmethod
    def compare(benchmark, name, call, other, rounds=ROUNDS):
        """Note how many times as long a call takes as another one, in turns, and as much work."""
        pairs = [(times_of(call), times_of(other)) for _ in range(rounds)]
        clock, work = np.divide(*np.median(pairs, axis=0))
        benchmark.extra_info[f"to {name}"] = f"{clock:.2f} (work {work:.2f})"

    def note(self, benchmark, least, median):
        """Note milliseconds, and ratios to the unit of least, median and processor time."""
        unit = np.median(self.units, axis=0)
        benchmark.extra_info["milliseconds"] = round(1000 * float(least[0]), 3)
        benchmark.extra_info["units"] = round(float(least[0] / np.min(self.units, axis=0)[0]), 2)
        benchmark.extra_info["median"] = round(float(median[0] / unit[0]), 2)
        benchmark.extra_info["work"] = round(float(median[1] / unit[1]), 2)


@pytest.fixture(scope="session")
def original():
    """The thesis' cow where it is at hand, else a sphere of about the same size."""
    path = Path(__file__).resolve().parents[3] / "shared" / "models" / "cow_92864.ply"
    return load_mesh(path) if path.exists() else primitives.sphere(6)


@pytest.fixture(scope="session")
def noisy(original):
    return add_noise(original)


@pytest.fixture
def ruler(noisy):
    return Ruler(noisy)


def pytest_terminal_summary(terminalreporter, config):
    session = getattr(config, "_benchmarksession", None)
    done = [bench for bench in getattr(session, "benchmarks", []) if bench.stats]
    if not done:
        return
    terminalreporter.section("benchmarks; 1 unit is one adjacency product")
    head = "".join(f"{word:>9}" for word in _COLUMNS)
    terminalreporter.write_line(f"{'':42s} {'least ms':>10s}{head}")
    for bench in done:
        notes = dict(bench.extra_info)
        milliseconds = notes.pop("milliseconds", 1000 * bench.stats.min)
        line = "".join(f"{notes.pop(key, ''):>9}" for key in _COLUMNS)
        rest = ", ".join(f"{key} {value}" for key, value in notes.items())
        terminalreporter.write_line(f"{bench.name:42s} {milliseconds:10.3f}{line}  {rest}".rstrip())
