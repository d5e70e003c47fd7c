"""An executor whose work is done on the workers of a Dask cluster.

Dask places the work and repeats it if a worker is lost. `ClusterExecutor` adds what whole runs
need. Workers are checked before they get work (`probe`). There are never more pieces of work on the
way than threads, so that a lost worker is blamed on the piece that it was working on, and workers
that join later find work left.
"""

from __future__ import annotations

import asyncio
import secrets
import warnings
from collections import deque
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from queue import Empty, SimpleQueue
from threading import Thread
from time import monotonic
from typing import Any

from matrixworld.cluster.probe import Probe
from matrixworld.cluster.worker import Call, Outcome, check, perform

FIRST_WORKER_SECONDS = 300
"""Workers of a batch system may start after the program that gives them work."""
LOOK_SECONDS = 1.0
"""Time from one look at the workers to the next."""
STOP_SECONDS = 10.0
"""How long work that has been told to stop is waited for."""
RESULT_SECONDS = 10.0
"""How long a result may take from a worker to here."""
NO_WORKER_SECONDS = 600.0
"""After this time without any worker the cluster is given up."""
TRIES = 3
"""How often a piece of work is handed out after errors of the cluster."""


class ClusterLostError(BrokenExecutor):
    """The cluster has gone: no work can be handed out any more, and no results come back."""


class UnfitWorkerError(RuntimeError):
    """A worker cannot share the work; the message names it and says why."""


@dataclass
class Work:
    """A piece of work, the future that waits for its result, and whether it is for some workers."""

    call: Call
    future: Future[Any]
    tries: int = 0
    bound: bool = False


