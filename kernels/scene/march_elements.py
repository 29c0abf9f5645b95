"""March of all elements of a foundation at rest under a line that moves through a programme.

It supports any material with internal variables, any control and any motion. It is the reference
for march_blocks.py, which supports Prony series only and steps only elements that can touch. Laws,
controls and recorders dispatch on their types: recorders that are not requested are not compiled.
"""

import numpy as np

from ..compile.jit import kernel
from ..model.balance import balance
from ..model.friction import weighted_sums
from ..rheology.law import Elements, advance_memory, displacement, law_of, predict
from .cycles import add_impulses
from .energy import add_energies, record_energies
from .records import count_lengths, record_motion, record_snapshot, record_trace


@kernel
def march_elements(
    form,
    control,
    track,
    elements,
    done,
    recorded,
    frames,
    trace,
    energies,
    lengths,
    snapshots,
    window,
):
    """March elements along a track; return (elements, passes) at its end.

    form : of the material (rheology/law.py). control : determines the indentation (control/).
    track : line at every step (motion/track.py). elements : before the first step; their arrays
    are not changed. done : number of steps before this track.
    recorded : increasing numbers of the steps that trace, energies and lengths record. frames :
    those for snapshots. Each of these recorders may be None. window : AveragingWindow or None.
    passes : over the thresholds, in all steps.
    """
    n = elements.p.size
    memory, p, d = elements.memory.copy(), elements.p.copy(), elements.d
    w, c, new, u = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    passes = 0
    k = first_after(recorded, done)
    frame = first_after(frames, done)
    for s in range(track.dt.size):
        step = done + s + 1
        z = line_at_step(track.z, track, s + 1, n)
        law = law_of(form, track.dt[s])
        predict(law, memory, p, w)
        for i in range(n):
            c[i] = z[i] - w[i]
        old = d
        d, used = balance(control, law, z, c, None, old, step)
        passes += used
        for i in range(n):
            depth = d - c[i]
            new[i] = law.stiffness * depth if depth > 0.0 else 0.0
        if energies is not None:
            add_step_energies(form, law, energies, track, s, memory, p, new, w, old, d)
        if snapshots is not None and frame < frames.size and step == frames[frame]:
            for i in range(n):
                u[i] = w[i] - new[i] / law.stiffness
            record_snapshot(snapshots, frame, z, d, u)
            frame += 1
        advance_memory(law, memory, w, p, new)
        p, new = new, p
        if window is not None and window.after < step <= window.last:
            before = line_at_step(track.slope, track, s, n)
            now = line_at_step(track.slope, track, s + 1, n)
            sums = weighted_sums(-p, None, now + law.lag * (before - now), 0.0)
            add_impulses(window, sums, track.dt[s])
        if k < recorded.size and step == recorded[k]:
            _record_step(k, form, law, track, s, old, d, memory, p, trace, energies, lengths)
            k += 1
    return Elements(memory, p, d), passes


@kernel
def _record_step(k, form, law, track, s, old, d, memory, p, trace, energies, lengths):
    """Record a step in row k; memory, p : at the end of the step."""
    n = p.size
    if trace is not None:
        before = line_at_step(track.slope, track, s, n)
        now = line_at_step(track.slope, track, s + 1, n)
        record_trace(trace, k, law.lag, before, now, old, d, p)
        record_motion(trace, k, law.lag, track, s)
    if energies is not None:
        record_energies(energies, k, form, memory, p)
    if lengths is not None:
        count_lengths(lengths, p)


@kernel
def first_after(numbers, done):
    """Return the index of the first number above ``done``; numbers : increasing."""
    k = 0
    while k < numbers.size and numbers[k] <= done:
        k += 1
    return k


@kernel
def line_at_step(values, track, s, n):
    """Return values of the line at the elements after step s of a track, shape (n,)."""
    begin = track.begin[s]
    return values[track.line[s], begin : begin + n]


@kernel
def add_step_energies(form, law, energies, track, s, memory, p, new, w, old, d):
    """Add the energies of a step with the forces ``new``; memory, p : before the step."""
    n = p.size
    before, after = line_at_step(track.z, track, s, n), line_at_step(track.z, track, s + 1, n)
    u = displacement(form, memory, p)
    work, closing = np.empty(n), np.empty(n)
    for i in range(n):
        work[i] = (before[i] - after[i]) + (d - old)
        old_gap = (before[i] - old) - u[i]
        new_gap = (after[i] - d) - (w[i] - new[i] / law.stiffness)
        closing[i] = old_gap - new_gap
    add_energies(form, law, track.dt[s], memory, p, new, work, closing, energies.sums)
