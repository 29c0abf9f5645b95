"""Elements with internal variables: their steady sliding, its friction, and velocity jumps."""
