"""The workers of a run: who is there, who has fallen silent, who is left out, who is free.

A worker is known by its address. Where workers sit on several hosts, one that fails is taken
for its host: the others there share its disk and memory.
"""

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from distributed import Client

from ..errors import UserError
from ..system import duration
from .calls import LOST, Call, Clock, Roll, call_roll
from .watch import BEAT_SECONDS, LONGEST_BEAT, QUIET_SECONDS, Watch, say

SILENT_SECONDS = 30.0  # without a heartbeat, before that is said and its work done elsewhere
QUIET_PER_WORKER = 0.01  # s; the more workers, the rarer dask's heartbeats
ROW = 3  # failures in a row that others did not have, before a worker is left out


def host_of(address: str) -> str:
    """Return protocol and host of an address."""
    return address.rpartition(":")[0]


@dataclass
class Crew:
    """The workers, roll call after roll call."""

    roll: Roll = field(default_factory=lambda: Roll({}, {}, {}))
    silence: dict[str, float] = field(default_factory=dict)  # s that passed here without a sign
    said: dict[str, float] = field(default_factory=dict)  # silence that has been told
    blamed: Counter[str] = field(default_factory=Counter)  # failures in a row, by place
    left_out: set[str] = field(default_factory=set)  # places
    gone: dict[str, float] = field(default_factory=dict)  # s since a worker was lost, by address
    by_host: bool = False  # whether there are several hosts

    def note(self, roll: Roll, passed: float) -> None:
        """Take note of a roll call, so many seconds after the last one; say who is silent.

        Silence is time that this process has watched: no clock of another machine is read, and
        what a suspended computer slept does not count.
        """
        passed = min(passed, LONGEST_BEAT)
        self.silence = {
            address: self.silence.get(address, 0.0) + passed
            if heard == self.roll.heard.get(address)
            else 0.0
            for address, heard in roll.heard.items()
        }
        lost = {address: 0.0 for address in self.roll.threads if address not in roll.threads}
        ago = {address: seconds + passed for address, seconds in (self.gone | lost).items()}
        self.gone = {a: s for a, s in ago.items() if s < SILENT_SECONDS and a not in roll.threads}
        self.roll = roll
        self.by_host = len({host_of(address) for address in roll.threads}) > 1
        if not self.all_quiet():  # or else the watch says so
            self._say()

    def quiet(self, address: str) -> bool:
        """Return whether nothing has been heard of a worker for some heartbeats, or it is gone."""
        limit = QUIET_SECONDS + QUIET_PER_WORKER * len(self.silence)
        return self.silence.get(address, limit) >= limit

    def silent(self, address: str) -> bool:
        """Return whether nothing has been heard of a worker for so long that work goes on."""
        return self.silence.get(address, 0.0) >= SILENT_SECONDS

    def present(self) -> list[str]:
        """Return the addresses of workers that are there and have not fallen silent."""
        return [address for address in self.roll.threads if not self.silent(address)]

    def all_quiet(self) -> bool:
        """Return whether there are workers, and nothing is heard of any."""
        return bool(self.roll.threads) and all(map(self.quiet, self.roll.threads))

    def threads(self) -> int:
        """Return the number of threads of workers that are there."""
        return sum(self.roll.threads[address] for address in self.present())

    def able(self, but: Iterable[str] = ()) -> list[str]:
        """Return the addresses of workers that are there and take up work, without some."""
        others = {*self.roll.paused, *but}
        return [address for address in self.present() if address not in others]

    def fit(self, but: Iterable[str] = ()) -> list[str]:
        """Return those of ``able`` that are not left out, and elsewhere than some addresses."""
        return self._elsewhere(self.able(), but)

    def awaits(self, but: Iterable[str] = ()) -> bool:
        """Return whether ``fit`` has nobody, but a worker that would be in it was lost just now.

        It may come again: a nanny starts a worker anew within seconds.
        """
        return not self.fit(but) and bool(self._elsewhere(self.gone, but))

    def _elsewhere(self, addresses: Iterable[str], but: Iterable[str]) -> list[str]:
        """Return those of some addresses that are neither left out nor where others are."""
        places = self.left_out | {self.place(address) for address in but}
        return [address for address in addresses if self.place(address) not in places]

    def place(self, address: str) -> str:
        """Return where a worker is: its host, or on a single host its address."""
        return host_of(address) if self.by_host else address

    def succeeded(self, address: str, failed: Iterable[str]) -> None:
        """Note that a worker computed what workers at ``failed`` could not; leave out whom due."""
        place = self.place(address)
        self.blamed.pop(place, None)
        for other in {self.place(other) for other in failed if other} - {place, *self.left_out}:
            self.blamed[other] += 1
            if self.blamed[other] >= ROW:
                self.left_out.add(other)
                say(
                    f"worker {other}: {self.blamed[other]} batches in a row failed there and "
                    "went well elsewhere; left out"
                )

    def _say(self) -> None:
        for address, seconds in self.silence.items():
            due = max(SILENT_SECONDS, 2.0 * self.said.get(address, 0.0))
            if seconds >= due:
                say(
                    f"worker {address}: no sign of life for {duration(seconds)}; "
                    "its batches are computed elsewhere"
                )
            self.said[address] = seconds if seconds >= due else self.said.get(address, 0.0)
            if seconds < SILENT_SECONDS:
                self.said.pop(address)


class RollCalls:
    """Calls the roll every second, without waiting for the answer."""

    def __init__(
        self, client: Client, watch: Watch, clock: Clock, call: Callable[..., Call]
    ) -> None:
        self.client, self.clock, self.call = client, clock, call
        self.crew = watch.crew = watch.crew or Crew()
        self.stopping = False  # whether the last roll was called after a stop
        self.calling: Call | None = None
        self.called = self.noted = float("-inf")  # when the last was called, and answered

    def tick(self, stopping: bool) -> bool:
        """Call the roll if it is time to; return whether one was answered now.

        Raises UserError where the scheduler is lost.
        """
        now = self.clock.monotonic()
        if not self.calling and (now - self.called >= BEAT_SECONDS or stopping != self.stopping):
            self.stopping, self.called = stopping, now
            self.calling = self.call(call_roll, self.client, not self.answered())
        if not (self.calling and self.calling.wait(0.0)):
            return False
        try:
            self.crew.note(self.calling.result(), now - self.noted)
        except OSError as error:
            raise UserError(LOST) from error
        self.calling, self.noted = None, now
        return True

    def answered(self) -> bool:
        """Return whether any roll was answered."""
        return self.noted > float("-inf")

    def unanswered(self) -> bool:
        """Return whether the scheduler does not answer."""
        return self.calling is not None and self.clock.monotonic() - self.called >= QUIET_SECONDS
