"""A study as a Python script on :mod:`core`, to go on with where the window ends."""

from typing import Any

from core.doctor import RepairChoice
from core.study import SAMPLE_PREFIX, MethodChoice, Study

_SCRIPT = '''"""A comparison of denoisers, written by Burnish."""

from core import DivergenceError, {imports}
{doctor_import}from core.metrics import metrics_in
{sample_import}
{originals}noisy = {noisy}

# Method, iterations, and the parameters that differ from their defaults.
methods = [
{methods}]
evaluators = {{
    name: metric.evaluator(original)
    for name, metric in metrics_in(model_units={model_units}).items()
}}


def report(name, mesh):
    errors = {{id_: evaluator.value(mesh.vertices) for id_, evaluator in evaluators.items()}}
    print(name, *(f"{{id_}}={{error!r}}" for id_, error in errors.items()))


report("noisy", noisy)
for method, iterations, params in methods:
    try:
        report(method, smooth(noisy, method, iterations, **params))
    except DivergenceError as error:
        print(method, error)
'''

_DOCTOR_IMPORT = "from core.doctor import RepairChoice, repaired\n"


def script_of(study: Study) -> str:
    """Return a Python script that gives the numbers of a study."""
    models = [study.model] if study.noisy is None else [study.model, study.noisy]
    loads = {"load_mesh" for model in models if not model.startswith(SAMPLE_PREFIX)}
    noise = {"add_noise"} if study.noisy is None else set()
    bundled = any(model.startswith(SAMPLE_PREFIX) for model in models)
    return _SCRIPT.format(
        imports=", ".join(sorted({*loads, *noise, "smooth"})),
        doctor_import=_DOCTOR_IMPORT if study.repairs else "",
        sample_import="from core.io import load_sample\n" if bundled else "",
        originals=_originals(study),
        noisy=_noisy(study),
        methods="".join(_line(choice) for choice in study.methods if choice.enabled),
        model_units=study.model_units,
    )


def _load(model: str) -> str:
    if model.startswith(SAMPLE_PREFIX):
        return f"load_sample({model.removeprefix(SAMPLE_PREFIX)!r})"
    return f"load_mesh({model!r})"


def _originals(study: Study) -> str:
    """Lines that read the original, and repair it where the study does."""
    if not study.repairs:
        return f"original = {_load(study.model)}\n"
    choices = "".join(f"    {_repair(choice)},\n" for choice in study.repairs)
    return (
        f"loaded = {_load(study.model)}\nwhole = repaired(loaded, [\n{choices}])\n"
        "original = whole.mesh\n"
    )


def _repair(choice: RepairChoice) -> str:
    params = f", params={choice.params!r}" if choice.params else ""
    return f"RepairChoice(repair={choice.repair!r}{params})"


def _noisy(study: Study) -> str:
    if study.noisy is not None and study.repairs:
        return f"whole.carry(loaded.with_vertices({_load(study.noisy)}.vertices))"
    if study.noisy is not None:
        return f"original.with_vertices({_load(study.noisy)}.vertices)"
    return f"add_noise(original, sigma={study.noise.sigma!r}, seed={study.noise.seed!r})"


def _line(choice: MethodChoice) -> str:
    changed: dict[str, Any] = choice.settings.model_dump(exclude_defaults=True)
    return f"    ({choice.method!r}, {choice.iterations!r}, {changed!r}),\n"
