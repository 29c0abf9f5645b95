"""What is said of doubled keys of [study] and [cluster] is so."""

from tests.support.small import keys, small_plan


def test_realizations_doubled_double_the_records():
    assert small_plan("study.realizations=32").records == 2 * small_plan().records


def test_realizations_per_block_doubled_halve_the_records():
    wide = small_plan("study.realizations_per_block=8")
    assert 2 * wide.records == small_plan("study.realizations_per_block=4").records
    assert keys(wide) != []


def test_a_title_and_a_cluster_change_no_number():
    same = small_plan('study.title="another"', "cluster.jobs=7", 'cluster.memory="4GB"')
    assert keys(same) == keys(small_plan())
    assert keys(small_plan("study.seed=2")) != keys(small_plan())
