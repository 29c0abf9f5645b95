"""Interface of controls.

A control is a NamedTuple of prescribed quantities. The functions declared here dispatch on its
type.
"""

from ..compile.jit import dispatch_on_type, dispatch_refcount_free


@dispatch_on_type
def balance_history(control, c, d, first, rings):
    """Return the part of the previous state that ``balance`` needs, or None.

    c, d, first, rings : at the end of the previous step (motion/slide.py), before they change.
    """


@dispatch_on_type
def balance(control, law, z, c, history, d, step):
    """Return (d, passes): the new indentation and the number of passes over c.

    law : of the elastomer (rheology/law.py). z : heights of the line. c : contact thresholds after
    the shift of this step, which may be changed. z and c hold the marched samples only. history :
    from ``balance_history``. d : the old indentation. step : number, from 1 on.
    """


@dispatch_refcount_free
def balance_rows(control, law, rows, d, step):
    """Return (d, passes) for elements with internal variables; see ``balance``.

    rows : SpringRows (quick/blocks/spring_rows.py), which record the highest evaluated d.
    """
