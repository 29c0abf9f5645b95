"""What a control must provide. A file beside this one holds one control.

A control is a NamedTuple of what it prescribes. The functions declared here are reached by its
type.
"""

from ..compile.jit import dispatch_on_type


@dispatch_on_type
def balance_history(control, c, d, first, rings):
    """Return what ``balance`` needs to know of the step before, or None.

    c, d, first, rings : as the march leaves them at its end (motion/slide.py). They change next.
    """


@dispatch_on_type
def balance(control, law, z, c, noted, d, step):
    """Return (d, passes): the new indentation, and the number of passes over c it took.

    law : of the elastomer (rheology/law.py). z : line, c : contact thresholds before the new d
    is known, both at the samples that are marched; c may be changed. d : the old indentation.
    step : number, from 1 on; what is prescribed may change with it.
    """


@dispatch_on_type.refcount_free
def balance_rows(control, law, rows, d, step):
    """Return the same of elements with internal variables.

    rows : SpringRows (scene/spring_rows.py). They note the highest indentation that was looked at
    on the way.
    """
