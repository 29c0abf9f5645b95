"""Simulated: workers come and go at random beside a sick one; nothing is given up, or hangs."""

import random

import pytest

from elastomer_friction.workflow.cluster import WorkerDied
from tests.support.simulated import Cluster, first, sick, sound, streamed, tries


def trouble(cluster, seed):
    """Let sound workers come and go by chance for a minute; return since when each is well."""
    chance, well = random.Random(seed), {"b": cluster.now}

    def join(name):
        cluster.join(name, sound)
        well[name] = cluster.now

    def wake(name):
        cluster.wake(name)
        well[name] = cluster.now

    def end(name, how):
        well.pop(name, None)
        how(name)

    for number in range(8):
        name, begin, last = f"s{number}", chance.uniform(0.0, 60.0), chance.uniform(0.0, 60.0)
        cluster.after(begin, join, name)
        how = chance.choice([cluster.die, cluster.hush, cluster.pause])
        cluster.after(begin + last, end, name, how)
        if how != cluster.die:
            cluster.after(begin + last + chance.uniform(0.0, 60.0), wake, name)
    cluster.after(chance.uniform(0.0, 60.0), end, "b", cluster.die)
    cluster.after(130.0, join, "last")
    return well


@pytest.mark.parametrize("seed", range(20))
def test_nothing_is_given_up_while_somebody_is_well_and_nothing_hangs(seed):
    cluster, done = Cluster(a=sick, b=first(20.0)), []
    well = trouble(cluster, seed)

    def give_up(item, error, alone):
        if isinstance(error, WorkerDied) and not alone:
            return [item]
        assert all(cluster.now - since < 2.0 for since in well.values()), well  # a roll, and a half
        done.append(item)
        return []

    done += [item for item, _ in streamed(cluster, range(60), retry=give_up)]
    assert sorted(done) == [*range(60)]
    assert max(tries(cluster, "a").values()) <= 8
