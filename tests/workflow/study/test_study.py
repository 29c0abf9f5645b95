"""A study of a grid: values of the file, defaults, comparisons, elements, where it is computed."""

import copy
import json
import math
import tomllib
from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.cluster import CLUSTER as KEYS
from elastomer_friction.workflow.study.cluster import (
    THIS_MACHINE,
    Cluster,
    walltime_seconds,
)
from elastomer_friction.workflow.study.effects.material import Material
from elastomer_friction.workflow.study.numerics import Numerics
from elastomer_friction.workflow.study.settings import checked
from elastomer_friction.workflow.study.study import read_grid_study
from tests.support.documents import CLUSTER, without
from tests.support.small import TEXT, complaint, small_study


def test_values_of_the_file_reach_the_study():
    study = small_study()
    assert (study.name, study.title, study.seed) == ("small", "small", 1)
    assert (study.realizations, study.realizations_per_block, study.blocks) == (16, 4, 4)
    assert (study.material.shear_modulus, study.material.tau, study.surface.length) == (
        1e7,
        1e-3,
        0.01,
    )
    assert study.grid["normal_force"] == (0.04, 0.4)
    assert study.shape == (2, 2, 1, 1, 2, 1)


def test_steady_states_alone_need_no_velocity_step():
    text = TEXT.replace("velocity_step = 0.2", "")
    for quantities in ('["steady"]', '["steady", "model_ratio"]'):
        study = small_study(f"scene.quantities={quantities}", text=text)
        assert study.grid["velocity_step"] == (0.0,)


def test_settings_in_force_are_kept_as_text():
    text = json.loads(small_study("grid.hurst=0.25", scale="wide").text)
    assert text["grid"]["hurst"] == 0.25
    assert text["grid"]["normal_force"] == [0.04, 0.4, 4.0]
    assert "scales" not in text


def test_snapping_moves_the_spacing_to_one_that_divides():
    study = small_study("surface.snap_spacing=true", "grid.spacing=9.9e-5")
    assert round(study.surface.length / study.grid["spacing"][0]) == 100


def measured_study(tmp_path, lines, settings="", **how):
    """Return a study of measured lines that a text file holds."""
    x = np.arange(16)
    heights = 1e-6 * np.sin(2.0 * np.pi * (x[:, None] + np.arange(lines)) / 16.0)
    np.savetxt(tmp_path / "lines.txt", np.c_[1e-5 * x, heights])
    columns = list(range(lines + 1))
    text = f"""
        {settings}
        material = {{shear_modulus = 1e7, relaxation_time = 1e-3}}
        grid = {{normal_force = 0.04, velocity = 0.1, velocity_step = 0.2}}
        surface = {{file = "lines.txt", columns = {columns}, units = ["m", "m"], periodic = "none"}}
    """
    return read_grid_study("measured", tmp_path, tomllib.loads(text), **how)


def test_there_are_as_many_realizations_as_measured_lines(tmp_path):
    study = measured_study(tmp_path, 4)
    assert study.realizations == 4
    assert study.grid["spacing"] == (pytest.approx(1e-5),)
    assert study.grid["roughness"] == (study.surface.profile.roughness,)
    assert math.isnan(study.grid["hurst"][0])
    assert measured_study(tmp_path, 4, "study.realizations = 2").realizations == 2
    with pytest.raises(UserError, match=r"^study\.realizations = 5: only 4 lines were measured; "):
        measured_study(tmp_path, 4, "study.realizations = 5")


def test_one_measured_line_is_a_study_without_standard_errors(tmp_path):
    study = measured_study(tmp_path, 1)
    assert (study.realizations, study.blocks) == (1, 1)
    assert study.surface.description.endswith("has no standard error: errors are unknown")
    with pytest.raises(UserError, match=r"only 1 line was measured; .* \"random-phase\""):
        measured_study(tmp_path, 1, "study.realizations = 4")


