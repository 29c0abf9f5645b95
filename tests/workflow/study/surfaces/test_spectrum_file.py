"""The table surface.spectrum: every kind of file is the same surface, as are its results."""

from math import gamma, pi

import numpy as np
import pytest

import elastomer_friction as ef
from elastomer_friction.kernels import amplitudes
from elastomer_friction.workflow.study.settings import checked
from elastomer_friction.workflow.study.surfaces.table import SURFACE, read_surface

H, LENGTH = 0.8, 1e-3
Q = np.geomspace(2.0 * pi / LENGTH, 1e6, 40)
C_2D = 1e-4 * Q ** (-2.0 * H - 2.0)
SHARE_OF_CUT = 2.0 * gamma(H + 1.5) / ((2.0 * H + 1.0) * np.sqrt(pi) * gamma(H + 1.0))
FILES = {  # columns in the convention of each kind
    "2D": C_2D,
    "equivalent": pi * Q * C_2D,
    "profile": SHARE_OF_CUT * pi * Q * C_2D,
    "profile+": 2.0 * SHARE_OF_CUT * pi * Q * C_2D,
}
SCENE = {
    "material": {"shear_modulus": 1e6, "relaxation_time": 1e-4},
    "normal_pressure": 2e5,
    "programme": [{"slide": {"velocity": 0.1, "distance": 1e-4}}],
    "quantities": ["steady", "persson"],
    "realizations": 4,
}


def written(folder, kind, factor=1.0, header=""):
    unit = "m^4" if kind == "2D" else "m^3"
    values = np.stack([Q, factor * FILES[kind]], axis=1)
    name = f"{kind}.csv"
    np.savetxt(folder / name, values, "%.12e", ", ", header=header or f"q [1/m], C [{unit}]")
    return {"file": str(folder / name), "kind": kind}


def surface_of(folder, spectrum, body=None, **keys):
    table = checked("surface", {"length": LENGTH, "spectrum": spectrum, **keys}, SURFACE)
    return read_surface(table, folder, body)


@pytest.mark.parametrize("kind", FILES)
def test_every_kind_is_the_same_surface(tmp_path, kind):
    surface = surface_of(tmp_path, written(tmp_path, kind), rms_slope=0.5)
    assert surface.power.density == pytest.approx(tuple(C_2D), rel=1e-6)
    q_1 = (0.5**2 * 0.4 / (2.0 * pi * 1e-4) + Q[0] ** 0.4) ** 2.5
    assert 2.0 * pi / surface.cutoff == pytest.approx(q_1, rel=1e-6)
    assert f"q_1 = {q_1:.4g} 1/m" in surface.description
    modes = surface.drawn_amplitudes(200)
    cutoff = int(LENGTH / surface.cutoff)
    like = amplitudes(H, 200, cutoff=cutoff)
    assert modes / modes[0] == pytest.approx(like / like[0], rel=1e-6)


def test_a_factor_and_a_unit_are_applied(tmp_path):
    less = written(tmp_path, "2D", 1.0 / (4.0 * pi**2)) | {"times": 4.0 * pi**2}
    surface = surface_of(tmp_path, less)
    assert surface.power.density == pytest.approx(tuple(C_2D), rel=1e-9)
    small = Q * 1e-6, C_2D * 1e24
    np.savetxt(tmp_path / "um.csv", np.stack(small, 1), "%.12e", header="q [1/um] C [um^4]")
    other = surface_of(tmp_path, {"file": "um.csv", "kind": "2D"})
    assert other.power.density == pytest.approx(tuple(C_2D), rel=1e-9)


def test_above_the_roll_off_the_surface_is_flat(tmp_path):
    flat = surface_of(tmp_path, written(tmp_path, "2D"), rolloff=LENGTH / 4, body="half-space")
    rings = flat.drawn_amplitudes(32)
    assert rings[0, 1:5] == pytest.approx(np.full(4, rings[0, 4]))
    assert rings[0, 8] / rings[0, 4] == pytest.approx(0.5 ** (H + 1.0), rel=1e-6)


@pytest.mark.parametrize("body", ["half-space", "foundation"])
def test_a_scene_slides_as_over_the_self_affine_surface(tmp_path, body):
    """In units of its roughness the same surface with the same phases."""
    spacing = LENGTH / 32
    spectrum = {"length": LENGTH, "spacing": spacing, "spectrum": written(tmp_path, "profile")}
    measured = ef.scene.run(surface=spectrum, body=body, **SCENE)
    same = {"hurst": H, "roughness": float(measured.roughness)}
    affine = ef.scene.run(surface={"length": LENGTH, "spacing": spacing} | same, body=body, **SCENE)
    for name in ("mu_1", "mu_1_error", "contact_fraction", "rms_slope", "q_max"):
        assert float(measured[name]) == pytest.approx(float(affine[name]), rel=1e-4)
    assert float(measured.mu_persson) == pytest.approx(float(affine.mu_persson), rel=0.15)


def test_persson_takes_the_waves_longer_than_the_surface(tmp_path):
    """The whole table up to the cut-off: a quarter of the length changes nothing in the theory."""
    spectrum = written(tmp_path, "2D")
    theory = []
    for length in (LENGTH, LENGTH / 4):
        surface = {"length": length, "spacing": LENGTH / 128, "spectrum": spectrum}
        surface["rms_slope"] = 0.3
        result = ef.scene.run(surface=surface, body="foundation", **SCENE)
        theory.append((float(result.mu_persson), float(result.area_persson)))
    assert theory[0] == pytest.approx(theory[1], rel=1e-9)
