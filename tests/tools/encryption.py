"""What encryption costs: CPU time of scheduling a batch with TLS over that without, in turns.

    python -m tests.tools.encryption

Two clusters of two worker processes, one with certificates and one without, are given the same
tasks that take no time. Counted is the CPU time of the driver with its scheduler, and of the
workers; what a connection costs once is paid before.
"""

import time
from statistics import median
from typing import Any

from distributed import Client, LocalCluster

from elastomer_friction.workflow.cluster.security import own_security

ROUNDS, WINDOWS, WINDOW = 9, 20, 8  # as many tasks at a time as a stream of two workers has
SIZES = {"of nothing": 0, "of 100 kB each way": 100_000, "of 1 MB each way": 1_000_000}


def echo(item: bytes) -> bytes:
    """Stand in for a batch: return what was sent."""
    return item


def cpu_time(client: Client) -> float:
    """Return the CPU time of driver, scheduler and workers so far, in s."""
    return time.process_time() + sum(client.run(time.process_time).values())


def seconds_per_task(client: Client, size: int) -> float:
    """Return the CPU time of one task that is sent ``size`` bytes and returns as many."""
    began = cpu_time(client)
    for _ in range(WINDOWS):
        client.gather(client.map(echo, [bytes(size)] * WINDOW, pure=False))
    return (cpu_time(client) - began) / (WINDOWS * WINDOW)


def cluster(**how: Any) -> LocalCluster:
    """Return a cluster of two processes of one thread."""
    return LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", **how)


def main() -> None:
    """Run from the command line."""
    began = time.process_time()
    security = own_security()
    print(f"a certificate: {time.process_time() - began:.2f} s of CPU time, once per run")
    with (
        cluster(protocol="tcp://") as open_one,
        cluster(protocol="tls://", security=security) as closed_one,
        Client(open_one) as plain,
        Client(closed_one) as encrypted,
    ):
        for name, size in SIZES.items():
            pairs = [
                (seconds_per_task(plain, size), seconds_per_task(encrypted, size))
                for _ in range(ROUNDS)
            ][1:]  # the first one opens connections
            plainly, with_tls = (median(column) for column in zip(*pairs, strict=True))
            ratios = sorted(tls / tcp for tcp, tls in pairs)
            print(
                f"tasks {name}: {1e3 * plainly:.2f} ms without, {1e3 * with_tls:.2f} ms with TLS; "
                f"ratio {median(ratios):.2f} ({ratios[1]:.2f} to {ratios[-2]:.2f})"
            )


if __name__ == "__main__":
    main()
