"""Exported laws in C, Fortran and as an FMU agree with the law in Python."""

import ctypes
import io
import platform
import re
import shutil
import subprocess
import warnings
import zipfile
from dataclasses import replace

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.law import LuGreLaw, export, read
from elastomer_friction.workflow.law.fitted_law import Validity
from tests.workflow.law.given import load_law, memory_law

LAW = memory_law().with_validity(
    Validity(
        0.01, 0.1, held_rms=3e-3, usual=0.5, motions=(("slide */ 1", 1e-3),), shortest_stroke=3e-3
    )
)
COMPILER = shutil.which("gcc") or shutil.which("cc")
compiled = pytest.mark.skipif(not COMPILER, reason="there is no C compiler")
TIME = np.sort(np.concatenate([np.linspace(0.0, 0.3, 400), [0.1, 0.2]]))
SWING = 0.05 * (1.0 + 0.6 * np.sin(60.0 * np.pi * TIME)) * np.sign(0.2 - TIME) * (TIME < 0.28)


USE = """
subroutine run(n, t, v, mu, outside) bind(c)
use iso_c_binding
use rubber_law
integer(c_int), value :: n
real(c_double) :: t(n), v(n), mu(n), state(states), outside(n)
call rubber_init(state, v(1))
do k = 1, n
  call rubber_step(state, v(k), t(k) - t(max(k - 1, 1)), mu(k))
  outside(k) = state(at_outside)
end do
end subroutine
subroutine coefficient(n, v, mu, slope) bind(c)
use iso_c_binding
integer(c_int), value :: n
integer :: flags(4)
real(c_double) :: v(n), mu(n), slope(n, 3), none(n)
character*80 :: name
call vfric_coef(mu, slope, n, 1, 1, 1, flags, none, name, name, name, none, v, none, none, none)
end subroutine
"""


def loaded(folder, *command):
    """Return the library, with run(n, t, v, mu, outside), that a compiler makes of a folder."""
    subprocess.run([*command, "-shared", "-fPIC", "-o", "use.so"], cwd=folder, check=True)
    library, numbers = ctypes.CDLL(str(folder / "use.so")), np.ctypeslib.ndpointer(float)
    library.run.argtypes = [ctypes.c_int, *[numbers] * 4]
    return library


def assert_followed(library, law, load_flag=0):
    """Assert that a library and the law give the same friction and the same faults of motions.

    The random motions have long steps through zero, jumps, rests, and speeds beyond the range.
    """
    generator = np.random.default_rng(51)
    motions = [(TIME, SWING)]
    for fastest in (0.09, 0.3):
        for slow in (0.0, -0.5):
            duration = generator.choice([0.0, 1e-4, 0.02, 0.2], 100)
            velocity = fastest * generator.uniform(slow, 1.0, 100) * generator.integers(0, 2, 100)
            motions.append((np.cumsum(duration), velocity))
    flags = set()
    for time, velocity in motions:
        mu, outside = np.empty_like(time), np.empty_like(time)
        library.run(time.size, time, velocity, mu, outside)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            expected = law.run(time, velocity)
        assert mu == pytest.approx(expected, rel=1e-12, abs=1e-12)
        texts = " ".join(str(warning.message) for warning in caught)
        flag = ("above the fastest" in texts) + 2 * ("between two turns" in texts)
        assert outside[-1] == flag + load_flag
        flags.add(flag)
    assert flags == {0, 1, 2, 3}


@compiled
@pytest.mark.parametrize("states", [0, 1, 2])
@pytest.mark.parametrize("force", [None, 0.5, 1.0, 1.3, 2.0, 5.0, 9.0])
def test_the_header_in_c_is_the_law_to_rounding(tmp_path, states, force):
    law = written = memory_law(states).with_validity(LAW.validity)
    load = "" if force is None else f", {force}"
    if force is not None:
        written = load_law(states).with_validity(LAW.validity)
        law = written.at(normal_force=float(np.clip(force, 1.0, 8.0)))  # it is clamped
    (tmp_path / "rubber.h").write_bytes(export(written, "c", "rubber").content)
    (tmp_path / "use.c").write_text(
        '#include "rubber.h"\n'
        "void run(int n, const double *t, const double *v, double *mu, double *outside)\n"
        "{\n    double state[RUBBER_STATES];\n    int k;\n"
        f"    rubber_init(state, v[0]{load});\n"
        "    for (k = 0; k < n; ++k) {\n"
        "        mu[k] = rubber_step(state, v[k], k ? t[k] - t[k - 1] : 0.0);\n"
        "        outside[k] = state[RUBBER_OUTSIDE];\n    }\n}\n"
        f"double steady(double v) {{ return rubber_steady(v{load}); }}\n"
    )
    strict = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror"]
    library = loaded(tmp_path, COMPILER, *strict, "use.c", "-lm")
    library.steady.argtypes, library.steady.restype = [ctypes.c_double], ctypes.c_double
    assert_followed(library, law, 0 if force is None or 1.0 <= force <= 8.0 else 4)
    for v in (-0.3, -0.03, 0.0, 1e-4, 0.001, 0.05, 0.1):
        assert library.steady(v) == pytest.approx(float(law.steady(v)), rel=1e-13, abs=1e-15)


