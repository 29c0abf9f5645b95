"""Constant normal force, eq. 4 of Li et al. (2014), doi:10.1038/srep05795."""

from typing import NamedTuple

from .balance import balance, balance_history, balance_rows
from .contact import indentation_under, solve_indentation


class ConstantForce(NamedTuple):
    """Control that keeps the normal force constant."""

    load: float  # sum of the forces of all elements, n Fbar


@balance_history.register(ConstantForce)
def _no_history(control, c, d, first, rings):
    return None


@balance.register(ConstantForce)
def _balance(control, law, z, c, history, d, step):
    return solve_indentation(c, control.load / law.stiffness, d)


@balance_rows.register(ConstantForce)
def _balance_rows(control, law, rows, d, step):
    return indentation_under(rows, control.load / law.stiffness, d)
