"""Rates of a run: measured over predicted core time of its finished batches."""

from collections import defaultdict

from ..plan import Missing, Plan
from ..simulate import Batch

PRIOR_SECONDS = 1.0  # predicted work without a measurement, at the rate 1
ROUNDING_SHARE = 1e-9  # of the predicted work: a smaller rest is rounding


class MeasuredRates:
    """Measured over predicted core time of finished batches, by label of the variant.

    The predictions of a plan are rough; batches to come and the remaining time are corrected by
    these rates.
    """

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.used: dict[str, float] = defaultdict(float)
        self.predicted: dict[str, float] = defaultdict(float)

    def enter(self, batch: Batch, seconds: float) -> None:
        """Count a finished batch. seconds : its core time."""
        label = self.plan.variant_of_batch(batch).label
        self.used[label] += seconds
        self.predicted[label] += batch.seconds

    def rate(self, label: str) -> float:
        """Return the rate of a variant; next to 1 until batches of it are finished."""
        used, predicted = self.used.get(label, 0.0), self.predicted.get(label, 0.0)
        return (used + PRIOR_SECONDS) / (predicted + PRIOR_SECONDS)


class Remaining:
    """The core-seconds that are left of some work, corrected by measured rates."""

    def __init__(self, work: list[Missing], rates: MeasuredRates) -> None:
        self.rates = rates
        self.predicted: dict[str, float] = defaultdict(float)  # by label of the variant
        for piece in work:
            self.predicted[piece.variant.label] += piece.blocks * piece.seconds
        self.rounding = ROUNDING_SHARE * sum(self.predicted.values())

    def finish(self, batch: Batch) -> None:
        """Take a finished batch off."""
        label = self.rates.plan.variant_of_batch(batch).label
        left = self.predicted[label] - batch.seconds
        self.predicted[label] = left if left > self.rounding else 0.0

    def seconds(self) -> float:
        """Return the core-seconds that are left."""
        return sum(
            predicted * self.rates.rate(label) for label, predicted in self.predicted.items()
        )

    def rate(self) -> float:
        """Return the corrected over the predicted core-seconds that are left."""
        predicted = sum(self.predicted.values())
        return self.seconds() / predicted if predicted else 1.0
