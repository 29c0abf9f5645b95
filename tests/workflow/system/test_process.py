"""Signals that ask a run to stop."""

import signal

import pytest

from workflow.system.process import Interrupt


def test_first_signal_asks_even_if_it_comes_twice_at_once_and_a_later_one_aborts(clock, capsys):
    handlers = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
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
    assert [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)] == handlers
