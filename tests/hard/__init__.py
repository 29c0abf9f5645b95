"""Hard cases: corners of the parameter space, hard data, bad input, damaged files."""
