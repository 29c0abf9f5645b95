/* What the machine can do. */

/* Two arrays are read, and one of them is written. */
void triad(double *a, const double *b, long n, long times)
{
    for (long t = 0; t < times; t++) {
        for (long j = 0; j < n; j++)
            a[j] = a[j] + 1e-9 * b[j];
        __asm__ volatile("" ::"r"(a) : "memory");
    }
}

/* 128 multiplications and as many additions, all in registers. */
double multiply_adds(long times)
{
    double x[128], sum = 0.0;
    for (int i = 0; i < 128; i++)
        x[i] = i;
    for (long t = 0; t < times; t++)
        for (int i = 0; i < 128; i++)
            x[i] = x[i] * 0.999 + 0.001;
    for (int i = 0; i < 128; i++)
        sum += x[i];
    return sum;
}
