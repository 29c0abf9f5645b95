"""Headers as people and instruments write them: a unit is obeyed, or the file is refused."""

import itertools
import random

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError, decoded
from elastomer_friction.workflow.study import ColumnSpec, select_columns
from elastomer_friction.workflow.text_tables import TextTable, unit_of
from elastomer_friction.workflow.text_tables.headers import title_of

WANTED = (
    ColumnSpec("a time", "time", r"time|^t$", "s"),
    ColumnSpec("a velocity", "velocity", r"vel|speed|^v([_ ]|$)", "m/s"),
    ColumnSpec("a coefficient of friction", "number", r"fric|^(mu|\u00b5)([_ ]|$)|cof", "1"),
)
NAMES = (("t", "Time", "Test time"), ("v", "Slide velocity", "speed"), ("mu", "COF", "Friction"))
UNITS = (
    {"s": 1.0, "ms": 1e-3, "min": 60.0, "seconds": 1.0},
    {"m/s": 1.0, "\u00b5m/s": 1e-6, "mm per s": 1e-3, "MM/S": 1e-3, "mm\u00b7s\u207b\u00b9": 1e-3},
    {"1": 1.0, "-": 1.0, "%": 0.01},
)
UNKNOWN = ("foo", "counts", "V", "a.u.", "lsb")
STYLES = (
    *("{n} [{u}]", "{n} ({u})", "{n}({u})", "{n}/{u}", "{n} / {u}", "{n}, {u}", "{n} in {u}"),
    *("{n}_{u}", "{n} {u}", "{n}.{u}", "{n}. {u}", "{n}-{u}", "{n} - {u}", "{n}: {u}", "{n} <{u}>"),
)
DELIMITERS = (";", "\t", " | ", "  ", " ")
ROWS = np.array([[0.0, 1.0, 0.5], [0.5, 1.0, 0.51], [1.5, 2.0, 0.53], [2.5, 2.0, 0.52]])


def header(names, units, style, delimiter):
    """Return lines of titles: in one line, or units below or above the names."""
    if style in ("below", "above"):
        lines = [delimiter.join(names), delimiter.join(units)]
        return lines if style == "below" else lines[::-1]
    pairs = zip(names, units, strict=True)
    return [delimiter.join(style.format(n=name, u=unit) for name, unit in pairs)]


@pytest.mark.parametrize("style", [*STYLES, "below", "above"])
def test_units_are_obeyed_or_refused(style):
    chance, right = random.Random(style), 0
    for comment, delimiter, _ in itertools.product(("", "# ", "%"), DELIMITERS, range(4)):
        order = chance.sample(range(3), 3)
        names = [chance.choice(NAMES[n]) for n in order]
        units = [chance.choice(list(UNITS[n])) for n in order]
        factors = np.array([UNITS[n][unit] for n, unit in zip(order, units, strict=True)])
        unknown = chance.random() < 0.2
        if unknown:
            units[order.index(chance.randrange(2))] = chance.choice(UNKNOWN)
        lines = [comment + line for line in header(names, units, style, delimiter)]
        lines += [delimiter.join(f"{cell:.9g}" for cell in row) for row in ROWS[:, order] / factors]
        text = "Operator: B. Test\nCutoff 0.8 mm\n" + "\n".join(lines)
        try:
            found = select_columns(TextTable("key", "f.txt", decoded(text.encode())), WANTED)
        except UserError:
            continue
        assert not unknown, text
        right += 1
        values = np.transpose([one.values for one in found])
        np.testing.assert_allclose(values, ROWS, rtol=1e-7, err_msg=text)
    assert right >= 24  # of about 48 that a person would read


@pytest.mark.parametrize("line", ["%v. lsb mu. 1 t. s", "#mu: 1 v: V t: s", "! t, s v, foo mu"])
def test_a_commented_header_that_no_pattern_divides_is_refused(line):
    with pytest.raises(UserError, match="not clear"):
        select_columns(TextTable("key", "f.txt", f"{line}\n1 2 3\n2 3 4\n"), WANTED)


def test_a_quotient_in_a_name_is_no_unit():
    share = ColumnSpec("a share", "number", r"/ ?G_?0", "1")
    table = TextTable("key", "f.txt", "G_i/G_0,t\n0.5,1\n0.2,2\n")
    assert select_columns(table, (share, WANTED[0]))[0].number == 0


