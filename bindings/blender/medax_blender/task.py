# SPDX-License-Identifier: MIT OR Apache-2.0
"""Work in a thread of its own, which can be watched and cancelled; it knows nothing of Blender and needs no event loop."""

from __future__ import annotations

import enum
import threading
from typing import Any, Callable, Optional

import medax

#: How long a step waits for cancelled work, in seconds: the library stops within half of it.
PATIENCE = 0.1


class State(enum.Enum):
    WAITING = "waiting"
    RUNNING = "running"
    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"


class Steps:
    """How far work is: a job for each call of the library, with the share of the whole at which that call ends."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._job: Optional[medax.Job] = None
        self._from, self._until = 0.0, 0.0
        self._cancelled = False
        self.title = ""

    def job(self, until: float, title: str) -> medax.Job:
        """The job for the next call, which is `title` and ends at the share `until`."""
        job = medax.Job()
        with self._lock:
            self._from, self._until = self._until, until
            self._job, self.title = job, title
            if self._cancelled:
                job.cancel()
        return job

    def cancel(self) -> None:
        """Stops the running call and every later one."""
        with self._lock:
            self._cancelled = True
            if self._job is not None:
                self._job.cancel()

    @property
    def progress(self) -> float:
        """From 0 to 1."""
        with self._lock:
            share = 0.0 if self._job is None else self._job.progress
            return self._from + (self._until - self._from) * share


class Task:
    """`start`, then `step` until it is no longer `State.RUNNING`, then `finish`; `cancel` at any time."""

    def __init__(self, work: Callable[[Steps], Any]) -> None:
        self.steps = Steps()
        self._work = work
        self._thread = threading.Thread(target=self._run, name="medax", daemon=True)
        self._result: Any = None
        self._error: Optional[BaseException] = None
        self._cancelled = False

    def start(self) -> None:
        self._thread.start()

    def step(self) -> State:
        """What has become of it; waits only for what was cancelled, and not longer than PATIENCE."""
        if self._thread.ident is None:
            return State.WAITING
        if self._cancelled:
            self._thread.join(PATIENCE)
            return State.CANCELLED
        if self._thread.is_alive():
            return State.RUNNING
        return State.DONE if self._error is None else State.FAILED

    def cancel(self) -> None:
        self._cancelled = True
        self.steps.cancel()

    def finish(self) -> Any:
        """Waits for the end; the result, or an exception that tells why there is none."""
        try:
            while self._thread.is_alive() and not self._cancelled:
                # In slices, so that Ctrl-C is heard.
                self._thread.join(0.05)
        except BaseException:
            self.cancel()
            self._thread.join(PATIENCE)
            raise
        if self._error is not None:
            raise self._error
        return self._result

    def _run(self) -> None:
        try:
            self._result = self._work(self.steps)
        except BaseException as error:  # It is raised where the work was asked for.
            self._error = error
        finally:
            # What the work holds is freed here, not in the thread that draws the window.
            del self._work
