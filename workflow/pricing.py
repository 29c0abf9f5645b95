"""What the tasks of a plan are predicted to cost on a machine whose rates are known."""

from kernels import Quantities
from workflow.cost import Load, Rates, case_seconds
from workflow.similarity import pace
from workflow.simulate.tasks import Task


class Prices:
    """Predicted core-seconds of the tasks of one study, each reckoned once."""

    def __init__(self, rates: Rates, asked: Quantities) -> None:
        """``asked`` : what is simulated."""
        self.rates, self.asked = rates, asked
        self.known: dict[str, float] = {}

    def task(self, task: Task) -> float:
        """Return the predicted time of one realization of a task on a line that exists."""
        if task.key not in self.known:
            self.known[task.key] = case_seconds(self.rates, self._load(task))
        return self.known[task.key]

    def line(self, samples: int) -> float:
        """Return the predicted time to draw and sample one line."""
        return self.rates.draw(samples)

    def _load(self, task: Task) -> Load:
        problem = task.problem
        return Load(
            samples=problem.elements * task.steps_per_spacing,
            steady_states=1 + (self.asked.steady or self.asked.relaxation),
            jumps=int(self.asked.jump),
            steps=task.march,
            hurst=problem.hurst,
            load=problem.load,
            pace=pace(problem),
        )
