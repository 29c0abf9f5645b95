/* The same kernels in C, with every element in every step, for comparison in `make bench`.
 * Built with -O3 -march=native -ffast-math, so that loops over elements are vectorised.
 * Kelvin elements under one line, in the frame of the line: elements move from sample j + 1 to j.
 */
#include <math.h>
#include <stdlib.h>

/* Free displacements w of steady sliding at indentation d; returns the sum of overlaps. */
static double sweep(const double *z, double *w, long n, long deepest, double E, double d, double *slope)
{
    double u = z[deepest] - d, du = 1.0, total = 0.0, s = 0.0;
    for (long k = 1; k <= n; k++) {
        long j = deepest - k < 0 ? deepest - k + n : deepest - k;
        double free = u < -1e-300 ? E * u : 0.0, gap = z[j] - d;
        du = du > 1e-300 ? E * du : 0.0;
        w[j] = free;
        if (gap < free) {
            total += free - gap;
            s += 1.0 - du;
            u = gap;
            du = 1.0;
        } else
            u = free;
    }
    *slope = s;
    return total;
}

static double overlap(const double *z, const double *w, long n, double d, double *count)
{
    double total = 0.0, number = 0.0;
    for (long j = 0; j < n; j++) {
        double p = d - z[j] + w[j];
        total += p > 0.0 ? p : 0.0;
        number += p > 0.0 ? 1.0 : 0.0;
    }
    *count = number;
    return total;
}

/* Solve sum max(0, d - z + w) = target by Newton's method, from a guess d. */
static double balance(const double *z, const double *w, long n, double target, double d)
{
    double before = -1.0;
    for (int pass = 0; pass < 100; pass++) {
        double count, total = overlap(z, w, n, d, &count);
        if (count == 0.0) {
            d += target;
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

double steady(const double *z, double *w, long n, double E, double K, double load)
{
    long deepest = 0;
    for (long j = 1; j < n; j++)
        if (z[j] < z[deepest])
            deepest = j;
    for (long j = 0; j < n; j++)
        w[j] = 0.0;
    double d = balance(z, w, n, load, z[deepest] + load / n), slope;
    for (int pass = 0; pass < 100; pass++) {
        double excess = K * sweep(z, w, n, deepest, E, d, &slope) - load, new = d - excess / (K * slope);
        if (!(excess > 4e-16 * load && new < d))
            break;
        d = new;
    }
    return d;
}

/* Friction at an instant (eq. 5): p = (d - z) + v z' + rate over p > 0, without edges. */
double friction(const double *z, const double *slope, const double *w, long n, double d, double v, double load)
{
    double *c = malloc(n * sizeof *c), *g = malloc(n * sizeof *g);
    long m = 0;
    for (long j = 0; j < n; j++)
        if (z[j] - w[j] < d) {
            c[m] = z[j] - d - v * slope[j];
            g[m++] = slope[j];
        }
    double rate = -1e300;
    for (long j = 0; j < m; j++)
        rate = c[j] > rate ? c[j] : rate;
    double before = -1.0, drag = 0.0;
    for (int pass = 0; pass < 100; pass++) {
        double total = 0.0, count = 0.0;
        for (long j = 0; j < m; j++) {
            double p = rate - c[j];
            total += p > 0.0 ? p : 0.0;
            count += p > 0.0 ? 1.0 : 0.0;
        }
        double new = rate - (total - load) / count;
        if (count == before)
            break;
        before = count;
        rate = new;
    }
    for (long j = 0; j < m; j++)
        drag += rate > c[j] ? (rate - c[j]) * g[j] : 0.0;
    free(c);
    free(g);
    return drag / load;
}

/* March from (w, d), every element in every step; mu is the mean over each step, shape (steps,). */
double march(const double *z, const double *weight, double *w, long n, double d, double E, double K, double load,
             long steps, double *mu)
{
    for (long step = 0; step < steps; step++) {
        double first = w[0] < z[0] - d ? w[0] : z[0] - d;
        for (long j = 0; j < n - 1; j++) {
            double u = z[j + 1] - d;
            w[j] = E * (w[j + 1] < u ? w[j + 1] : u);
        }
        w[n - 1] = E * first;
        d = balance(z, w, n, load / K, d);
        double total = 0.0, drag = 0.0;
        for (long j = 0; j < n; j++) {
            double p = d - z[j] + w[j];
            total += p > 0.0 ? p : 0.0;
            drag += p > 0.0 ? p * weight[j] : 0.0;
        }
        mu[step] = drag / total;
    }
    return d;
}