def test_correlated_rows_of_a_map_are_used_in_blocks(tmp_path):
    phase = np.arange(128)[:, None] / 40.0  # a wave that turns slowly from row to row
    heights = np.zeros((40, 128))
    for mode in range(1, 9):
        wave = 2.0 * np.pi * mode * np.arange(128) / 128.0
        heights += np.cos(wave + 2.0 * np.pi * np.sin(7.0 * mode + mode * phase[:40]))
    np.save(tmp_path / "map.npy", np.c_[1e-6 * np.arange(128), 1e-7 * heights.T])
    text = """
        material = {shear_modulus = 1e7, relaxation_time = 1e-3}
        grid = {normal_force = 0.04, velocity = 0.1, velocity_step = 0.2}
        surface = {file = "map.npy", columns = COLUMNS, units = ["m", "m"]}
    """.replace("COLUMNS", str(list(range(41))))
    study = read_grid_study("map", tmp_path, tomllib.loads(text))
    correlation = study.surface.profile.correlation
    assert study.realizations_per_block >= correlation.lines > 2.0
    assert f"in blocks of {study.realizations_per_block}" in study.surface.description
    own = "study = {realizations_per_block = 2}\n" + text
    study = read_grid_study("map", tmp_path, tomllib.loads(own))
    assert study.realizations_per_block == 2
    assert f"set study.realizations_per_block = {correlation.block}" in study.surface.description


def test_a_scene_is_a_study_of_one_point():
    tables = tomllib.loads(TEXT.partition("[compare")[0])
    tables["study"] = {}
    tables["grid"] |= {"hurst": 0.7, "normal_force": 0.04, "velocity": 0.1}
    scene = read_grid_study("scene", Path(), copy.deepcopy(tables), one_point=True)
    assert (scene.realizations, scene.blocks) == (1, 1)
    assert set(scene.shape) == {1}
    tables["grid"]["hurst"] = [0.3, 0.7]
    with pytest.raises(UserError, match=r"^grid\.hurst = \[0\.3, 0\.7\]: must be one value"):
        read_grid_study("scene", Path(), tables, one_point=True)


def test_one_line_can_be_asked_for_its_state():
    tables = tomllib.loads(SCENE)
    scene = read_grid_study("scene", Path(), copy.deepcopy(tables), one_point=True)
    assert scene.scene.quantities == ("trace", "snapshots", "state")
    tables["study"] = {"realizations": 2}
    with pytest.raises(UserError, match='"snapshots": needs a single line'):
        read_grid_study("scene", Path(), tables, one_point=True)


SCENE = """
material = {shear_modulus = 1e7, relaxation_time = 1e-3}
surface.length = 0.01
grid = {hurst = 0.7, spacing = 1e-4, roughness = 1e-5, normal_force = 0.04}
scene.quantities = ["state", "snapshots", "trace"]
scene.programme = [{slide = {velocity = 0.1, distance = 1e-3}}]
"""


def test_what_files_were_read_as_is_told_once_each(tmp_path):
    (tmp_path / "v.csv").write_text("time [s], velocity [mm/s]\n0, 100\n1e-3, 200\n")
    (tmp_path / "d.csv").write_text("time [s], indentation [um]\n0, 10\n1e-3, 20\n")
    text = """
        study = {realizations = 4}
        material = {shear_modulus = 1e7, relaxation_time = 1e-3}
        surface = {length = 0.01}
        grid = {hurst = 0.7, spacing = 1e-4, roughness = 1e-5}
        [scene]
        programme = [{file = "v.csv"}, {file = "v.csv"}]
        control = "indentation"
        indentation_file = "d.csv"
        start = "relaxed"
    """
    study = read_grid_study("told", tmp_path, tomllib.loads(text))
    (first, programme), (second, indentation) = study.descriptions
    assert (first, second) == ("programme", "indentation")
    assert "mm/s" in programme
    assert "um" in indentation


@pytest.mark.parametrize(
    ("asked", "block", "found"),
    [(10, 1, (12, 4)), (2, 1, (8, 4)), (200, 10, (204, 12)), (64, 8, (64, 8)), (6, 3, (8, 4))],
)
def test_random_lines_are_counted_in_whole_quartets_and_blocks(asked, block, found):
    study = small_study(f"study.realizations={asked}", f"study.realizations_per_block={block}")
    assert (study.realizations, study.realizations_per_block) == found
    assert study.realizations_requested == asked


