"""Elements with internal variables: steady sliding, its friction, and velocity jumps."""
