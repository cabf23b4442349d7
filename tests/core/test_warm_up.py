"""After the set-up no kernel is compiled while someone waits for it."""

import subprocess
import sys

# In a process of its own, because here other tests have called the kernels already.
_FORMS_ADDED = """
import sys
from core import mesh_statistics
from core.comparison import Comparison, run_method
from core.doctor import examine
from core.kernels import Kernel
from core.mesh import primitives
from core.mesh.geometry import shading_normals
from core.noise import add_noise
from core.skeleton import skeletal_graph
from core.smoothing import METHODS
from core.study import MethodChoice
from core.warm_up import warm_up


def forms():
    kernels = {
        id(value): value
        for name, module in list(sys.modules.items()) if name.startswith("core")
        for value in vars(module).values() if isinstance(value, Kernel)
    }
    return {f"{kernel.__name__} {form}" for kernel in kernels.values()
            for form in kernel.dispatcher.signatures}


warm_up()
before = forms()
ball = primitives.sphere(2)
comparison = Comparison(ball, add_noise(ball))
for method in METHODS:
    # Errors are measured of four iterations together, and of one.
    mesh = run_method(comparison, MethodChoice(method=method, iterations=5)).mesh
shading_normals(mesh.vertices + 0.0, mesh.faces)
for vertices in (mesh.vertices, mesh.vertices + 0.0):
    for evaluator in comparison.evaluators.values():
        evaluator.elements(vertices)
for known in (ball, mesh):
    examine(known)
    skeletal_graph(known)
    skeletal_graph(known, bands="vertices")
mesh_statistics(ball)
print(*sorted(forms() - before), sep="\\n")
"""


def test_warm_up_leaves_nothing_to_compile():
    command = [sys.executable, "-c", _FORMS_ADDED]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=500)
    assert done.stdout.split("\n") == ["", ""]
