"""What a scene can be asked for: one table, one order."""

from elastomer_friction.workflow.study.effects.quantities import judged
from tests.support.small import small_study


def test_quantities_come_in_their_own_order():
    study = small_study('scene.quantities=["relaxation","steady"]')
    assert study.scene.quantities == ("steady", "relaxation")


def test_what_is_asked_for_is_judged():
    assert judged(("steady", "jump", "relaxation", "models")) == ("mu_1", "jump", "relaxation_rate")
    assert judged(("jump",)) == ("jump",)
