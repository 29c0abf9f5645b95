"""The active-set march: only elements of which it is open whether they touch are stepped.

Kelvin elements, sliding at constant speed under constant load. Let E be the decay of a step and

    a_j = z_j - E z_(j+1),    D(t) = d(t) - E d(t - 1).

An element that comes to sample j from contact at j + 1 overlaps the line there by D - a_j. While
d and D keep within bounds most samples either touch all the time, and carry n D - sum a, or
never. The march is that of kernels/model/march.py, and falls back on it.
"""
