"""Description of a fit, which names undetermined quantities without giving a number for them."""

import math
from statistics import fmean

from ..ground import counted, with_error
from .estimate import Estimate
from .step_fit import NEITHER_TEXT, NO_RELAXATION_TEXT, POOR_RESIDUAL_RATIO, StepFit
from .together import MIN_LOG_SPEED_GAP, Fit, Rates

MIN_TIMING_SHARE = 0.5  # of the variance of a jump, by the moment of the step
OPTIONS = {"tau": "--relaxation-time", "H": "--hurst", "q_max": "--q-max"}
NAMES = {"mu_2": "friction after, mu_2", "amplitude": "amplitude", "jump": "jump", "rate": "rate"}


def describe(fit: Fit) -> list[str]:
    """Return lines for a terminal: each step, then the joint result of all steps."""
    lines = [*fit.description, ""] if fit.description else []
    for step, ageing in zip(fit.steps, fit.ageing, strict=True):
        lines += _step(step, min(step.rms, ageing.rms))
        for law, label in ((step, "Ruina's law (eq. 6)"), (ageing, "Dieterich's law")):
            values = zip(("a", "b", "D_c"), law.state(), ("", "", " m"), strict=True)
            known = [
                f"{name} = {shown(estimate)}{unit}"
                for name, estimate, unit in values
                if estimate.known
            ]
            if known:  # undetermined constants of a law are left out
                lines.append(_line(label, f"{', '.join(known)}; residual {law.rms:.2g}"))
        lines.append("")
    return [*lines, *_together(fit)]


def _step(fit: StepFit, least: float) -> list[str]:
    """Return the description of one step. least : rms residual of the better law."""
    step, times = fit.step, least / fit.noise if fit.noise else 1.0
    lines = [f"{step.name}: from {step.v1:.4g} to {step.v2:.4g} m/s"]
    levels = (("friction before, mu_1", fit.mu_1), ("jump", fit.jump))
    for name, level in (*levels, ("friction after, mu_2", fit.mu_2)):
        if level.known:
            lines.append(_line(name, shown(level)))
    if fit.rate.known:
        time = fit.rate.times(1.0 / fit.rate.value**2)
        lines.append(
            _line("relaxation rate, b/tau", f"{shown(fit.rate)} 1/s, time {shown(time)} s")
        )
    lines.append(
        _line("residual", f"{fit.rms:.2g} rms, {step.time[0]:.3g} to {step.time[-1]:.3g} s after")
    )
    if fit.stiffness is not None:
        lines.append(_line("spring", f"{fit.stiffness:g} 1/m, of the machine, is part of the fit"))
    lines += _moment(fit)
    if fit.factor > 1.5:
        sentence = f"errors are {math.sqrt(fit.factor):.2g} times those of independent samples"
        lines.append(_line("noise", f"is correlated; {sentence}"))
    if fit.drifts or fit.levelled:
        sentence = (
            f"friction still changes, by {fit.drift.value:.2g} over {step.before.size} samples"
        )
        then = "mu_1 is a mean of them"
        if fit.levelled:
            then = "this drift is subtracted before and after the step"
        lines.append(_line("before the step", f"{sentence}; {then}"))
    poor = ""
    if times > POOR_RESIDUAL_RATIO:
        poor = f"the residual is {times:.2g} times the noise: {NEITHER_TEXT}"
    for why in dict.fromkeys(fit.why.values()):
        names = [NAMES[name] for name in fit.why if fit.why[name] == why]
        reason = poor if poor and why == NO_RELAXATION_TEXT else why
        lines.append(_line("not determined", f"{_listed(names)}: {reason}"))
    if poor and NO_RELAXATION_TEXT not in fit.why.values():
        lines.append(_line("warning", poor))
    return lines


def _moment(fit: StepFit) -> list[str]:
    """State by how much a and b depend on the moment of the step, if most of their error does."""
    if fit.stiffness is not None or not (fit.jump.known and fit.rate.known):
        return []
    change = fit.step.change
    sooner = abs(fit.amplitude.value) * -math.expm1(-0.5 * fit.rate.value * change)
    # A moment anywhere in the interval has a third of the variance of one at either end.
    if sooner**2 / 3.0 < MIN_TIMING_SHARE * fit.jump.error**2:
        return []
    less = sooner / abs(math.log(fit.step.ratio))
    text = f"in the middle of {change:.3g} s between samples; at the first sample after it, "
    return [_line("moment of the step", f"{text}a and b are {less:.2g} smaller")]