def test_units_of_a_letter_below_names():
    wanted = (
        ColumnSpec("a temperature", "temperature", "^T$", "°C"),
        ColumnSpec("log a_T", "number", "log", "1"),
    )
    found = select_columns(
        TextTable("key", "f.txt", "T,log_aT\nC, -\n100,-11.7\n92,-10.9\n"), wanted
    )
    assert [one.values.tolist() for one in found] == [[373.15, 365.15], [-11.7, -10.9]]


@pytest.mark.parametrize("units", ["1  min  1  mm/s", "# 1 min 1 mm/s", "- min - mm/s", "min mm/s"])
def test_a_row_of_fewer_units_than_columns_is_refused(units):
    """In it 1 is a unit, and no number that stands before one."""
    rows = "\n".join(f"{n} {0.1 * n} 0.5 1.0 23.{n}" for n in range(9))
    text = f"index  time  friction  velocity  temperature\n{units}\n{rows}"
    with pytest.raises(UserError, match=r"column 1 'time': it is not clear what '.*min"):
        select_columns(TextTable("key", "f.txt", text), WANTED)


@pytest.mark.parametrize(
    ("header", "row", "time"),
    [
        ("mu\tt\tNo.\tx\tvel\tM\n%\tms\t1\t\tmm/s\tN m", "50\t100\t1\t0\t1000\t0.5", 0.1),
        ("-  mm/s  -    s  mN m\nindex  v  COF  Fn  t  M", "0  1000  0.5  10  100  0.5", None),
        ("T []\ttime (t)\tv [m/s]\tt0 [ms]\tmu [-]", "23\t100\t1\t7\t0.5", None),
        ("time,mu,v\na.u.,%", "100,50,1", None),
        ("v-m/s;time-s;No.--;µ-1", "1;100;7;0.5", None),
        ("t s, v µm/s, share %, # -", "0.1, 1e6, 50, 1", None),
    ],
)
def test_what_stands_between_units_shifts_none(header, row, time):
    """An empty cell, a torque of two words, fewer units than columns, and a unit of a number."""
    text = f"{header}\n" + "\n".join([row] * 4)
    if time is None:
        with pytest.raises(UserError, match=r"not clear|not known"):
            select_columns(TextTable("key", "f.txt", text), WANTED)
    else:
        found = select_columns(TextTable("key", "f.txt", text), WANTED)
        assert [one.values[0] for one in found] == pytest.approx([time, 1.0, 0.5])


@pytest.mark.parametrize(
    "line",
    [
        '"x" "z"',
        "Test time  v [mm/s]",
        "x [mm] | z [um]",
        "x [mm]; z [um]",
        "x [mm], z [um]",
        "Raw x [mm] Raw z [um]",
        "x [mm] z_um",
    ],
)
def test_a_line_is_divided_into_two_titles(line):
    titles = TextTable("key", "f.txt", f"{line}\n1 2\n2 3\n3 4\n").titles
    assert len(titles) == 2
    assert all(title.name for title in titles)


@pytest.mark.parametrize(
    ("text", "stated"),
    [
        *((text, True) for text in ("t / s", "x in mm", "Fx, N", "v - mm/s", "v.mm/s")),
        ("Lateral um", False),
        ("velocity_mm_s", False),
    ],
)
def test_a_title_has_a_known_unit(text, stated):
    title = title_of(text)
    assert title.name
    assert unit_of(title.unit)
    assert title.stated == stated


@pytest.mark.parametrize("header", ["# t v mu", "#  t [s]  v [m/s]  mu", "# t v mu\n- s m/s 1"])
def test_a_number_sign_may_be_the_name_of_the_first_column(header):
    rows = "".join(f"{n} {n / 10} 1 0.5\n" for n in range(4))
    found = select_columns(TextTable("key", "f.txt", f"{header}\n{rows}"), WANTED)
    assert [one.number for one in found] == [1, 2, 3]


def test_a_line_that_two_patterns_divide_differently_is_refused():
    """Either two blanks or a bar may separate two titles of this line."""
    text = "Test  time | speed | friction  [1]\n0 1 0.5\n1 1 0.5\n2 1 0.5\n"
    assert not TextTable("key", "f.txt", text).titles
    with pytest.raises(UserError, match="not clear"):
        select_columns(TextTable("key", "f.txt", text), WANTED)
