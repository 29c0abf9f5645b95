"""Compiling is announced once, before it begins; nothing is said where nothing is compiled."""

import numba
import pytest

from workflow.system.compiling import LINE, saying_what_compiles


@pytest.mark.skipif(numba.config.DISABLE_JIT, reason="nothing is compiled")
def test_it_is_said_once_and_only_where_something_is_compiled(capsys):
    @numba.njit
    def one(x):
        return x

    with saying_what_compiles():
        assert capsys.readouterr().err == ""
        one(1)
        one(1.0)
        assert capsys.readouterr().err == f"{LINE}\n"
    with saying_what_compiles():
        one(2)
    one(2j)
    assert capsys.readouterr().err == ""
