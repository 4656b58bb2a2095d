# SPDX-License-Identifier: MIT OR Apache-2.0
"""How to run a build, and what the check of a structure found.

On the main thread a build runs in a thread of its own while this one waits, so that Ctrl-C is heard at once: it
cancels the build, and KeyboardInterrupt comes out of the call as soon as the library has stopped, which is within
50 ms. So does whatever a progress function raises, which is always called on the thread that asked for the build.
"""

from __future__ import annotations

import _thread
import ctypes
import dataclasses
import sys
import threading
from typing import TYPE_CHECKING, Any, Callable, Optional, TypedDict

import numpy as np

from . import _ffi
from ._library import lib
from ._ffi import ErrorKind, Status
from .error import MedaxError, check
from .handle import Handle, options, report_of, told

if TYPE_CHECKING:
    from typing_extensions import Unpack

#: Called with how far a build is, in [0, 1], and what it is doing; False cancels it, anything else goes on.
Progress = Callable[[float, str], Any]

#: Seconds between two looks at a build.
INTERVAL = 0.05


class How(TypedDict, total=False):
    """How to run a build: a `job`, or the settings of a fresh one.

    - `job`: the `Job` to run in, which can be cancelled and watched from other threads; a fresh one.
    - `progress`: called as `progress(fraction, stage)`; to return False cancels; none.
    - `threads`: the most threads; 0: what MEDAX_THREADS says, or one per processor.
    - `memory_ceiling`: the most bytes that the build's own arrays may take at once; 0: no ceiling.
    """

    job: Optional[Job]
    progress: Optional[Progress]
    threads: Optional[int]
    memory_ceiling: Optional[int]


@dataclasses.dataclass(frozen=True)
class StageTime:
    """How long a stage of a build took, in seconds: elapsed, and of the processor for the whole process."""

    stage: str
    wall_seconds: float
    cpu_seconds: float


