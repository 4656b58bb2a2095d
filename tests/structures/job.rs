//! Jobs: progress, cancel, busy, memory.

use crate::sets;
use medax::{Job, JobOptions, Points, PowerCrust, Stage, Status, Triangulation};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

fn cloud(n: usize) -> Arc<Points> {
    let mut random = sets::Random(1);
    let rows: Vec<_> = (0..n).map(|_| random.cube()).collect();
    Arc::new(Points::new(&rows, Default::default(), &Job::default()).unwrap())
}

fn job_with(progress: impl Fn(f64, Stage) -> bool + Send + Sync + 'static) -> Job {
    Job::new(JobOptions { progress: Some(Box::new(progress)), ..Default::default() })
}

#[test]
fn progress_rises_to_one_on_the_calling_thread() {
    let seen = Arc::new(Mutex::new(Vec::new()));
    let record = seen.clone();
    let job = job_with(move |fraction, stage| {
        record.lock().unwrap().push((fraction, stage, thread::current().id()));
        true
    });
    let begin = Instant::now();
    PowerCrust::build(&cloud(20_000), Default::default(), &job).unwrap();
    let seconds = begin.elapsed().as_secs_f64();
    let seen = seen.lock().unwrap();
    assert!(!seen.is_empty() && (seen.len() as f64) < 21.0 * seconds + 2.0);
    assert!(seen.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    assert!(seen.iter().all(|(f, _, id)| (0.0..=1.0).contains(f) && *id == thread::current().id()));
    assert_eq!(job.progress(), 1.0);
    let stages: Vec<_> = job.times().iter().map(|time| time.stage).collect();
    for stage in [Stage::Triangulate, Stage::Poles, Stage::Regular, Stage::Label, Stage::Extract] {
        assert!(stages.contains(&stage), "{stage:?} is missing from {stages:?}");
    }
    assert!(job.times().iter().map(|time| time.wall_seconds).sum::<f64>() <= seconds);
}

#[test]
fn the_callback_can_cancel() {
    let calls = Arc::new(AtomicU32::new(0));
    let count = calls.clone();
    let job = job_with(move |_, _| {
        count.fetch_add(1, Ordering::Relaxed);
        false
    });
    let error = Triangulation::delaunay(&cloud(200_000), &job).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
    assert_eq!(calls.load(Ordering::Relaxed), 1);
    assert!(job.is_cancelled());
}

#[test]
fn a_cancelled_job_is_spent() {
    let job = Arc::new(Job::default());
    let points = cloud(300_000);
    let build = {
        let job = job.clone();
        thread::spawn(move || {
            Triangulation::delaunay(&points, &job).map(|_| ()).unwrap_err().status()
        })
    };
    while job.progress() < 0.1 && !build.is_finished() {
        thread::sleep(Duration::from_millis(1));
    }
    assert_eq!(job.stage(), Stage::Triangulate);
    job.cancel();
    assert_eq!(build.join().unwrap(), Status::Cancelled);
    let again = Triangulation::delaunay(&cloud(10), &job).unwrap_err();
    assert_eq!(again.status(), Status::Cancelled);
}

#[test]
fn a_job_runs_one_build_at_a_time() {
    let job = Job::default();
    job.run(&[(Stage::Query, 1.0)], |_| {
        let error = Triangulation::delaunay(&cloud(10), &job).unwrap_err();
        assert_eq!(error.status(), Status::Busy);
        Ok(())
    })
    .unwrap();
    Triangulation::delaunay(&cloud(10), &job).unwrap();
}

#[test]
fn memory_is_given_back() {
    let job = Job::new(JobOptions { memory_ceiling: 1000, ..Default::default() });
    job.run(&[], |run| {
        let first = run.charge(600).unwrap();
        assert_eq!(run.charge(401).map(|_| ()).unwrap_err().status(), Status::OutOfMemory);
        drop(first);
        run.charge(1000).map(|_| ())
    })
    .unwrap();
    assert_eq!(job.memory_peak(), 1000);
}

#[test]
fn no_job_has_more_threads_than_it_can_have() {
    for (asked, given) in [(1, 1), (7, 7), (1_000_000_000, 1024)] {
        let job = Job::new(JobOptions { threads: asked, ..JobOptions::default() });
        assert_eq!(job.threads(), given);
    }
}
