# SPDX-License-Identifier: MIT OR Apache-2.0
"""One run of an operator, from reading the object to writing the results: start, step by step, cancel, finish. It needs no
event loop: whoever has none calls `step` with events of his own, or `run`."""

from __future__ import annotations

from typing import Any, Callable

import medax

from . import host
from .recipes import Recipe, Refused
from .task import State, Task

#: Seconds between two steps.
INTERVAL = 0.05

#: Events that only change the view; all others wait for the end.
NAVIGATION = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "TRACKPADPAN", "TRACKPADZOOM", "NDOF_MOTION"}

Report = Callable[[set[str], str], None]


class Session:
    """`report` is an operator's own. Raises Refused if there is nothing to read; nothing has changed then, nor after a
    cancel, nor after an error."""

    def __init__(self, context: Any, recipe: Recipe, report: Report, hide: bool = True, material: bool = True) -> None:
        self.source = host.read(context)
        self._recipe, self._report, self._hide, self._material = recipe, report, hide, material
        given = self.source.input
        self.task = Task(lambda steps: recipe.cook(given, steps))
        self._timer: Any = None
        self.objects: list[Any] = []

    def start(self, context: Any) -> set[str]:
        """Begins; from now on `step` wants a timer's events."""
        manager = context.window_manager
        self._timer = manager.event_timer_add(INTERVAL, window=context.window)
        manager.progress_begin(0, 100)
        self.task.start()
        return {"RUNNING_MODAL"}

    def step(self, context: Any, event: Any) -> set[str]:
        """What a modal operator does and returns upon an event."""
        if event.type == "ESC" and event.value == "PRESS":
            self.task.cancel()
        elif event.type != "TIMER":
            return {"PASS_THROUGH"} if event.type in NAVIGATION else {"RUNNING_MODAL"}
        if self.task.step() is State.RUNNING:
            self._show(context)
            return {"RUNNING_MODAL"}
        return self.finish(context)

    def cancel(self, context: Any) -> set[str]:
        """Stops; nothing has changed."""
        self.task.cancel()
        self.task.step()
        return self.finish(context)

    def run(self, context: Any) -> set[str]:
        """All of it, without a step between."""
        self.task.start()
        return self.finish(context)

    def finish(self, context: Any) -> set[str]:
        """Waits for the end and writes the results, or reports why there are none."""
        try:
            result = self.task.finish()
            if self.task.step() is State.CANCELLED:
                self._report({"INFO"}, f"{self._recipe.title}: cancelled")
                return {"CANCELLED"}
            self.objects = host.write(context, self.source, result.parts, self._hide, self._material)
        except (medax.MedaxError, Refused) as error:
            if self.task.step() is State.CANCELLED:
                self._report({"INFO"}, f"{self._recipe.title}: cancelled")
            else:
                self._report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            self._hide_progress(context)
        lengths = (host.length(context, value) for value in result.lengths)
        self._report({"INFO"}, f"{self._recipe.title}: {result.text.format(*lengths)}")
        return {"FINISHED"}

    def _show(self, context: Any) -> None:
        share = self.task.steps.progress
        context.window_manager.progress_update(int(100 * share))
        if context.workspace is not None:
            text = f"{self._recipe.title}: {self.task.steps.title}, {share:.0%}    Esc: cancel"
            context.workspace.status_text_set(text)

    def _hide_progress(self, context: Any) -> None:
        if self._timer is None:
            return
        manager = context.window_manager
        manager.event_timer_remove(self._timer)
        self._timer = None
        manager.progress_end()
        if context.workspace is not None:
            context.workspace.status_text_set(None)
