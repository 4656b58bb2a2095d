# SPDX-License-Identifier: MIT OR Apache-2.0
"""Progress, cancelling, and the other settings of jobs."""

import io
import os
import signal
import sys
import threading
import time

import numpy as np
import pytest

import medax

LIMIT = 0.1


@pytest.fixture(scope="module")
def million():
    return np.random.default_rng(3).random((1_000_000, 3))


@pytest.fixture(scope="module")
def million_points(million):
    return medax.Points(million)


@pytest.fixture(autouse=True)
def ctrl_c():
    """Whoever runs tests in the background of a shell has them ignore Ctrl-C."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def quickest(attempt, tries=4):
    """The least of some measured times: other programs may have the processors meanwhile."""
    taken = []
    while len(taken) < tries:
        taken.append(attempt())
        if taken[-1] < LIMIT:
            break
    return min(taken)


def when(job, fraction, act):
    """A thread that acts once the job is so far: seconds would be others on another machine."""

    def wait():
        while job.stage == "idle" or job.progress < fraction:
            time.sleep(0.001)
        act()

    thread = threading.Thread(target=wait)
    thread.start()
    return thread


def interrupted(build, fraction, **settings):
    """Seconds from Ctrl-C, when `build(job)` is so far, to KeyboardInterrupt."""
    job, sent = medax.Job(threads=2, **settings), []

    def send():
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    sender = when(job, fraction, send)
    with pytest.raises(KeyboardInterrupt):
        build(job)
    taken = time.perf_counter() - sent[0]
    sender.join()
    return taken


@pytest.mark.parametrize("fraction", [0, 0.1, 0.4, 0.7])
def test_ctrl_c_cancels_a_million_points(million_points, fraction):
    taken = quickest(lambda: interrupted(lambda job: medax.Triangulation.delaunay(million_points, job=job), fraction))
    print(f"interrupted at {fraction:.0%}: {taken * 1000:.0f} ms")
    assert taken < LIMIT


def test_ctrl_c_cancels_reading_an_array(million):
    assert quickest(lambda: interrupted(lambda job: medax.Points(million, job=job), 0.1)) < LIMIT


def test_ctrl_c_with_a_progress_function(million_points):
    def build(job):
        medax.Triangulation.delaunay(million_points, job=job)

    assert quickest(lambda: interrupted(build, 0.3, progress=lambda fraction, stage: None)) < LIMIT


@pytest.mark.parametrize("how", ["false", "raise"])
@pytest.mark.parametrize("least", [0.1, 0.6])
def test_the_hook_stops_a_million_points(million_points, how, least):
    def attempt():
        stopped = []

        def hook(fraction, stage):
            if fraction >= least:
                stopped.append(time.perf_counter())
                if how == "raise":
                    raise RuntimeError("enough")
                return False

        with pytest.raises(RuntimeError if how == "raise" else medax.MedaxError) as caught:
            medax.Triangulation.delaunay(million_points, threads=2, progress=hook)
        taken = time.perf_counter() - stopped[0]
        if how == "false":
            assert caught.value.status == medax.Status.CANCELLED
        else:
            assert str(caught.value) == "enough" and len(stopped) == 1
        return taken

    taken = quickest(attempt)
    print(f"stopped by {how} at {least:.0%}: {taken * 1000:.0f} ms")
    assert taken < LIMIT


def test_false_of_numpy_stops_and_nothing_else_does(million_points):
    with pytest.raises(medax.MedaxError):
        medax.Triangulation.delaunay(million_points, progress=lambda fraction, stage: np.bool_(False))
    for other in (0, None, np.bool_(True), ""):
        medax.Triangulation.delaunay(
            medax.Points(million_points.coords[:100_000]), progress=lambda fraction, stage, other=other: other
        )


@pytest.mark.parametrize("where", ["main", "other"])
def test_a_job_is_cancelled_from_another_thread(million_points, where):
    def attempt():
        job, cancelled, ended = medax.Job(threads=2), [], []

        def build():
            with pytest.raises(medax.MedaxError) as caught:
                medax.Triangulation.delaunay(million_points, job=job)
            ended.append((time.perf_counter(), caught.value.status))

        def cancel():
            cancelled.append(time.perf_counter())
            job.cancel()

        if where == "main":
            other = when(job, 0.3, cancel)
            build()
        else:
            other = threading.Thread(target=build)
            other.start()
            when(job, 0.3, cancel).join()
        other.join()
        assert ended[0][1] == medax.Status.CANCELLED and job.is_cancelled
        with pytest.raises(medax.MedaxError):
            medax.Points([[0, 0, 0]], job=job)
        return ended[0][0] - cancelled[0]

    assert quickest(attempt) < LIMIT


def test_what_is_cancelled_leaves_nothing_behind(million_points):
    """The structure works on, and the next build with it."""
    with pytest.raises(medax.MedaxError):
        medax.Triangulation.delaunay(million_points, progress=lambda fraction, stage: False)
    assert million_points.count == 1_000_000
    with medax.Points(million_points.coords[:1000]) as few:
        assert medax.Triangulation.delaunay(few).validate().is_valid


def test_progress_is_told_on_the_calling_thread(random_points):
    points = medax.Points(np.tile(random_points, (100, 1)) + np.arange(100_000)[:, None] * 1e-4)
    for in_thread in (False, True):
        told = []

        def build(told=told):
            def hook(fraction, stage):
                told.append((fraction, stage, threading.get_ident()))

            medax.Triangulation.delaunay(points, progress=hook)
            told.append(threading.get_ident())

        if in_thread:
            thread = threading.Thread(target=build)
            thread.start()
            thread.join()
        else:
            build()
        ident = told.pop()
        assert {each[2] for each in told} == {ident}
        fractions = [each[0] for each in told]
        assert fractions == sorted(fractions) and fractions[-1] == 1 and 0 <= fractions[0]
        assert all(isinstance(stage, str) and stage for _, stage, _ in told)


def test_an_exception_at_the_end(torus):
    def hook(fraction, stage):
        if fraction == 1:
            raise LookupError("late")

    with pytest.raises(LookupError):
        medax.Dual.of(torus.triangulation, progress=hook)


def test_what_a_job_tells(random_points):
    job = medax.Job(threads=1, memory_ceiling=1 << 30)
    assert (job.stage, job.progress, job.times(), job.is_cancelled) == ("idle", 0, [], False)
    points = medax.Points(random_points, job=job)
    medax.Triangulation.delaunay(points, job=job)
    times = job.times()
    assert len(times) >= 2 and all(time.wall_seconds >= 0 and time.stage for time in times)
    assert job.memory_peak > 0 and job.progress == 1 and "100%" in repr(job)
    job.cancel()
    assert job.is_cancelled and "cancelled" in repr(job)


def test_memory_ceiling(million):
    with pytest.raises(medax.MedaxError) as caught:
        medax.Points(million, memory_ceiling=1000)
    assert caught.value.status == medax.Status.OUT_OF_MEMORY


def test_threads_change_nothing(random_points):
    points = medax.Points(random_points)
    cells = [medax.Triangulation.delaunay(points, threads=threads).cells for threads in (1, 3)]
    assert np.array_equal(*cells)


def test_a_busy_job(million_points):
    job = medax.Job()
    begun = threading.Event()
    thread = threading.Thread(
        target=lambda: (
            begun.set(),
            pytest.raises(medax.MedaxError, medax.Triangulation.delaunay, million_points, job=job),
        )
    )
    thread.start()
    begun.wait()
    while job.stage == "idle":
        time.sleep(0.001)
    with pytest.raises(medax.MedaxError) as caught:
        medax.Points([[0, 0, 0]], job=job)
    assert caught.value.status == medax.Status.BUSY
    job.cancel()
    thread.join()


def test_wrong_settings(torus):
    for wrong in ({"threads": -1}, {"threads": 1.5}, {"memory_ceiling": "1"}, {"threads": 2**32}):
        with pytest.raises(medax.ArgumentError):
            medax.Dual.of(torus.triangulation, **wrong)
    with pytest.raises(TypeError, match="no option is called speed"):
        medax.Dual.of(torus.triangulation, speed=2)
    with pytest.raises(TypeError, match="medax.Job"):
        medax.Dual.of(torus.triangulation, job=3)
    with pytest.raises(TypeError, match="has its own threads"):
        medax.Dual.of(torus.triangulation, job=medax.Job(), threads=1)
    with pytest.raises(TypeError, match="callable"):
        medax.Dual.of(torus.triangulation, progress=3)


def test_progress_bars(torus, monkeypatch):
    out = io.StringIO()
    with medax.progress_bar("torus", file=out) as bar:
        medax.PowerCrust.of(torus.points, progress=bar)
    assert "torus: 100%" in out.getvalue()
    # Without tqdm there is a line on stderr.
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    with medax.progress_bar("torus") as bar:
        medax.PowerCrust.of(torus.points, progress=bar)
        line = sys.stderr.getvalue()
    assert "torus: 100%" in line


def test_validations(torus):
    for structure in (torus.triangulation, torus.dual, torus.cocone, torus.medial, torus.flow, torus.pair, torus.crust):
        found = structure.validate(threads=1)
        assert found.is_valid and found.checked > 0 and found.first_index is None and found.first_message == ""