class ClusterExecutor(Executor):
    """An executor on a connected Dask client; see `cluster`.

    One thread talks to Dask. It is woken by new work, by finished work, and once a second to look
    at the workers.

    Parameters
    ----------
    client : distributed.Client
        The client.
    probe : Probe
        What a worker must have.
    tell : callable, optional
        Called with each sentence for the user.
    """

    def __init__(
        self, client: Any, probe: Probe, *, tell: Callable[[str], None] = warnings.warn
    ) -> None:
        self._client, self._probe, self._tell = client, probe, tell
        self._waiting: deque[Work] = deque()
        self._begun: dict[Any, Work] = {}
        self._fit: dict[str, int] = {}
        self._unfit: set[str] = set()
        self._asked: set[str] = set()
        self._events: SimpleQueue[Any] = SimpleQueue()
        self._alone_since: float | None = None
        self._lost: ClusterLostError | None = None
        self._closing = self._closed = self._ended = False
        self._thread = Thread(target=self._serve, name="cluster", daemon=True)

    # Called by the thread that hands in work:

    def check_workers(self) -> None:
        """Wait for a first worker and check all; UnfitWorkerError if one is unfit."""
        try:
            self._client.wait_for_workers(1, timeout=FIRST_WORKER_SECONDS)
        except (TimeoutError, asyncio.TimeoutError) as error:
            raise OSError(
                f"cluster: no worker has joined {self._scheduler} within {FIRST_WORKER_SECONDS} s"
            ) from error
        self._fit = self._client.nthreads()
        for worker, problem in self._problems(list(self._fit)).items():
            raise UnfitWorkerError(f"cluster: worker {worker} cannot take part: {problem}")
        self._thread.start()

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Hand in a piece of work.

        Parameters
        ----------
        fn : callable
            A function that the workers can import.
        *args, **kwargs
            Its arguments, as small as possible.

        Returns
        -------
        concurrent.futures.Future
            The result. Until a worker takes the work it can be cancelled.
        """
        self._check_open()
        work = Work(Call(fn, args, kwargs), Future())
        self._events.put(work)
        if self._lost is not None:  # in the meantime
            self._fail_handed_in(self._lost)
        return work.future

    def _check_open(self) -> None:
        if self._lost is not None:
            raise self._lost
        if self._closing:
            raise RuntimeError("submit: expected an executor that is not shut down")

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Take no more work.

        Parameters
        ----------
        wait : bool, optional
            Whether to wait for all work that is not cancelled.
        cancel_futures : bool, optional
            Whether to cancel the work that no worker has begun.
        """
        self._closing = True
        # An event, because work that was handed in before may still lie in the queue.
        self._events.put(self._drop_waiting if cancel_futures else self._no_more)
        if wait and self._thread.is_alive():
            self._thread.join()

    def close(self) -> None:
        """Drop all work that has not begun, and wait a while for the rest."""
        self.shutdown(wait=False, cancel_futures=True)
        if self._thread.is_alive():
            self._thread.join(STOP_SECONDS)
        self._closed = True

    # Called by the executor's own thread:

    def _serve(self) -> None:
        looked = monotonic()
        try:
            while not self._closed and (self._begun or self._waiting or not self._ended):
                self._take_event()
                if monotonic() - looked >= LOOK_SECONDS:
                    self._look()
                    looked = monotonic()
                self._hand_out()
        except Exception as error:  # noqa: BLE001, or those who wait for results would wait forever
            self._lose(repr(error))

    def _take_event(self) -> None:
        try:
            event = self._events.get(timeout=LOOK_SECONDS)
        except Empty:
            return
        if isinstance(event, Work):
            self._waiting.append(event)
        elif event in self._begun:
            self._end(event, self._begun.pop(event))
        elif callable(event):
            event()

    def _hand_out(self) -> None:
        while self._waiting and len(self._begun) < sum(self._fit.values()):
            work = self._waiting.popleft()
            if work.tries == 0 and not work.future.set_running_or_notify_cancel():
                continue
            work.tries += 1
            work.bound = bool(self._unfit or self._asked)
            given = self._client.submit(
                perform,
                self._probe,
                work.call,
                key=f"matrixworld-{secrets.token_hex(8)}",
                pure=False,
                # Not always: thousands of addresses take longer than the rest of a task.
                workers=list(self._fit) if work.bound else None,
                allow_other_workers=work.bound,
            )
            self._watch(given, work)

    def _watch(self, given: Any, work: Work) -> None:
        self._begun[given] = work
        given.add_done_callback(self._events.put)

    def _end(self, given: Any, work: Work) -> None:
        """Give the result of a piece of work to those who wait for it, or hand it out again."""
        if given.status == "cancelled":
            self._begun[given] = work
            self._lose(f"the connection to {self._scheduler} was lost")
            return
        if given.status == "error":
            self._end_with_cluster_error(given.exception(), work)
            return
        try:
            outcome: Outcome = given.result(timeout=RESULT_SECONDS)
        except (TimeoutError, asyncio.TimeoutError):
            # Its worker was lost with it, and Dask does the work again.
            self._watch(given, work)
            return
        if outcome.unfit:
            self._exclude(outcome.worker, outcome.unfit)
            self._waiting.appendleft(work)
        elif outcome.error is not None:
            work.future.set_exception(outcome.error)
        else:
            work.future.set_result(outcome.value)

    def _end_with_cluster_error(self, error: BaseException, work: Work) -> None:
        from distributed import KilledWorker

        # Here, because workers import this package to be checked, which should be quick.
        from matrixworld.coevolution.jobs.worker import WorkerDiedError

        if isinstance(error, KilledWorker):
            work.future.set_exception(
                WorkerDiedError(
                    f"{error.allowed_failures + 1} workers died while they did it, the last one at "
                    f"{error.last_worker.address}"
                )
            )
        else:
            # A worker that cannot read the work. It is being asked, and will get no more.
            self._try_again(work, error)

    def _try_again(self, work: Work, error: BaseException) -> None:
        if work.tries < TRIES:
            self._waiting.appendleft(work)
        else:
            work.future.set_exception(error)

    def _look(self) -> None:
        """Look which workers there are, and let those that have joined check themselves."""
        try:
            threads = self._client.nthreads()
        except OSError as error:
            self._lose(f"{self._scheduler} does not answer ({error})")
            return
        for worker in threads.keys() - self._fit.keys() - self._unfit - self._asked:
            self._asked.add(worker)
            # In a thread of its own: a worker that dies meanwhile takes long to answer.
            Thread(target=self._ask, args=(worker, threads[worker]), daemon=True).start()
        self._fit = {each: n for each, n in self._fit.items() if each in threads}
        self._wait_for_workers()

    def _ask(self, worker: str, threads: int) -> None:
        try:
            problem = self._problems([worker]).get(worker, "")
        except OSError:
            problem = None
        self._events.put(partial(self._admit, worker, threads, problem))

    def _admit(self, worker: str, threads: int, problem: str | None) -> None:
        """Take a worker that has joined; None if it does not answer, and is asked again."""
        self._asked.discard(worker)
        if problem:
            self._exclude(worker, problem)
        elif problem is not None:
            if not self._fit:
                self._take_back()
            self._fit[worker] = threads

    def _take_back(self) -> None:
        """Take back the work for workers that are all lost: Dask would never give it to others."""
        for given, work in list(self._begun.items()):
            if work.bound:
                del self._begun[given]
                given.cancel()
                self._try_again(work, UnfitWorkerError("cluster: all fit workers were lost"))

    def _problems(self, workers: list[str]) -> dict[str, str]:
        """Return the problems of those workers that have any."""
        if not workers:
            return {}
        answers = self._client.run(check, self._probe, workers=workers, on_error="return")
        for answer in answers.values():
            if isinstance(answer, OSError):
                raise answer  # it has died
        return {worker: str(answer) for worker, answer in answers.items() if answer != ""}

    def _exclude(self, worker: str, problem: str) -> None:
        if worker not in self._unfit:
            self._unfit.add(worker)
            self._fit.pop(worker, None)
            self._tell(f"Worker {worker} gets no work: {problem}.")

    def _wait_for_workers(self) -> None:
        if self._fit:
            self._alone_since = None
        elif self._alone_since is None:
            self._alone_since = monotonic()
            self._tell(f"No worker is left at {self._scheduler}; waiting for one to join.")
        elif monotonic() - self._alone_since > NO_WORKER_SECONDS:
            self._lose(f"{self._scheduler} has had no worker for {NO_WORKER_SECONDS:.0f} s")

    def _lose(self, reason: str) -> None:
        """Give up: the connection has gone, and with it all work on the way."""
        self._lost = ClusterLostError(f"cluster: {reason}; what is saved stays")
        self._closing = self._ended = True
        for work in (*self._begun.values(), *self._waiting):
            if work.tries or work.future.set_running_or_notify_cancel():
                work.future.set_exception(self._lost)
        self._begun.clear()
        self._waiting.clear()
        self._fail_handed_in(self._lost)

    def _fail_handed_in(self, error: ClusterLostError) -> None:
        """Fail the work that lies in the queue: two threads may call this at one time."""
        with suppress(Empty):
            while True:
                event = self._events.get_nowait()
                if isinstance(event, Work) and event.future.set_running_or_notify_cancel():
                    event.future.set_exception(error)

    def _drop_waiting(self) -> None:
        while self._waiting:
            self._waiting.popleft().future.cancel()
        self._no_more()

    def _no_more(self) -> None:
        self._ended = True

    @property
    def _scheduler(self) -> str:
        return f"the scheduler {self._client.scheduler.address}"
