"""Compiling is announced once, before it begins; nothing is said where nothing is compiled."""

import numba
import pytest
from numba.core import event

from elastomer_friction.workflow.system.compiling import FILE, WAITING, saying_what_compiles

pytestmark = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")


@pytest.fixture
def saying(tmp_path):
    """Return what says it; times are kept in a folder of the test."""
    return lambda: saying_what_compiles("a toy", "1 to 2 s", str(tmp_path / "code"), "waiting")


def compile_one():
    """Compile a kernel, for two types."""
    one = numba.njit(lambda x: x)
    one(1)
    one(1.0)


def test_it_is_said_once_and_only_where_something_is_compiled(saying, capsys):
    with saying():
        assert capsys.readouterr().err == ""
        compile_one()
        assert capsys.readouterr().err == "Compiling a toy, 1 to 2 s, once.\n"
    with saying():
        pass
    compile_one()
    assert capsys.readouterr().err == ""


def test_what_it_took_on_this_machine_is_said_the_next_time(saying, tmp_path, capsys):
    with saying():
        compile_one()
    capsys.readouterr()
    (tmp_path / FILE).write_text('{"a toy": 12.4, "another": 3}')
    with saying():
        compile_one()
    assert capsys.readouterr().err == "Compiling a toy, about 12 s, once.\n"
    with saying():
        compile_one()
    assert capsys.readouterr().err == "Compiling a toy, about 1 s, once.\n"


@pytest.mark.parametrize("damage", ["", "[]", "null", '{"a toy": "long"}', "\xff"])
def test_a_damaged_note_is_none(saying, tmp_path, capsys, damage):
    (tmp_path / FILE).write_text(damage, encoding="latin-1")
    with saying():
        compile_one()
    assert capsys.readouterr().err == "Compiling a toy, 1 to 2 s, once.\n"


def test_waiting_for_another_process_is_said_unless_this_one_compiles_too(saying, capsys):
    with saying():
        for _ in range(2):
            with event.trigger_event("waiting"):
                pass
        assert capsys.readouterr().err == f"{WAITING}\n"
        compile_one()  # as that process did not
        assert capsys.readouterr().err == "Compiling a toy, 1 to 2 s, once.\n"
        with event.trigger_event("waiting"):
            pass
    assert capsys.readouterr().err == ""


def test_where_no_note_can_be_kept_nothing_else_is_lost(tmp_path, capsys):
    with saying_what_compiles("a toy", "1 to 2 s", str(tmp_path / "no" / "where"), "waiting"):
        compile_one()
    assert capsys.readouterr().err == "Compiling a toy, 1 to 2 s, once.\n"