def _together(fit: Fit) -> list[str]:
    rates = fit.rates
    if rates is None:
        return ["no step determines its rate; tau, H and q_max are not determined"]
    lines = [f"{counted(len(fit.steps), 'step')} at {counted(rates.speeds, 'speed')} with a rate"]
    if rates.exponent.known:
        at = f"{shown(rates.rate)} 1/s at {rates.at:.3g} m/s"
        lines.append(_line("power law of the rate", f"exponent {shown(rates.exponent)}, {at}"))
    parameters = {
        "tau": (rates.relaxation_time, " s", fit.known.relaxation_time),
        "H": (rates.hurst, "", fit.known.hurst),
        "q_max": (rates.q_max, " 1/m", fit.known.q_max),
    }
    for name, (value, unit, given) in parameters.items():
        if value.known:
            lines.append(
                _line(name, f"{shown(value)}{unit}" if given is None else f"{given:g}{unit}, given")
            )
    if fit.slope.known:
        lines.append(_line("rms slope (eq. 12)", shown(fit.slope)))
    if fit.slope.known or any(value.known for value, *_ in parameters.values()):
        text = "not in these errors: the laws hold for a foundation (docs/bodies.md)"
        lines.append(_line("error of the model", text))
    lines += _open(
        fit, rates, [name for name, (value, *_) in parameters.items() if not value.known]
    )
    if all(value.known for value, *_ in parameters.values()):
        lines += _whole(fit, rates)
    return lines


def _open(fit: Fit, rates: Rates, names: list[str]) -> list[str]:
    """Describe the quantities that the joint fit leaves undetermined, with a remedy."""
    lines = []
    if names:
        if rates.speeds == 1:
            why = "one speed determines one rate; measure at several, or give the known values"
        else:
            why = "other values fit these rates equally well; measure at lower and higher speeds, "
            why += "on both sides of v_2 tau q_max = 1, or give the known values"
        options = ", ".join(OPTIONS[name] for name in names)
        lines.append(_line("not determined", f"{_listed(names)}: {why} ({options})"))
    if not fit.slope.known:
        why = "the jumps are proportional to friction for any slope; measure at higher speeds"
        lines.append(_line("not determined", f"the rms slope: {why}"))
    return lines


def _whole(fit: Fit, rates: Rates) -> list[str]:
    """State which law below x = 1 fits better, and write the KineticLaw as a Python call."""
    branch = "is 1: contacts creep with tau" if rates.time_below_one else "is x, as eq. 13 has it"
    lines = [_line("below v_2 tau q_max = 1", f"b {branch}; sum of squares {rates.squares:.2g}")]
    table = _steady(fit)
    if fit.slope.known and len(table) > 1:
        lines.append(
            "KineticLaw("
            f"relaxation_time={rates.relaxation_time.value:.4g}, hurst={rates.hurst.value:.3g}, "
            f"q_max={rates.q_max.value:.4g}, rms_slope={fit.slope.value:.4g}, "
            f"velocity={[float(f'{v:.4g}') for v, _ in table]}, "
            f"friction={[float(f'{mu:.4g}') for _, mu in table]}, "
            f"time_below_one={rates.time_below_one})"
        )
    return lines


def _steady(fit: Fit) -> list[tuple[float, float]]:
    """Return pairs (speed, positive steady friction), averaged over equal speeds."""
    both = [(estimate.step.v1, estimate.mu_1) for estimate in fit.steps]
    both += [(estimate.step.v2, estimate.mu_2) for estimate in fit.steps]
    groups: list[list[tuple[float, float]]] = []
    for v, mu in sorted((v, mu.value) for v, mu in both if mu.known and mu.value > 0.0):
        if groups and math.log(v / groups[-1][0][0]) < MIN_LOG_SPEED_GAP:
            groups[-1].append((v, mu))
        else:
            groups.append([(v, mu)])
    return [(fmean(v for v, _ in group), fmean(mu for _, mu in group)) for group in groups]


def _listed(names: list[str]) -> str:
    """Return "a", "a and b", "a, b and c"."""
    return " and ".join(filter(None, [", ".join(names[:-1]), names[-1]]))


def _line(name: str, text: str) -> str:
    return f"  {name:<24}{text}"


def shown(estimate: Estimate) -> str:
    """Return an estimate as text (see ``with_error``); an unknown one is "not determined"."""
    return with_error(*estimate) if estimate.known else "not determined"
