"""Where the elements are that fly to the runs: at the start of a march, and later on."""

from kernels.active.flights import powers_of
from kernels.jit import kernel
from kernels.rheology.law import NEGLIGIBLE


@kernel
def aloft_at_first(setting, lists, runs, steps, w):
    """Fill in w, shape (n,), the displacements of all elements on their way to the runs at v1.

    No sample between touches, so that they decay from where they left. steps : to come; who would
    arrive later is left out.
    """
    n, start = setting.z.size, setting.start
    for r in range(runs.top.size):
        top, q = runs.top[r], runs.distance[r]
        source = top + q - (n if top + q >= n else 0)
        if runs.sure[r]:
            u = setting.z[source] - start.d
        else:
            i = lists.first[r - 1 if r > 0 else runs.top.size - 1]
            u = lists.z[i] - max(lists.c[i], start.d)
            w[source] = lists.z[i] - lists.c[i]
        k = min(q - 1, steps)
        u *= start.decay.once ** float(q - k)
        while k > 0:
            u = u if u < -NEGLIGIBLE else 0.0
            j = top + k
            w[j - n if j >= n else j] = u
            u *= start.decay.once
            k -= 1


@kernel
def aloft(law, lists, runs, flights, d, w, steps):
    """Fill in w, shape (n,), the displacements of all elements in runs and on their way to them.

    d : indentation now. steps : still to come; who would arrive later is left out.
    """
    powers = powers_of(law.decay, steps)
    f = 0
    for r in range(runs.top.size):
        if not (runs.sure[r] and runs.distance[r] == 1):
            begin, end, place = flights.begin[f], flights.begin[f + 1], flights.place[f]
            for k in range(1, min(runs.distance[r], powers.size - 1) + 1):
                j = runs.top[r] + k
                arrival = flights.values[place]
                w[j - w.size if j >= w.size else j] = arrival / powers[k] if arrival else 0.0
                place += 1
                if place == end:
                    place = begin if flights.round[f] else end - 1
            f += 1
    for r in range(runs.top.size):
        for i in range(lists.first[r], lists.first[r + 1]):
            w[runs.bottom[r] + i - lists.first[r]] = lists.z[i] - max(lists.c[i], d)
