"""What `plan` says of every effect: whether it is simulated, and why not."""

from collections.abc import Iterator

from ..study import QUANTITIES, FromFile, Hold, Material, Oscillate, Ramp, Slide, Study, why_not

NAMES = {Slide: "slide", Hold: "hold", Ramp: "ramp", Oscillate: "oscillate", FromFile: "file"}


def effect_lines(study: Study) -> list[str]:
    """Return a line for every effect that a scene can call for, quantities among them."""
    found = [*_materials(study), *_surface(study), *_motion(study), *_quantities(study)]
    lines = [f"simulated     {what}" if yes else f"not simulated {what}" for yes, what in found]
    rate = "kept" if study.scene.indentation_rate else "dropped, as eq. 3 is printed"
    return [*lines, f"indentation rate in the force: {rate}"]


def _materials(study: Study) -> Iterator[tuple[bool, str]]:
    for label, material in study.materials.items():
        if not label or material != study.material:
            yield True, f"rheology{f' of {label}' if label else ''}: {_rheology(material)}"
    if not any(material.branches for material in study.materials.values()):
        yield False, "branches of relaxation: material.branches is not given"
    count = len(study.material.temperatures)
    if count:
        yield True, f"{count} temperatures: all times shifted by WLF"
    elif study.material.wlf:
        yield True, "one temperature: all times shifted by WLF"
    else:
        yield False, "temperature: material.temperature and wlf are not given"


def _rheology(material: Material) -> str:
    tau = f"tau = {material.tau:.4g} s"
    if not material.branches:
        return f"Kelvin element, {tau}"
    number = len(material.branches)
    kind = "standard linear solid" if number == 1 else f"Prony series of {number} branches"
    dashpot = "with a dashpot" if material.jumps else "without a dashpot"
    times = f"times {material.branches[0][1]:.3g} ... {material.branches[-1][1]:.3g} s"
    return f"{kind} {dashpot}, {times}, {tau}"


def _surface(study: Study) -> Iterator[tuple[bool, str]]:
    surface = study.surface
    if surface.profile is not None:
        lines, samples = surface.profile.heights.shape
        how = "as they are" if surface.lines == "measured" else f"{surface.lines} lines like them"
        yield True, f"measured lines: {lines} of {samples} samples, {how}"
        return
    yield False, "measured lines: surface.file is not given; lines are random and self-affine"
    for name, value in (("rolloff", surface.rolloff), ("cutoff", surface.cutoff)):
        said = f"{value:.4g} m" if value else f"surface.{name} is not given"
        yield bool(value), f"{name}: {said}"


def _motion(study: Study) -> Iterator[tuple[bool, str]]:
    scene = study.scene
    if scene.programme:
        names = [NAMES[type(segment)] for segment in scene.programme]
        shown = ", ".join(names[:8]) + (", ..." if len(names) > 8 else "")
        again = f", {scene.repeat} times" if scene.repeat > 1 else ""
        yield True, f"programme from {scene.start}: {shown}{again}"
    else:
        yield False, "programme: there is no [[scene.programme]]; v1 steps to v2"
    if scene.control == "force":
        yield True, "constant normal force"
        yield False, 'prescribed indentation: scene.control is "force"'
    else:
        kind = "over time" if scene.indentation_history else "constant"
        yield False, 'constant normal force: scene.control is "indentation"'
        yield True, f"prescribed indentation, {kind}"


def _quantities(study: Study) -> Iterator[tuple[bool, str]]:
    alone = study.realizations == 1 and not study.scene.holds
    for name, quantity in QUANTITIES.items():
        if name in study.scene.quantities:
            yield True, f"{name}: {quantity.effect}"
        else:
            reason = why_not(name, study.scene, study.materials, alone) or "it is not asked for"
            yield False, f"{name}: {reason}"
