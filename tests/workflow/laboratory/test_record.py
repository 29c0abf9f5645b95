"""Files of a laboratory: columns, units, and refusals that name file and line."""

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.laboratory.record import read_record


def read(tmp_path, text, *arguments, **options):
    path = tmp_path / "r.txt"
    path.write_text(text, encoding="utf-8")
    return read_record(path, *arguments, **options)


@pytest.mark.parametrize(
    ("header", "time", "velocity"),
    [
        ("", 1.0, 1.0),
        ("Zeit [min]; v [µm/s]; mu", 60.0, 1e-6),
        ("Zeit [s];Geschwindigkeit [mm/s];Reibungszahl", 1.0, 1e-3),
        ("Zeit [s];Geschwindigkeit [mm/s];Reibwert [-]", 1.0, 1e-3),
        ("t (s) v (m/s) mu", 1.0, 1.0),
        ("time_ms, velocity_mm_s, friction", 1e-3, 1e-3),
        ("t (us)\tv / mm·s⁻¹\tµ", 1e-6, 1e-3),
        ("Time (h), Speed (km/h), COF", 3600.0, 1.0 / 3.6),
        ("time in s; velocity in mm per s; friction", 1.0, 1e-3),
        ("t [s] v [mm/min] mu", 1.0, 1e-3 / 60.0),
        ("t [s], velocity (microns/s), friction coefficient", 1.0, 1e-6),
        ("mu; v(mm/s); t(s)", 1.0, 1e-3),
    ],
)
def test_units_in_any_form_and_order(tmp_path, header, time, velocity):
    rows = [["0", "0,1", "1,5"], ["1", "0,2", "1,5"]]
    back = -1 if header.startswith("mu") else 1
    text = "\n".join([header, *(";".join(row[::back]) for row in rows)])
    found = read(tmp_path, text)
    assert found.time[1] == pytest.approx(time)
    np.testing.assert_allclose(found.velocity, [0.1 * velocity, 0.2 * velocity])
    np.testing.assert_allclose(found.friction, [1.5, 1.5])
    given = read(tmp_path, text, time="min", velocity="um/s")  # which goes before the header
    assert given.time[1] == pytest.approx(60.0)
    np.testing.assert_allclose(given.velocity, [1e-7, 2e-7])


@pytest.mark.parametrize(
    ("header", "form"),
    [
        ("Time,v [mm/s],mu\n", "10:15:0{}.250,1,0.5\n"),
        ("\ufeffZeit [hh:mm:ss];v [mm/s];mu\r\n", "10:15:0{},250;1,0;0,5\r\n"),
        ("# a logger\nDate Time v mu\n- h:min:s mm/s -\n", "2024-05-01 10:15:0{}.250 1 0.5\n"),
    ],
)
def test_times_of_day_are_seconds(tmp_path, header, form):
    found = read(tmp_path, header + "".join(map(form.format, range(3))))
    np.testing.assert_allclose(found.time, 36900.25 + np.arange(3))
    np.testing.assert_allclose(found.velocity, 1e-3)


def test_a_column_that_the_file_does_not_hold_is_named(tmp_path):
    with pytest.raises(UserError, match="--columns asks for column 7 of"):
        read(tmp_path, "t [s],v [mm/s],mu\n0,1,0.5\n1,2,0.5\n", (0, 7, 2))


def test_two_displacements_are_too_few(tmp_path):
    with pytest.raises(UserError, match="holds 2 rows: a fit needs 3"):
        read(tmp_path, "t [s],x [mm],mu\n0,1,0.5\n1,2,0.5\n")


@pytest.mark.parametrize(
    ("header", "form", "words"),
    [
        ("Time [min],v,mu\n", "10:15:0{},1,0.5\n", "is in 'min', but holds '10:15:00': write sec"),
        ("Time [h:m:s],v,mu\n", "0.{},1,0.5\n", "is in 'h:m:s', but holds '0.0': write seconds"),
        ("Time,v,mu\n", "10:15:0{} PM,1,0.5\n", "0 'Time' holds '10:15:00 PM': write numbers"),
        ("Time,v,mu\n", "15:0{},1,0.5\n", "column 0 'Time' holds '15:00': write numbers"),
    ],
)
def test_unclear_times_of_day_are_refused(tmp_path, header, form, words):
    with pytest.raises(UserError, match=words):
        read(tmp_path, header + "".join(map(form.format, range(3))))


@pytest.mark.parametrize(
    ("title", "words"), [("vdcdt_um", ""), ("velocity_um", "not clear what 'um'")]
)
def test_a_chosen_column_of_lengths_is_a_displacement_unless_named_a_velocity(
    tmp_path, title, words
):
    text = f"time_s,{title},mu\n" + "".join(f"{t},{3 * t},0.3\n" for t in range(20))
    if words:
        with pytest.raises(UserError, match=words):
            read(tmp_path, text, (0, 1, 2))
    else:
        np.testing.assert_allclose(read(tmp_path, text, (0, 1, 2)).velocity, 3e-6)


def test_missing_samples_are_passed_over_and_equal_stamps_spread(tmp_path):
    found = read(tmp_path, "0 1 0.3\n0 1 0.3\n1 1 nan\n1 1 0.3\n2 1 0.3\n2 1 0.3\n")
    np.testing.assert_allclose(found.time, [0.0, 0.5, 1.0, 2.0, 2.5])
    assert "1 value missing" in found.description[0]
    assert found.description[1] == "2 samples have the time of the one before; spread"


@pytest.mark.parametrize(
    ("header", "unit"),
    [("t(s) displacement(um) mu\n", None), ("", "um"), ("t(s) x(um) mu\n", None)],
)
def test_displacements_are_differenced(tmp_path, header, unit):
    rows = "".join(f"{t} {1000 + 3 * t} 0.3\n" for t in range(20))
    found = read(tmp_path, header + rows, displacement=unit)
    np.testing.assert_allclose(found.velocity, 3e-6, rtol=1e-6)
    assert found.velocity.shape == found.time.shape


def test_noise_of_displacements_widens_the_differences_and_is_refused_at_last(tmp_path):
    t = np.arange(200)
    noise = np.random.default_rng(1).standard_normal(200)
    for size, widths in ((0.1, range(2, 6)), (1.0, ())):
        rows = "".join(f"{k} {k + size * n:.4f} 0.3\n" for k, n in zip(t, noise, strict=True))
        if not widths:
            with pytest.raises(UserError, match="smooth them, or give the commanded velocity"):
                read(tmp_path, rows, displacement="um")
            continue
        found = read(tmp_path, rows, displacement="um")
        assert int(found.description[-1].split()[-2]) in widths
        assert found.velocity.std() < 0.1e-6


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        ("0 1 0.3\n1 1 0.3\n2 1 x\n", ": line 3 reads"),
        ("# t\n1 1 0.3\n\n0 1 0.3\n", "line 4 of '"),
        (
            "t [s] v [furlong/s] mu\n0 1 1\n1 1 1\n",
            "the unit 'furlong/s' of a velocity is not known",
        ),
        ("t v1(m/s) v2(m/s) mu\n0 1 1 1\n1 1 1 1\n", "it is not clear which holds"),
        ("1 1 1\n1 1 1\n", "one time stamp, 1 s; must increase"),
        ("nothing\n", "holds no row of numbers"),
    ],
    ids=["a word", "time", "unit", "several", "one time", "no rows"],
)
def test_refusals_name_file_and_line(tmp_path, text, answer):
    with pytest.raises(UserError, match=r"^fit") as error:
        read(tmp_path, text)
    assert answer in str(error.value)
