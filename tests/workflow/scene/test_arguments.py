"""Arguments become what a TOML file would hold."""

import numpy as np

from elastomer_friction.workflow.scene.call import toml_value


def test_arrays_tuples_and_numbers_of_numpy_become_plain():
    given = {"a": (np.float64(1.5), np.int64(2)), "b": np.array([[1.0, 2.0]]), "c": {"d": "e"}}
    found = toml_value(given)
    assert found == {"a": [1.5, 2], "b": [[1.0, 2.0]], "c": {"d": "e"}}
    assert type(found["a"][1]) is int
