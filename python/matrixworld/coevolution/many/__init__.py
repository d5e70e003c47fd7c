"""Many runs at one call: side by side on this machine, or wherever an executor carries them.

=================  ===============================================================================
module             contents
=================  ===============================================================================
evolve_many        `evolve_many`: check, play and open many runs; `FailedRunsError`
best_responses     `best_responses`: responses to the champions of many runs
watch              hands out tasks, watches the files, stops and collects
local_executor     `LocalExecutor`: worker processes of this machine, which may die
run_task           `run_task`: one run, wherever it is called
stop_mark          `StopMark`: by which tasks know that they shall end
run_progress       progress of runs in work, in tiny files
progress_bars      `ProgressBars` shows it on a terminal
job                `Job`: the runs that were asked for, and the file that says so
=================  ===============================================================================
"""

from __future__ import annotations

from matrixworld.coevolution.many.best_responses import best_responses
from matrixworld.coevolution.many.evolve_many import FailedRunsError, evolve_many
from matrixworld.coevolution.many.job import JOB, Job, job_of, open_job
from matrixworld.coevolution.many.local_executor import LocalExecutor, WorkerDiedError
from matrixworld.coevolution.many.progress_bars import ProgressBars
from matrixworld.coevolution.many.run_progress import RunProgress
from matrixworld.coevolution.many.run_task import run_task
from matrixworld.coevolution.many.stop_mark import StopMark, StoppedError
from matrixworld.coevolution.many.watch import JobProgress, JobReport

__all__ = [
    "JOB",
    "FailedRunsError",
    "Job",
    "JobProgress",
    "JobReport",
    "LocalExecutor",
    "ProgressBars",
    "RunProgress",
    "StopMark",
    "StoppedError",
    "WorkerDiedError",
    "best_responses",
    "evolve_many",
    "job_of",
    "open_job",
    "run_task",
]
