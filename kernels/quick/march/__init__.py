"""The active-set march: step only the samples whose contact state is undecided.

**Idea.** After a velocity jump few samples change between touching and not touching. The Kelvin
elements slide at constant speed under constant load. Let E be the decay factor of a step and

    a_j = z_j - E z_(j+1),    D(t) = d(t) - E d(t - 1),

the *rise* of the line at sample j and the *advance* of the indentation (``problem``). An element
that arrives at sample j from contact at the upstream sample j + 1 overlaps the line by D - a_j.
While d and D stay within bounds, every sample is of one of three kinds:

- It always touches, and so does the sample upstream. Elements at these n samples overlap the line
  by n D - sum a, so only sums over them are kept (``kinds``).
- It never touches. Samples of this kind form gaps. An element that leaves contact at the upstream
  end of a gap with displacement u arrives at the other end, q samples farther, with E^q u
  (``crossings``).
- It is undecided. Undecided samples form runs. They are listed, and stepped exactly as the plain
  march of model/march.py steps every sample (``active``).

**Bounds.** ``initial_bounds`` guesses the ranges of d and D. The displacements of the two steady
states bound all displacements on the way from one to the other (``problem``). With these bounds one
pass over the line, against the motion, decides the kind of every sample (``kinds``). A few
comparisons decide a span of sixteen samples, so most samples are not visited.

**Fallback.** Every step checks that d and D are inside the bounds. If not, the march starts again
with wider bounds, up to three times (``active``). Then the caller uses the plain march.

**Shorter lists.** As d approaches its final value, narrower bounds hold, and many listed samples
become decided. ``lists`` then makes shorter lists if they save more time than they cost. Some
samples always touch, but lie behind a gap whose upstream end always touches too. Their overlap
depends on the past of d alone, and ``crossings`` sums it. If d or D leaves the narrower bounds, the
march restarts with longer lists, from the step at which these were last in use.
"""
