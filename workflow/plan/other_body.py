"""Steady friction on the other body at the points of a study: the error of the model.

The foundation and the half-space are computed for the same rough surface, at the same nominal
pressure and speed. ``model_ratio`` is mu_1 of the foundation over that of the half-space.
"""

from dataclasses import replace

from ...kernels import QUARTET
from ..study import (
    FOUNDATION,
    HALF_SPACE,
    Numerics,
    Profile,
    SceneEffects,
    Study,
    Surface,
    rows_of_map,
)
from .half_space import MAX_MAP_SAMPLES

MODEL_LABEL = "other body"  # label of the variant; no comparison may have it
MODEL_ACCURACY = 0.05  # relative standard error of its steady friction
MAP_STEPS, LINE_STEPS = 4, 8  # steps per spacing
MAX_MAPS, MAX_LINES = 64, 1024  # per point
MAX_COST_SHARE = 0.1  # of the study, up to which the other body is computed by default


def compared_label(study: Study) -> str | None:
    """Return the label of a comparison that differs from the study in its body alone, or None."""
    other = other_body(study.surface)
    for label, surface in study.surfaces.items():
        same = study.materials[label] == study.material
        if label and same and surface == study.surface._replace(body=other):
            return label
    return None


def other_body(surface: Surface) -> str:
    """Return the other body of the two."""
    return FOUNDATION if surface.body == HALF_SPACE else HALF_SPACE


def study_of_other_body(study: Study) -> Study | str:
    """Return the study of steady friction on the other body, or the reason why there is none."""
    if "steady" not in study.scene.quantities:
        return "steady friction is not requested"
    if study.scene.effects.heat is not None:
        return "the foundation has no heating, which changes the viscoelastic friction"
    surface = study.surface
    if surface.profile is not None:
        if surface.body == FOUNDATION:
            return "measured lines do not form a map"
        return _on_rows(study, surface, surface.profile)
    on_maps = surface.body == FOUNDATION
    most = int(MAX_MAP_SAMPLES**0.5) // MAP_STEPS
    elements = round(surface.length / min(study.grid["spacing"]))
    if on_maps and elements > most:
        return f"a map of {elements} x {elements} elements is larger than {most} x {most}"
    numerics = Numerics(
        steps_per_spacing=MAP_STEPS if on_maps else LINE_STEPS,
        accuracy=MODEL_ACCURACY,
        max_realizations=MAX_MAPS if on_maps else MAX_LINES,
    )
    block = 1 if on_maps else QUARTET
    other = surface._replace(body=other_body(surface))
    return _with_surface(study, other, numerics, numerics.max_realizations, block)


def _on_rows(study: Study, surface: Surface, profile: Profile) -> Study:
    """Return the study of the rows of a map as lines of a foundation."""
    rows = rows_of_map(profile)
    lines = surface._replace(body=FOUNDATION, profile=rows)
    count, block = len(rows.heights), 1
    if rows.correlation is not None:
        count, block = rows.correlation.whole_blocks(count, every=False)
    other = _with_surface(study, lines, Numerics(), count, block)
    return replace(other, grid=other.grid | {"roughness": (rows.roughness,)})


def _with_surface(
    study: Study, surface: Surface, numerics: Numerics, realizations: int, block: int
) -> Study:
    """Return a study of steady friction on another surface at the same nominal pressures."""
    share = surface.pressed_area / study.surface.pressed_area
    forces = tuple(share * force for force in study.grid["normal_force"])
    return replace(
        study,
        scene=study.scene._replace(quantities=("steady",), effects=SceneEffects()),
        grid=study.grid | {"normal_force": forces},
        surfaces={"": surface, MODEL_LABEL: surface},
        materials={"": study.material, MODEL_LABEL: study.material},
        effects=dict.fromkeys(("", MODEL_LABEL), SceneEffects()),
        variants={MODEL_LABEL: numerics},
        realizations_requested=realizations,
        realizations=realizations,
        realizations_per_block=block,
    )
