"""Rates of a run: ratios of measured to predicted core time of finished batches."""

from collections import defaultdict

from ..plan import Missing, Plan
from ..simulate import Batch

PRIOR_SECONDS = 1.0  # s, time of notional work at the rate 1 that is added to the measurements
ROUNDING_SHARE = 1e-9  # share of the predicted work; a smaller remainder is a rounding error


class MeasuredRates:
    """Ratio of measured to predicted core time of finished batches, by label of the variant.

    The predictions of a plan are rough. These rates correct the lengths of later batches and the
    remaining time.
    """

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.used: dict[str, float] = defaultdict(float)
        self.predicted: dict[str, float] = defaultdict(float)

    def enter(self, batch: Batch, seconds: float) -> None:
        """Add a finished batch. seconds : its measured core time."""
        label = self.plan.variant_of_batch(batch).label
        self.used[label] += seconds
        self.predicted[label] += batch.seconds

    def rate(self, label: str) -> float:
        """Return the rate of a variant, which is 1 until its first batch finishes."""
        used, predicted = self.used.get(label, 0.0), self.predicted.get(label, 0.0)
        return (used + PRIOR_SECONDS) / (predicted + PRIOR_SECONDS)


class Remaining:
    """Remaining core-seconds of some work, corrected by measured rates."""

    def __init__(self, work: list[Missing], rates: MeasuredRates) -> None:
        self.rates = rates
        self.predicted: dict[str, float] = defaultdict(float)  # by label of the variant
        for piece in work:
            self.predicted[piece.variant.label] += piece.blocks * piece.seconds
        self.rounding = ROUNDING_SHARE * sum(self.predicted.values())

    def finish(self, batch: Batch) -> None:
        """Subtract a finished batch."""
        label = self.rates.plan.variant_of_batch(batch).label
        left = self.predicted[label] - batch.seconds
        self.predicted[label] = left if left > self.rounding else 0.0

    def seconds(self) -> float:
        """Return the corrected remaining core-seconds."""
        return sum(
            predicted * self.rates.rate(label) for label, predicted in self.predicted.items()
        )

    def rate(self) -> float:
        """Return the ratio of corrected to predicted remaining core-seconds; 1 if none remain."""
        predicted = sum(self.predicted.values())
        return self.seconds() / predicted if predicted else 1.0
