"""Tools that one runs by hand: benchmarks, fuzzing, chaos, intervals of confidence, mutation."""
