"""Following a programme: the line moves over a foundation at rest, element by element.

It takes any material with internal variables, any control and any motion, and steps all elements:
the reference of march_blocks.py, which takes Prony series through the same with those elements
alone that can touch. Laws, controls and what is kept are chosen by type: what is not asked for has
left no trace in the machine code.
"""

import numpy as np

from ..compile.jit import kernel
from ..model.balance import balance
from ..model.friction import weighted_sums
from ..rheology.law import Elements, advance_memory, displacement, law_of, predict
from .cycles import add_impulses
from .energy import book, keep_energies
from .records import count_lengths, keep_frame, keep_motion, keep_trace


@kernel
def follow(form, control, track, elements, done, kept, frames, trace, ledger, lengths, film, spell):
    """Take elements along a track; return (elements, passes) at its end.

    form : of the material (rheology/law.py). control : what the indentation follows from
    (control). track : the line at every step (motion/track.py). elements : before the first
    step; their arrays are left alone. done : number of steps before this track.
    kept, frames : increasing numbers of the steps to be kept in trace, ledger and lengths, and
    in film: recorders or None. spell : or None.
    passes : over the thresholds, in all steps.
    """
    n = elements.p.size
    memory, p, d = elements.memory.copy(), elements.p.copy(), elements.d
    w, c, new, u = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    passes = 0
    k = first_after(kept, done)
    frame = first_after(frames, done)
    for s in range(track.dt.size):
        step = done + s + 1
        z = seen_at(track.z, track, s + 1, n)
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
        if ledger is not None:
            book_step(form, law, ledger, track, s, memory, p, new, w, old, d)
        if film is not None and frame < frames.size and step == frames[frame]:
            for i in range(n):
                u[i] = w[i] - new[i] / law.stiffness
            keep_frame(film, frame, z, d, u)
            frame += 1
        advance_memory(law, memory, w, p, new)
        p, new = new, p
        if spell is not None and spell.after < step <= spell.last:
            before, now = seen_at(track.slope, track, s, n), seen_at(track.slope, track, s + 1, n)
            sums = weighted_sums(-p, None, now + law.lag * (before - now), 0.0)
            add_impulses(spell, sums, track.dt[s])
        if k < kept.size and step == kept[k]:
            _keep(k, form, law, track, s, old, d, memory, p, trace, ledger, lengths)
            k += 1
    return Elements(memory, p, d), passes


@kernel
def _keep(k, form, law, track, s, old, d, memory, p, trace, ledger, lengths):
    """Keep a step of which the memory has settled, as number k of those that are kept."""
    n = p.size
    if trace is not None:
        before, now = seen_at(track.slope, track, s, n), seen_at(track.slope, track, s + 1, n)
        keep_trace(trace, k, law.lag, before, now, old, d, p)
        keep_motion(trace, k, law.lag, track, s)
    if ledger is not None:
        keep_energies(ledger, k, form, memory, p)
    if lengths is not None:
        count_lengths(lengths, p)


@kernel
def first_after(numbers, done):
    """Return which of increasing numbers is the first above ``done``."""
    k = 0
    while k < numbers.size and numbers[k] <= done:
        k += 1
    return k


@kernel
def seen_at(values, track, s, n):
    """Return the values of the line at the elements after step s of a track, shape (n,)."""
    begin = track.begin[s]
    return values[track.line[s], begin : begin + n]


@kernel
def book_step(form, law, ledger, track, s, memory, p, new, w, old, d):
    """Book a step whose forces are known and whose memory has not settled."""
    n = p.size
    before, after = seen_at(track.z, track, s, n), seen_at(track.z, track, s + 1, n)
    u = displacement(form, memory, p)
    work, closing = np.empty(n), np.empty(n)
    for i in range(n):
        work[i] = (before[i] - after[i]) + (d - old)
        gap = (before[i] - old) - u[i]
        left = (after[i] - d) - (w[i] - new[i] / law.stiffness)
        closing[i] = gap - left
    book(form, law, track.dt[s], memory, p, new, work, closing, ledger.sums)
