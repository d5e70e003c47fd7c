"""The executor of a Dask cluster: one that exists, or one of this machine's cores.

Dask places the work, does it again if a worker is lost, and gives it up when it has killed more
than ``allowed-failures`` workers. `ClusterExecutor` adds two things that whole runs need. Every
worker checks itself when it joins (see `probe`): a fit one offers a resource that all work asks
for, so that others get none. And there are never more pieces of work on the way than threads:
Dask blames a lost worker on all pieces that it held, and workers that join later find work left.
"""

from __future__ import annotations

import asyncio
import logging
import pickle
import secrets
import warnings
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager, suppress
from functools import partial
from pathlib import Path
from threading import Event, Thread
from time import monotonic
from typing import Any

from matrixworld._util.checks import usable_cores
from matrixworld._util.files import DamagedFileError, read_json
from matrixworld.cluster.probe import Probe, posted
from matrixworld.coevolution.jobs.worker import WorkerDiedError, without_interrupts
from matrixworld.version import imported

AUTO = "auto"
"""Name of a cluster of this machine's cores."""
CONNECT_SECONDS = 30
"""How long an address is tried."""
FIRST_WORKER_SECONDS = 300
"""Workers of a batch system may start after the program that gives them work."""
LOOK_SECONDS = 1.0
"""Time from one look at the cluster to the next."""
STOP_SECONDS = 10.0
"""How long work that has been told to stop is waited for."""
RESULT_SECONDS = 10.0
"""How long a result may take from a worker to here."""
NO_WORKER_SECONDS = 600.0
"""After this time without any worker the cluster is given up."""


class ClusterLostError(BrokenExecutor):
    """The cluster has gone: no work can be handed out any more, and no results come back."""


class UnfitWorkerError(RuntimeError):
    """A worker cannot share the work; the message names it and says why."""


@contextmanager
def cluster(
    where: str,
    *,
    directory: Path | None = None,
    same_processors: bool = False,
    tell: Callable[[str], None] = warnings.warn,
) -> Iterator[Executor]:
    """Yield an executor whose work is done on a Dask cluster.

    Parameters
    ----------
    where : str
        ``"auto"`` for a cluster of one process for each core of this machine; the address of a
        scheduler, such as ``"tcp://host:8786"``; or the path of a scheduler file.
    directory : Path, optional
        Directory that the work reads and writes: all workers must see it, and its locks.
    same_processors : bool, optional
        Whether the workers' linear algebra must be the same as here: CMA-ES needs it.
    tell : callable, optional
        Called with each sentence for the user, about workers that join or are missing.

    Yields
    ------
    Executor
        Its functions must be importable by the workers, and its values be small. After an error in
        the block, work that has not begun is dropped, and work that has begun is waited for
        `STOP_SECONDS`: Dask cannot stop it.

    Raises
    ------
    ImportError
        If Dask is not installed.
    ValueError
        If `where` is none of the three.
    UnfitWorkerError
        If a worker cannot share the work.
    OSError
        If there is no scheduler, or no worker joins within `FIRST_WORKER_SECONDS`.
    """
    with ExitStack() as stack:
        client = stack.enter_context(_connected(where))
        probe = stack.enter_context(posted(directory, same_processors=same_processors))
        executor = ClusterExecutor(client, probe, tell=tell)
        stack.callback(executor.close)
        executor.start()
        yield executor


def check_where(where: str) -> None:
    """Raise ValueError unless `where` can name a cluster."""
    if where != AUTO and "://" not in where and not Path(where).is_file():
        raise ValueError(
            f"cluster: expected {AUTO}, an address such as tcp://HOST:8786 or a scheduler file, "
            f"got {where!r}"
        )


@contextmanager
def _connected(where: str) -> Iterator[Any]:
    check_where(where)
    dask = imported("distributed", "cluster")
    with ExitStack() as stack:
        if where == AUTO:
            with without_interrupts():
                address: Any = stack.enter_context(dask.LocalCluster(**_local()))
        else:
            address = where if "://" in where else _address_in(Path(where))
        stack.enter_context(_quiet())
        if where != AUTO:
            _check_answer(address)
        with dask.Client(address, timeout=CONNECT_SECONDS, set_as_default=False) as client:
            yield client


def _address_in(file: Path) -> str:
    address = read_json(file).get("address")
    if not isinstance(address, str):
        raise DamagedFileError(file, "expected a scheduler file of Dask, got no address in it")
    return address


