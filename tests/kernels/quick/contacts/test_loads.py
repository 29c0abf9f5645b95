"""Many loads at one speed on a line: each load as if alone; full contact by its criterion."""

import numpy as np

from elastomer_friction.kernels import steady_sliding
from elastomer_friction.kernels.quick.contacts.loads import (
    CONTACT_COLUMN,
    D_COLUMN,
    FULL_COLUMN,
    LOAD_COLUMNS,
    MU_COLUMN,
    SWEEPS_COLUMN,
    WIDTH_COLUMN,
    FrictionOptions,
    LoadTable,
    SpeedThresholds,
    slide_under_loads,
)
from elastomer_friction.kernels.quick.steady.span_sweep import decay_factors
from elastomer_friction.kernels.quick.steady.spans import SPAN
from tests.kernels.quick.steady.given import constants_at, line_of, on_every_line, touching

LOADS = np.geomspace(1e-4, 60.0, 12)


def results_of(line, speed, loads, criterion=True):
    """Return the LoadTable under loads Fbar, with a jump to 1.2 times the speed."""
    law, spans, own = constants_at(line, speed)
    other = constants_at(line, 1.2 * speed)[2]
    if not criterion:
        own, other = (
            thresholds._replace(line_contact=np.inf, line_pressure=np.inf)
            for thresholds in (own, other)
        )
    pressure = np.append(other.pressure, other.line_pressure)[None]
    speeds = SpeedThresholds(speed, own, np.array([1.2 * speed]), pressure)
    options = FrictionOptions(float(line.steps_per_spacing), 0.0, True, False)
    widths = LOAD_COLUMNS, 1, 1, line.z.size // SPAN + 1
    results = LoadTable(*(np.full((loads.size, width), np.nan) for width in widths))
    problem = decay_factors(law), line.z, line.slope, spans, speeds, loads * line.z.size
    slide_under_loads(*problem, options, results)
    return results


@on_every_line
def test_loads_are_independent_and_contact_is_full_if_all_samples_touch(hurst, elements, m, speed):
    line = line_of(hurst, elements, m)
    table, jumps, rates, entered = results_of(line, speed, LOADS)
    above = np.append(np.arange(SPAN, line.z.size, SPAN), 0)
    for i, load in enumerate(LOADS):
        alone, jump, rate, enter = results_of(line, speed, LOADS[i : i + 1])
        np.testing.assert_array_equal(alone[0], table[i])
        np.testing.assert_array_equal(jump[0], jumps[i])
        np.testing.assert_array_equal(rate[0], rates[i])
        np.testing.assert_array_equal(enter[0][: above.size], entered[i][: above.size])
        (w, d), _ = steady_sliding(constants_at(line, speed)[0], line.z, load * line.z.size)
        assert (table[i, FULL_COLUMN] == 1.0) == touching(line.z, w, d).all()
        assert (table[i, SWEEPS_COLUMN] == 0.0) == (table[i, FULL_COLUMN] == 1.0)
        upstream = np.minimum(w, line.z - d)[above]
        np.testing.assert_allclose(entered[i][: above.size], upstream, rtol=1e-9, atol=1e-150)


def test_the_closed_form_of_full_contact_equals_the_general_path():
    """The general path runs when the criterion is never met."""
    line = line_of(0.7, 100, 4)
    closed, general = results_of(line, 2.0, LOADS), results_of(line, 2.0, LOADS, criterion=False)
    full = closed[0][:, FULL_COLUMN] == 1.0
    assert full.any()
    assert not general[0][:, FULL_COLUMN].any()
    for column in (D_COLUMN, MU_COLUMN, CONTACT_COLUMN, WIDTH_COLUMN):
        np.testing.assert_allclose(general[0][:, column], closed[0][:, column], rtol=1e-12)
    np.testing.assert_allclose(general[1], closed[1], rtol=1e-12, atol=1e-14)
