/* Scenes in C, with every element in every step: one pass completes the last step of all units and
 * predicts the next one, then the load is balanced. Elements are fixed, and the line moves
 * (kernels/motion/track.py). */
#include <math.h>

enum { CHUNK = 256 }; /* samples whose sums stay in the first cache */

/* Solve sum max(0, d - c) = target by Newton's method, from a guess d. */
static double threshold(const double *c, long n, double target, double d)
{
    double before = -1.0;
    for (int pass = 0; pass < 100; pass++) {
        double total = 0.0, count = 0.0, lowest = c[0];
        for (long j = 0; j < n; j++) {
            double p = d - c[j];
            total += p > 0.0 ? p : 0.0;
            count += p > 0.0 ? 1.0 : 0.0;
        }
        if (count == 0.0) {
            for (long j = 1; j < n; j++)
                lowest = c[j] < lowest ? c[j] : lowest;
            d = lowest + target;
            continue;
        }
        double new = d - (total - target) / count;
        if (pass && (count == before || !(new < d)))
            return new;
        before = count;
        d = new;
    }
    return d;
}

/* Weights of the force at the end and at the start of a step; returns the share that a unit relaxes. */
static double moments(double x, double *end, double *start)
{
    double gone = -expm1(-x), term = x, beta = 0.0, alpha = 0.0;
    if (x > 0.1) {
        *end = 1.0 - gone / x;
        *start = gone / x - (1.0 - gone);
        return gone;
    }
    for (int power = 1; power < 12; power++) {
        term /= power + 1.0;
        beta += term;
        alpha += power * term;
        term *= -x;
    }
    *end = beta;
    *start = alpha;
    return gone;
}

/* E, B, A of every unit for a step of length dt, and the lag (rheology/prony.py); returns the stiffness. */
static double law_of(long K, double glass, const double *J, const double *times, double dt, double *E, double *B,
                     double *A, double *lag)
{
    double late[K], moved[K], ramp = 0.0, prompt = glass, most = 0.0, sum = glass, all = glass;
    for (long k = 0; k < K; k++) {
        double end, start, gone = moments(dt / times[k], &end, &start);
        E[k] = 1.0 - gone;
        B[k] = J[k] * end;
        A[k] = J[k] * start;
        moved[k] = J[k] * gone;
        late[k] = start / gone;
        ramp += A[k];
        all += moved[k];
        most = late[k] > most ? late[k] : most;
    }
    for (long k = 0; k < K; k++)
        prompt += moved[k] * (1.0 - late[k] / most);
    double linear = 4.0 * prompt < ramp ? 4.0 * prompt / ramp : 1.0;
    for (long k = 0; k < K; k++) {
        B[k] += (1.0 - linear) * A[k];
        A[k] *= linear;
        sum += B[k];
    }
    *lag = (1.0 - linear) * ramp / all;
    return 1.0 / sum;
}

/* Median, weighted by load, of the width of contact patches in samples (kernels/scene/samples.py).
 * carried: by patches of each width, (n + 1), all zero before and after. */
static double patch_width(const double *p, long n, double *carried)
{
    long start = 0, run = 0, widest = 0, median = 0;
    double load = 0.0, total = 0.0, below = 0.0;
    while (start < n && p[start] > 0.0)
        start++;
    if (start == n)
        return n;
    for (long k = start + 1; k <= start + n; k++) {
        double force = p[k < n ? k : k - n];
        if (force > 0.0) {
            run++;
            load += force;
        } else if (run) {
            carried[run] += load;
            total += load;
            widest = run > widest ? run : widest;
            run = 0;
            load = 0.0;
        }
    }
    for (long wide = 1; wide <= widest; wide++) {
        below += carried[wide];
        carried[wide] = 0.0;
        if (!median && 2.0 * below >= total)
            median = wide;
    }
    return median;
}

/* Step elements along a track. z2, slope2: two periods of every line, (lines, 2 n). load: n Fbar.
 * memory: (K, n), p: (n), changed; older, c: room, (n); carried: of patch_width.
 * values: a Trace (kernels/scene/records.py), (9, keeps). Returns the last d. */
double follow(long n, long K, double glass, const double *J, const double *times, const double *z2, const double *slope2,
            const long *line, const long *begin, const double *dt, const double *place, const double *time, long steps,
            double load, double d, double *memory, double *p, double *older, double *c,
            double *carried, const long *kept, long keeps, double *values)
{
    double E[K], B[K], A[K], decay[K], fresh[K], stale[K], lag = 0.0, stiffness = 1.0, w[CHUNK];
    for (long k = 0; k < K; k++)
        decay[k] = 1.0, fresh[k] = stale[k] = 0.0; /* no step to complete yet */
    for (long s = 0, at = 0; s < steps; s++) {
        if (s == 0 || dt[s] != dt[s - 1])
            stiffness = law_of(K, glass, J, times, dt[s], E, B, A, &lag);
        double now = 0.0;
        for (long k = 0; k < K; k++)
            now += A[k];
        const double *z = z2 + line[s + 1] * 2 * n + begin[s + 1];
        for (long first = 0; first < n; first += CHUNK) {
            long size = n - first < CHUNK ? n - first : CHUNK;
            double *restrict new = p + first, *restrict old = older + first, *restrict to = c + first;
            for (long j = 0; j < size; j++)
                w[j] = -now * new[j];
            for (long k = 0; k < K; k++) {
                double *restrict y = memory + k * n + first, e = decay[k], b = fresh[k], a = stale[k], share = E[k];
                for (long j = 0; j < size; j++) {
                    double settled = e * y[j] - b * new[j] - a * old[j];
                    y[j] = settled;
                    w[j] += share * settled;
                }
            }
            for (long j = 0; j < size; j++)
                to[j] = z[first + j] - w[j];
        }
        double before = d;
        d = threshold(c, n, load / stiffness, d);
        double *turn = p;
        p = older;
        older = turn;
        for (long j = 0; j < n; j++)
            p[j] = d > c[j] ? stiffness * (d - c[j]) : 0.0;
        for (long k = 0; k < K; k++)
            decay[k] = E[k], fresh[k] = B[k], stale[k] = A[k];
        if (at < keeps && kept[at] == s + 1) {
            const double *behind = slope2 + line[s] * 2 * n + begin[s];
            const double *ahead = slope2 + line[s + 1] * 2 * n + begin[s + 1];
            double total = 0.0, drag = 0.0, touching = 0.0, moved = place[s + 1] - place[s], *value = values + at++;
            for (long j = 0; j < n; j++) {
                total += p[j];
                drag += p[j] * (ahead[j] + lag * (behind[j] - ahead[j]));
                touching += p[j] > 0.0 ? 1.0 : 0.0;
            }
            double width = patch_width(p, n, carried);
            double of_trace[9] = {drag / total, d + lag * (before - d), total / n, drag / n, touching / n, width,
                time[s + 1] - lag * dt[s], place[s + 1] - lag * moved, moved / dt[s]};
            for (int i = 0; i < 9; i++)
                value[i * keeps] = of_trace[i];
        }
    }
    return d;
}