def _check_answer(address: str) -> None:
    """Raise OSError if no scheduler answers: a client would wait for the answer without a limit."""
    from distributed import Security
    from distributed.comm import connect  # type: ignore[attr-defined]

    # Dask has no types.
    security: Any = Security
    say_hello: Any = connect

    async def greet() -> None:
        certificates = security().get_connection_args("client")
        comm = await say_hello(address, timeout=CONNECT_SECONDS, **certificates)
        await comm.close()

    # In a thread: notebooks have an event loop of their own in this one.
    with ThreadPoolExecutor(1) as thread:
        waited = thread.submit(asyncio.run, asyncio.wait_for(greet(), CONNECT_SECONDS))
        try:
            waited.result()
        except asyncio.TimeoutError:
            raise OSError(
                f"{address}: expected a Dask scheduler, got no answer within {CONNECT_SECONDS} s"
            ) from None


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep tracebacks of a lost connection off the terminal: the executor says it in a sentence."""
    loggers = [logging.getLogger(f"distributed.{name}") for name in ("client", "core", "comm")]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    yield
    for logger, level in zip(loggers, levels, strict=True):
        logger.setLevel(level)


def _local() -> dict[str, Any]:
    return {
        "n_workers": usable_cores(),
        "threads_per_worker": 1,
        "host": "127.0.0.1",
        "dashboard_address": "127.0.0.1:0",
        "worker_dashboard_address": "127.0.0.1:0",
        # Dask would end workers at its own limit. The package estimates memory before a run.
        "memory_limit": 0,
        "silence_logs": "CRITICAL",
    }


# The executor itself:


class ClusterExecutor(Executor):
    """An executor on a connected Dask client; see `cluster`.

    One thread talks to Dask. It is woken by new work, by finished work, and once a second. The
    probe says what a worker must have; `tell` gets each sentence for the user.
    """

    def __init__(
        self, client: Any, probe: Probe, *, tell: Callable[[str], None] = warnings.warn
    ) -> None:
        self._client, self._probe, self._tell = client, probe, tell
        self._resource = f"matrixworld-{secrets.token_hex(8)}"
        self._waiting: deque[tuple[Future[Any], Callable[[], Any]]] = deque()
        self._begun: dict[Any, Future[Any]] = {}
        self._threads = 0
        self._looked, self._alone_since = 0.0, monotonic()
        self._lost: ClusterLostError | None = None
        self._ended = self._closed = False
        self._wake = Event()
        self._thread = Thread(target=self._serve, name="cluster", daemon=True)

    # Called by the thread that hands in work:

    def start(self) -> None:
        """Wait for a first worker and check all; UnfitWorkerError if one is unfit."""
        try:
            self._client.wait_for_workers(1, timeout=FIRST_WORKER_SECONDS)
        except (TimeoutError, asyncio.TimeoutError) as error:
            raise OSError(
                f"cluster: no worker has joined {self._scheduler} within {FIRST_WORKER_SECONDS} s"
            ) from error
        try:
            self._client.register_plugin(_check(self._probe, self._resource))
        except OSError:  # a worker has died, or the connection is lost
            raise
        except Exception as error:
            raise UnfitWorkerError(f"cluster: {error}") from error
        self._client.subscribe_topic(self._resource, self._hear)
        self._look()
        self._thread.start()

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Return the future of a call of a function that the workers can import.

        Until a worker takes the work it can be cancelled.
        """
        if self._ended:
            raise self._lost or RuntimeError("submit: expected an executor that is not shut down")
        future: Future[Any] = Future()
        self._waiting.append((future, partial(fn, *args, **kwargs)))
        self._wake.set()
        if self._lost is not None:  # in the meantime
            self._fail_waiting(self._lost)
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Take no more work; see `concurrent.futures.Executor`."""
        if cancel_futures:
            with suppress(IndexError):
                while True:
                    self._waiting.popleft()[0].cancel()
        self._ended = True
        self._wake.set()
        if wait and self._thread.is_alive():
            self._thread.join()

    def close(self) -> None:
        """Drop all work that has not begun, and wait a while for the rest."""
        self.shutdown(wait=False, cancel_futures=True)
        if self._thread.is_alive():
            self._thread.join(STOP_SECONDS)
        self._closed = True
        if self._lost is None:
            self._client.unregister_worker_plugin(self._resource)

    # Called by the executor's own thread:

    def _serve(self) -> None:
        try:
            while not self._closed and (self._begun or self._waiting or not self._ended):
                self._wake.wait(LOOK_SECONDS)
                self._wake.clear()
                self._take_results()
                if monotonic() - self._looked >= LOOK_SECONDS:
                    self._look()
                self._hand_out()
        except OSError:
            self._lose(f"the connection to {self._scheduler} was lost")
        except Exception as error:  # noqa: BLE001, or those who wait for results would wait forever
            self._lose(repr(error))

    def _hand_out(self) -> None:
        while self._waiting and len(self._begun) < self._threads:
            future, call = self._waiting.popleft()
            if not future.set_running_or_notify_cancel():
                continue
            key = f"matrixworld-{secrets.token_hex(8)}"
            given = self._client.submit(call, key=key, pure=False, resources={self._resource: 1})
            self._begun[given] = future
            given.add_done_callback(lambda given: self._wake.set())

    def _take_results(self) -> None:
        for given in [given for given in self._begun if given.done()]:
            if given.status == "cancelled":
                self._lose(f"the connection to {self._scheduler} was lost")
                return
            if given.status == "error":
                self._begun.pop(given).set_exception(_in_words(given.exception()))
                continue
            # Else its worker was lost with the result, and Dask does the work again.
            with suppress(TimeoutError, asyncio.TimeoutError):
                result = given.result(timeout=RESULT_SECONDS)
                self._begun.pop(given).set_result(result)

    def _look(self) -> None:
        """Count the threads of fit workers."""
        resource = self._resource

        # Sent with its code: a scheduler may lack this package.
        def threads(dask_scheduler: Any) -> int:
            return int(sum(dask_scheduler.resources.get(resource, {}).values()))

        before, self._threads = self._threads, self._client.run_on_scheduler(threads)
        self._looked = now = monotonic()
        if self._threads:
            return
        if before:
            self._alone_since = now
            self._tell(f"No worker is left at {self._scheduler}; waiting for one to join.")
        elif now - self._alone_since > NO_WORKER_SECONDS:
            self._lose(f"{self._scheduler} has had no worker for {NO_WORKER_SECONDS:.0f} s")

    def _hear(self, event: tuple[float, tuple[str, str]]) -> None:
        _, (worker, problem) = event
        self._tell(f"Worker {worker} gets no work: {problem}.")

    def _lose(self, reason: str) -> None:
        """Give up: the connection has gone, and with it all work on the way."""
        self._lost = ClusterLostError(f"cluster: {reason}; what is saved stays")
        self._ended = True
        for future in self._begun.values():
            future.set_exception(self._lost)
        self._begun.clear()
        self._fail_waiting(self._lost)

    def _fail_waiting(self, error: ClusterLostError) -> None:
        """Fail the work that no worker has taken: two threads may call this at one time."""
        with suppress(IndexError):
            while True:
                future, _ = self._waiting.popleft()
                if future.set_running_or_notify_cancel():
                    future.set_exception(error)

    @property
    def _scheduler(self) -> str:
        return f"the scheduler {self._client.scheduler.address}"


def _in_words(error: BaseException) -> BaseException:
    """Return an error of a piece of work; that of a killed worker in one sentence."""
    from distributed import KilledWorker

    if not isinstance(error, KilledWorker):
        return error
    return WorkerDiedError(
        f"{error.allowed_failures + 1} workers died while they did it, the last one at "
        f"{error.last_worker.address}"
    )


def _check(probe: Probe, resource: str) -> Any:
    """Return the plugin by which each worker checks itself: now, or when it joins."""
    from distributed import WorkerPlugin
    from distributed.core import Status

    asked = pickle.dumps(probe)

    def problem_here() -> str:
        try:
            return str(pickle.loads(asked).problem())  # noqa: S301, from the client
        except Exception as error:  # noqa: BLE001, such as a package that is not installed
            return str(error)

    # A local class, which Dask sends with its code: a worker may lack this package.
    class Check(WorkerPlugin):
        name = resource

        async def setup(self, worker: Any) -> None:
            # Not in the thread that tells the scheduler that the worker lives.
            problem = await asyncio.to_thread(problem_here)
            if problem:
                worker.log_event(resource, (worker.address, problem))
                raise RuntimeError(f"worker {worker.address} cannot take part: {problem}")
            await worker.set_resources(**{resource: worker.state.nthreads})
            # Dask looks for work that waits when a worker begins to run, not at a new resource.
            worker.status = Status.paused
            worker.status = Status.running

    return Check()
