"""March of a body through a programme: the driver of a prescribed motion, and its recorders.

It takes any body (body/step.py), material, control and motion. It is compiled for a line, and runs
as plain Python for a map. Recorders that are not requested are not compiled.
"""

import numpy as np

from ..body.step import (
    Forces,
    Move,
    accept,
    attempt,
    elements_of,
    end_leg,
    forces,
    law_in_step,
    patch_width,
)
from ..compile.jit import jitable, kernel
from .cycles import add_impulses
from .energy import add_step_energies, record_energies
from .records import count_lengths, record_motion, record_snapshot, record_trace


@jitable
def march_track(
    body, state, track, done, ends, recorded, frames, trace, energies, lengths, snapshots, window
):
    """March a body along a track; return its state.

    body : its arrays are changed. track : motion at every step, with the fields dt, place and time
    of a Track (motion/track.py). done : number of steps before this track. ends, recorded, frames :
    increasing step numbers: the last step of each leg, the steps that trace, energies and lengths
    record, and those that snapshots record. trace, energies, lengths, snapshots : recorders, or
    None. window : AveragingWindow or None.
    """
    k, frame, end = first_after(recorded, done), first_after(frames, done), first_after(ends, done)
    durations, dt = track.dt, track.dt[0]
    law, acting = law_in_step(body, state, dt), Forces(np.nan, 0.0, 0.0, 0.0)
    for s in range(durations.size):
        number = done + s + 1
        if durations[s] != dt:
            dt = durations[s]
            law = law_in_step(body, state, dt)
        step = Move(s, s + 1, number, True, dt)
        if energies is not None:
            before = elements_of(body, state)
        state = attempt(body, state, law, step)
        is_recorded = k < recorded.size and number == recorded[k]
        is_averaged = window is not None and window.after < number <= window.last
        if is_averaged or is_recorded:
            acting = forces(body, state, law, step)
        state = accept(body, state, law)
        if energies is not None:
            add_step_energies(body, law, energies, step, dt, before, elements_of(body, state))
        if snapshots is not None and frame < frames.size and number == frames[frame]:
            record_snapshot(snapshots, frame, body, state, step.after)
            frame += 1
        if is_averaged:
            add_impulses(window, acting, dt)
        if is_recorded:
            if trace is not None:
                width = patch_width(body, state)
                record_trace(trace, k, law.lag, acting, state.old_d, state.d, width)
                record_motion(trace, k, law.lag, track, s)
            if energies is not None:
                record_energies(energies, k, body.form, elements_of(body, state))
            if lengths is not None:
                count_lengths(lengths, elements_of(body, state).p)
            k += 1
        if end < ends.size and number == ends[end]:
            state = end_leg(body, state)
            end += 1
    return state


march_line = kernel(march_track)


@kernel
def first_after(numbers, done):
    """Return the index of the first number above ``done``; numbers : increasing."""
    return np.searchsorted(numbers, done, side="right")