@pytest.mark.skipif(not shutil.which("gfortran"), reason="there is no Fortran compiler")
@pytest.mark.parametrize("states", [0, 2])
def test_the_fortran_is_the_law_to_rounding(tmp_path, states):
    """VFRIC_COEF of Abaqus gives steady friction, the step with states the whole law."""
    law = memory_law(states).with_validity(LAW.validity)
    (tmp_path / "rubber.f").write_bytes(export(law, "fortran", "rubber").content)
    (tmp_path / "vaba_param.inc").write_text("      implicit real*8(a-h, o-z)\n")
    (tmp_path / "use.f90").write_text(USE)
    library = loaded(tmp_path, "gfortran", "-O2", "rubber.f", "use.f90")
    library.coefficient.argtypes = library.run.argtypes[:4]
    assert_followed(library, law)
    v = np.array([0.0, 1e-4, 0.0015, 0.03, 0.07, 0.3])
    steady, slope = np.empty_like(v), np.empty((3, v.size))
    library.coefficient(v.size, v, steady, slope)
    assert steady == pytest.approx(law.steady(v), rel=1e-13, abs=1e-15)
    dv = 1e-5 * v + 1e-9
    assert slope[0] == pytest.approx((law.steady(v + dv) - law.steady(v)) / dv, rel=1e-3)
    assert not slope[1:].any()


def test_range_errors_and_motions_are_comments_of_every_text():
    for form, mark in (("c", " * "), ("fortran", "! ")):
        text = export(LAW, form, "1 rubber").content.decode()
        joined = text.replace(f"\n{mark}", " ")  # comments over several lines
        assert f"{mark}range: speeds of 0.01 ... 0.1 m/s" in text
        assert re.search(r"error on the worst of the motions held out: 0.003 rms \(0.6 %", joined)
        assert "the tables clamp the speed to 0.1 m/s" in joined
        assert f"{mark}rms error 0.001 in slide * / 1" in text
        assert "0.003 m or more between turns" in joined
        assert "_1_rubber" in text


@compiled
@pytest.mark.skipif(
    (platform.system(), platform.machine()) != ("Linux", "x86_64"),
    reason="no library is made for this platform",
)
@pytest.mark.parametrize("force", [None, 4.0], ids=["one-load", "over-load"])
def test_the_fmu_is_valid_and_runs_as_the_law_does(tmp_path, force):
    fmpy = pytest.importorskip("fmpy")
    validation = pytest.importorskip("fmpy.validation")
    whole, begin = (LAW, {}) if force is None else (load_law(), {"normal_force": force})
    law = whole.at(**begin) if begin else LAW
    written = export(whole, "fmu", "rubber")
    assert written.description == "an FMU with its C sources and a library for linux64"
    path = tmp_path / "rubber.fmu"
    path.write_bytes(written.content)
    assert validation.validate_fmu(str(path)) == []
    step, count = 1e-3, 200
    t = step * np.arange(count + 1)
    v = 0.04 * np.cos(40.0 * t)
    given = np.array(list(zip(t, v, strict=True)), [("time", float), ("v", float)])
    asked = {"stop_time": t[-1], "output_interval": step, "step_size": step, "output": ["mu"]}
    actual = fmpy.simulate_fmu(str(path), input=given, start_values=begin, **asked)
    state, expected = law.init(v[0]), [law.step(law.init(v[0]), v[0], 0.0)[1]]
    for held in v[:-1]:
        state, _ = law.step(state, held, 0.0)
        state, mu = law.step(state, held, step)
        expected.append(mu)
    assert actual["mu"] == pytest.approx(expected, rel=1e-9, abs=1e-12)  # of times that are summed
    assert export(whole, "fmu", "rubber").content == written.content


@compiled
def test_the_sources_of_the_fmu_link_beside_others(tmp_path):
    with zipfile.ZipFile(io.BytesIO(export(LAW, "fmu", "rubber").content)) as whole:
        whole.extractall(tmp_path)
    strict = ["-std=c99", "-Wall", "-Werror", "-DFMI2_FUNCTION_PREFIX=rubber_"]
    sources = tmp_path / "sources"
    subprocess.run([COMPILER, *strict, "-c", "fmu.c"], cwd=sources, check=True)
    assert b" T rubber_fmi2DoStep" in subprocess.check_output(["nm", "fmu.o"], cwd=sources)


def test_without_a_compiler_the_fmu_has_its_sources_alone(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda _: None)
    written = export(LAW, "fmu", "rubber")
    assert written.description.startswith("an FMU with C sources alone: this machine has no")
    names = zipfile.ZipFile(io.BytesIO(written.content)).namelist()
    assert names == ["modelDescription.xml", "sources/rubber.h", "sources/fmu.c"]


def test_the_description_of_the_fmu_is_short():
    """It holds range and errors, but not the error of every segment."""
    segments = tuple((f"segment {k}", 1e-3) for k in range(100))
    law = LAW.with_validity(replace(LAW.validity, motions=segments))
    fmu = zipfile.ZipFile(io.BytesIO(export(law, "fmu", "rubber").content))
    model = fmu.read("modelDescription.xml").decode()
    (description,) = re.findall(r'description="(fitted to ; range: [^"]*)"', model)
    assert len(description) < 1000
    assert "0.003 m or more between turns" in description
    assert re.findall(r'name="(\w+)"[^>]*causality="local"', model) == list(law.names)


def test_json_is_read_back_and_other_laws_have_no_other_form():
    assert read(export(LAW, "json").content.decode()).to_json() == LAW.to_json()
    lugre = LuGreLaw(1e4, 0.0, 0.0, 0.5, 0.6, 0.01)
    assert export(lugre, "json").description == "the law as JSON"
    with pytest.raises(UserError, match="c: requires a law of the kind states, not lugre"):
        export(lugre, "c")
    with pytest.raises(UserError, match=r"pascal: unknown .* must be one of c, fortran, fmu, json"):
        export(LAW, "pascal")
    with pytest.raises(UserError, match="fortran: requires the law of one load"):
        export(load_law(), "fortran")