class Job(Handle, stem="job"):
    """How to run builds, and the handle to watch or cancel them from any thread.

    - `threads`: the most threads that builds may use; 0: what MEDAX_THREADS says, or one per processor.
    - `memory_ceiling`: the most bytes that a build's own arrays may take at once; 0: no ceiling.
    - `progress`: called as `progress(fraction, stage)` at most twenty times a second, and once more with 1 at the
      end; to return False, or to raise, cancels the build.

    A job runs one build at a time. A cancelled job is spent.
    """

    def __init__(
        self,
        *,
        threads: Optional[int] = None,
        memory_ceiling: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> None:
        if progress is not None and not callable(progress):
            raise TypeError(f"progress must be callable, not {progress!r}")
        given = options(_ffi.medax_job_options, threads=threads, memory_ceiling=memory_ceiling)
        slot = self._slot()
        check(lib.medax_job_create(ctypes.byref(given), ctypes.byref(slot)))
        self._reference = self._take(slot)._reference
        self._on_progress = progress

    def clone(self) -> Job:
        """Another object for the same job."""
        made = super().clone()
        made._on_progress = self._on_progress
        return made

    def cancel(self) -> None:
        """Asks the running build, and every later one, to stop within 50 ms."""
        self._get("cancel")

    @property
    def is_cancelled(self) -> bool:
        """Whether the job was cancelled."""
        return bool(self._get("is_cancelled"))

    @property
    def progress(self) -> float:
        """How far the running build is, or the last one came, in [0, 1]."""
        return float(self._get("progress"))

    @property
    def stage(self) -> str:
        """What the running build is doing, such as `triangulate`; `idle` before the first one."""
        return str(self._get("stage").decode())

    @property
    def memory_peak(self) -> int:
        """The most bytes that the arrays of one build took at once."""
        return int(self._get("memory_peak"))

    def times(self) -> list[StageTime]:
        """The time of every stage of every build so far."""
        times = []
        stage, wall, cpu = ctypes.c_char_p(), ctypes.c_double(), ctypes.c_double()
        for index in range(self._get("stage_count")):
            check(
                lib.medax_job_stage_time(self._ref, index, ctypes.byref(stage), ctypes.byref(wall), ctypes.byref(cpu))
            )
            times.append(StageTime((stage.value or b"").decode(), wall.value, cpu.value))
        return times

    def _told(self) -> str:
        cancelled = ", cancelled" if self.is_cancelled else ""
        return f": {self.stage}, {self.progress:.0%}{cancelled}"


def _job_of(how: How) -> Job:
    unknown = set(how) - set(How.__annotations__)
    if unknown:
        raise TypeError(f"no option is called {', '.join(sorted(unknown))}")
    job = how.get("job")
    settings = {name: value for name, value in how.items() if name != "job" and value is not None}
    if job is None:
        return Job(**settings)  # type: ignore[arg-type]
    if not isinstance(job, Job):
        raise TypeError(f"job must be a medax.Job, not {type(job).__name__}")
    if settings:
        raise TypeError(f"a job has its own {', '.join(settings)}: give them to medax.Job")
    return job


def run(how: How, call: Callable[[Any], int]) -> None:
    """Runs `call(job)`, a call of the library that takes long; raises what it failed with."""
    job = _job_of(how)
    reference = job._ref
    progress = job._on_progress
    if progress is None and threading.current_thread() is not threading.main_thread():
        check(call(reference))
        return

    outcome: list[Optional[BaseException]] = []
    claim, done = _thread.allocate_lock(), _thread.allocate_lock()
    done.acquire()

    def work() -> None:
        if not claim.acquire(False):
            return
        try:
            status = call(reference)
            # The error is this thread's: it is read here.
            outcome.append(None if status == Status.OK else MedaxError.last(status))
        except BaseException as error:
            outcome.append(error)
        finally:
            done.release()

    try:
        try:
            _thread.start_new_thread(work, ())
        except RuntimeError:
            # There are no threads while the interpreter shuts down.
            work()
        # What counts is the outcome: an interrupt may come between the end of a wait and the look at it.
        while not outcome:
            if not done.acquire(timeout=INTERVAL) and progress is not None:
                said = progress(job.progress, job.stage)
                if isinstance(said, (bool, np.bool_)) and not said:
                    job.cancel()
        if outcome[0] is None and progress is not None:
            progress(1.0, job.stage)
    except BaseException:
        lib.medax_job_cancel(reference)
        # Without the claim the thread has never begun, and never will.
        while not outcome and not claim.acquire(False):
            try:
                done.acquire(timeout=INTERVAL)
            except KeyboardInterrupt:
                continue
        raise
    if outcome[0] is not None:
        raise outcome[0]


def build(kind: Any, how: How, function: Any, *inputs: Any, after: tuple[Any, ...] = ()) -> Any:
    """A handle that a function makes of its inputs, a job, and what comes after the job."""
    slot = kind._slot()
    try:
        run(how, lambda job: int(function(*inputs, job, *after, ctypes.byref(slot))))
    except BaseException:
        # The build may have been done when the interrupt came.
        if slot:
            kind._take(slot)
        raise
    return kind._take(slot)


@dataclasses.dataclass(frozen=True)
class Validation:
    """What the check of a structure found: the number of conditions checked, of those that do not hold, and the first
    of these. To find a problem is no error."""

    checked: int
    problems: int
    first_index: Optional[int]
    first_kind: ErrorKind
    first_message: str

    @property
    def is_valid(self) -> bool:
        """Whether no problem was found."""
        return self.problems == 0


class Validated(Handle):
    """A structure that can check itself."""

    def validate(self, **how: Unpack[How]) -> Validation:
        """Checks what the structure promises, element by element, by other means than those that made it."""
        reference = self._ref
        report = report_of(_ffi.medax_validation)
        function = getattr(lib, self._stem + "_validate")
        run(how, lambda job: int(function(reference, job, ctypes.byref(report))))
        none = report.first_kind == ErrorKind.NONE
        return told(
            Validation,
            report,
            first_index=None if none else report.first_index,
            first_kind=ErrorKind(report.first_kind),
        )


class ProgressBar:
    """A bar that shows how far a build is: tqdm's, if that is installed, else a line on stderr.

    with medax.progress_bar() as bar:
        crust = PowerCrust.of(points, progress=bar)
    """

    def __init__(self, title: str = "medax", **tqdm_options: Any) -> None:
        self._title = title
        self._bar: Any = None
        self._shown = False
        try:
            from tqdm.auto import tqdm
        except ImportError:
            return
        form = "{desc}: {percentage:3.0f}%|{bar}| {elapsed}{postfix}"
        self._bar = tqdm(**{"total": 1.0, "desc": title, "bar_format": form, **tqdm_options})

    def __call__(self, fraction: float, stage: str) -> None:
        if self._bar is None:
            self._shown = True
            print(f"\r{self._title}: {fraction:4.0%} {stage:<30}", end="", file=sys.stderr, flush=True)
            return
        self._bar.n = fraction
        self._bar.set_postfix_str(stage, refresh=False)
        self._bar.refresh()

    def close(self) -> None:
        """Ends the bar."""
        if self._bar is not None:
            self._bar.close()
        elif self._shown:
            print(file=sys.stderr)
            self._shown = False

    def __enter__(self) -> ProgressBar:
        return self

    def __exit__(self, *exception: Any) -> None:
        self.close()


def progress_bar(title: str = "medax", **tqdm_options: Any) -> ProgressBar:
    """A `ProgressBar`, to be passed as `progress=`."""
    return ProgressBar(title, **tqdm_options)
