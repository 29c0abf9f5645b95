"""All that a stored number depends on: the work of a worker, from a batch to its block means."""
