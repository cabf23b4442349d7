"""What a study is loaded from, and what changes while it is loaded."""

from core.study import Study


def carried_over(wanted: Study, before: Study, now: Study) -> Study:
    """Return the study that was loaded, with what a person changed while it was loading."""
    changed = {
        name: getattr(now, name)
        for name in Study.model_fields
        if getattr(now, name) != getattr(before, name)
    }
    return wanted.model_copy(update={**changed, **sources_of(wanted)})


def sources_of(study: Study) -> dict[str, object]:
    """What the meshes of a study, and how they are compared, depend on."""
    names = ("model", "repairs", "noisy", "noise", "model_units")
    return {name: getattr(study, name) for name in names}
