"""What is sent to workers does not stay in the memory of the driver."""

import gc
import time
import weakref

import numpy as np

from elastomer_friction.workflow.cluster.client import open_client
from elastomer_friction.workflow.cluster.pool import Pool
from elastomer_friction.workflow.run.node import Node
from elastomer_friction.workflow.study.cluster import Cluster
from tests.support.python import PATIENCE
from tests.support.simulated import stream


def alive(sent):
    """Return how many items are left in memory, once what is passing has passed."""
    for _ in range(int(10 * PATIENCE)):
        gc.collect()
        left = sum(ref() is not None for ref in sent)
        if left <= 8:
            break
        time.sleep(0.1)
    return left


def test_what_was_sent_does_not_stay_in_memory():
    sent = []

    def items():
        for size in range(60):
            item = np.zeros(40_000 + size)
            sent.append(weakref.ref(item))
            yield item

    with open_client(Cluster(), 1) as client:
        pool = Pool(client, {"march": np.sum})
        assert sum(1 for _ in stream(pool, (Node("march", item) for item in items()))) == 60
        assert alive(sent) <= 8
        (comm,) = client.cluster.scheduler.stream_comms.values()
        assert not comm.recent_message_log
