"""Real processes on loopback: several kinds of cluster, and what goes wrong on one."""
