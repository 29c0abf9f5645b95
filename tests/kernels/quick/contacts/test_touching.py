"""What touches, listed, against the condition of contact sample by sample."""

import numpy as np

from elastomer_friction.kernels.model.friction import _covered
from elastomer_friction.kernels.quick.contacts.samples import samples_per_contact
from elastomer_friction.kernels.quick.contacts.touching import median_width, steepest
from elastomer_friction.kernels.quick.steady.spans import SPAN
from tests.kernels.quick.contacts.listed import Listed, everywhere
from tests.kernels.quick.steady.given import touching


@everywhere
def test_every_touching_sample_is_listed_once_as_far_as_contact_covers_it(given):
    listed = Listed(*given)
    line, (w, d) = listed.line, listed.state
    weight = np.zeros(line.z.size)
    at = {height: j for j, height in enumerate(line.z)}
    for covered, height, slope in zip(*listed.touching[:3], strict=True):
        weight[at[height]] += covered
        assert slope == line.slope[at[height]]
    for b in listed.touching.spans:
        weight[b * SPAN : (b + 1) * SPAN] += 1.0
    expected = np.zeros(line.z.size)
    for j in np.flatnonzero(touching(line.z, w, d)):
        expected[j] = _covered(line.z, line.slope, w, d, listed.speed, j)
    np.testing.assert_allclose(weight, expected, rtol=1e-6, atol=1e-9)


@everywhere
def test_widths_and_slopes_are_those_of_the_samples(given):
    listed = Listed(*given)
    line, (w, d) = listed.line, listed.state
    width = median_width(line.z, d, listed.decay, listed.contacts)
    assert width == samples_per_contact(d - (line.z - w))
    expected = np.abs(line.slope[touching(line.z, w, d)]).max()
    assert steepest(listed.spans, listed.touching) == expected