def test_below_one_percent_the_march_is_longer_unless_a_horizon_is_given():
    settings = (), ("numerics.accuracy=0.01",), ("numerics.accuracy=0.005",)
    horizons = [small_study(*some).variants[""].horizon for some in settings]
    assert horizons == [4.0, 4.0, 6.0]
    given = small_study("numerics.accuracy=0.005", "numerics.horizon=3")
    assert given.variants[""].horizon == 3.0


def test_comparison_inherits_the_numerics_it_does_not_name():
    coarse = small_study("numerics.horizon=7.0").variants["coarse"]
    assert coarse == Numerics("implicit-euler", 1, 16, 7.0)


BRANCHED = "compare.glassy={branches=[[5e6, 1e-2]], relaxation_time=0}"


def test_a_comparison_has_the_material_of_the_study_but_for_its_keys():
    study = small_study(BRANCHED, 'scene.quantities=["steady"]')
    assert study.materials[""] == study.material == Material(1e7, 1e-3)
    assert study.materials["coarse"] == study.material
    assert study.materials["glassy"] == Material(1e7, 0.0, ((5e6, 1e-2),))
    assert study.variants["glassy"] == study.variants[""]
    assert list(study.materials) == list(study.variants)


def test_branches_and_a_file_of_them_take_each_others_place():
    own = 'material.branches_file="branches.csv"'
    study = small_study(own, "compare.glassy.branches=[[5e6, 1e-2]]")
    assert len(study.material.branches) == 2
    assert len(study.materials["glassy"].branches) == 1
    study = small_study("material.branches=[[5e6, 1e-2]]", f"compare.two.{own[9:]}")
    assert len(study.materials["two"].branches) == 2
    study = small_study(own, "compare.kelvin.branches=[]")
    assert study.materials["kelvin"] == Material(1e7, 1e-3)


MEASURED = without("surface.length", "grid.hurst", "grid.spacing", "grid.roughness")
OWN_LINE = ('surface.file="two.csv"', "surface.columns=[0, 1, 2]", "study.realizations=2")


def test_a_comparison_has_lines_like_the_measured_ones():
    study = small_study(
        *OWN_LINE,
        'compare.spectrum.lines="random-phase"',
        'compare.fractal={lines="self-affine", hurst=0.9}',
        text=MEASURED,
    )
    assert study.surfaces[""] == study.surface
    assert study.surfaces["coarse"].lines == study.surface.lines == "measured"
    assert study.surfaces["spectrum"] == study.surface._replace(lines="random-phase")
    assert study.surfaces["fractal"] == study.surface._replace(lines="self-affine", hurst=0.9)
    assert list(study.surfaces) == list(study.variants)


def test_measured_lines_limit_the_realizations_of_all():
    settings = (*OWN_LINE, 'surface.lines="random-phase"', 'compare.own.lines="measured"')
    answer = complaint(*settings, "study.realizations=4", text=MEASURED)
    assert answer.startswith("study.realizations = 4: only 2 lines were measured; for more lines")
    lines = OWN_LINE[:2]
    assert complaint(*lines, "study.realizations=4", text=MEASURED) == answer


def test_a_walltime_that_is_not_quoted_is_a_time_too():
    assert small_study("cluster.walltime=00:10:00").cluster.walltime == "00:10:00"


def test_walltimes_are_those_of_slurm():
    known = {"90": 5400, "00:02:30": 150, "30:15": 1815, "1-00": 86400, "2-01:30": 178200}
    known["1-02:03:04"] = 93784
    assert {text: walltime_seconds(text) for text in known} == known


def test_a_study_is_computed_here_unless_it_says_otherwise():
    assert Cluster() == THIS_MACHINE == Cluster(where="local")
    assert THIS_MACHINE.longest_batch == float("inf")


def test_every_key_arrives():
    assert Cluster(**checked("cluster", CLUSTER, KEYS)) == Cluster(
        **{key: tuple(v) if isinstance(v, list) else v for key, v in CLUSTER.items()}
    )


def test_batches_are_far_shorter_than_the_life_of_a_worker():
    place = Cluster(**CLUSTER)
    assert place.lifetime == pytest.approx(6480.0)
    assert place.longest_batch == pytest.approx(324.0)
