"""Signals that ask a run to stop."""

import signal

import pytest

from workflow.system.process import Interrupt


def test_first_signal_asks_even_if_it_comes_twice_at_once_and_a_later_one_aborts(clock, capsys):
    numbers = signal.SIGINT, signal.SIGTERM, signal.SIGHUP
    handlers = [signal.getsignal(number) for number in numbers]
    with Interrupt() as interrupt:
        assert not interrupt()
        signal.raise_signal(signal.SIGTERM)
        clock[0] += 0.01
        signal.raise_signal(signal.SIGINT)
        assert interrupt()
        clock[0] += 10.0
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert capsys.readouterr().err.count("\n") == 1
    assert [signal.getsignal(number) for number in numbers] == handlers


def test_a_terminal_that_hangs_up_asks_too_unless_nohup_ignores_it(capsys):
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)  # the tests may run under nohup
    try:
        with Interrupt() as interrupt:
            signal.raise_signal(signal.SIGHUP)
            assert interrupt()
        signal.signal(signal.SIGHUP, signal.SIG_IGN)
        with Interrupt() as interrupt:
            signal.raise_signal(signal.SIGHUP)
            assert not interrupt()
    finally:
        signal.signal(signal.SIGHUP, before)
    assert "stopping" in capsys.readouterr().err
