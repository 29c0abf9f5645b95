"""What crosses a gap arrives decayed, and what is forgotten is zero."""

import numpy as np

from kernels.active.flights import FORGOTTEN, powers_of


def test_powers_end_at_the_last_step_or_where_all_is_forgotten():
    np.testing.assert_allclose(powers_of(0.5, 4), 0.5 ** np.arange(5), rtol=1e-15)
    few = powers_of(1e-8, 1000)
    assert few.size == 5
    assert few[-1] == 0.0
    assert few[-2] > FORGOTTEN
    assert (powers_of(0.0, 3) == [1.0, 0.0]).all()
