//! What all commands share: the common options, the job, reading and writing.

use crate::progress::Bar;
use crate::report::{Input, Output, Report};
use medax::io::{self, Format, Soup, WriteOptions};
use medax::points::{Points, PointsOptions};
use medax::{Complex, Error, Job, JobOptions, Status, Validation};
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The options that every command takes.
#[derive(clap::Args)]
pub struct Options {
    /// Threads to use at most; 0 means what MEDAX_THREADS says, or one per processor
    #[arg(long, global = true, value_name = "N", default_value_t = 0)]
    threads: usize,
    /// The most memory that a build's own arrays may take, in MiB; 0 means no ceiling
    #[arg(long, global = true, value_name = "MIB", default_value_t = 0)]
    memory_mib: u64,
    /// Print one JSON object on standard output instead of a table
    #[arg(long, global = true)]
    pub json: bool,
    /// Print nothing but errors, and the JSON object where that is asked for
    #[arg(long, short, global = true)]
    pub quiet: bool,
}

/// How a file of points is read.
#[derive(clap::Args)]
pub struct ReadOptions {
    /// Leave out rows with a NaN or an infinity instead of failing
    #[arg(long)]
    pub skip_invalid: bool,
}

impl ReadOptions {
    pub fn describe(&self, parameters: &mut Map<String, Value>) {
        parameters.insert("skip_invalid".into(), json!(self.skip_invalid));
    }

    pub fn points_options(&self) -> PointsOptions {
        PointsOptions { skip_non_finite: self.skip_invalid }
    }
}

/// How results are written.
#[derive(clap::Args)]
pub struct OutputOptions {
    /// Where to write the result; the ending says in which format. Without it the result is
    /// described only
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Write PLY as text instead of binary
    #[arg(long)]
    text: bool,
}

impl OutputOptions {
    pub fn describe(&self, parameters: &mut Map<String, Value>) {
        parameters.insert("text".into(), json!(self.text));
    }

    /// Refuses, before any work, files that could not be written or that would overwrite each
    /// other.
    pub fn check<'a>(&'a self, more: &[&'a Option<PathBuf>]) -> Result<(), Failure> {
        let mut seen: Vec<PathBuf> = Vec::new();
        for path in [&self.output].into_iter().chain(more.iter().copied()).flatten() {
            let shown = path.display();
            let format = Format::of_path(path)
                .map_err(|error| Failure::usage(format!("'{shown}': {}", error.message())))?;
            if !format.is_written() {
                let name = format.name();
                return Err(Failure::usage(format!("'{shown}': medax does not write {name}")));
            }
            let folder = path.parent().filter(|folder| *folder != Path::new(""));
            if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
                let message = format!("there is no folder '{}' to write to", folder.display());
                return Err(Failure::about(path)(Error::new(Status::Io, message)));
            }
            let target = io::target(path).map_err(Failure::about(path))?;
            if seen.contains(&target) {
                return Err(Failure::usage(format!("'{shown}' is named as two outputs")));
            }
            seen.push(target);
        }
        Ok(())
    }
}

/// Whether a structure is checked before it is written.
#[derive(clap::Args)]
pub struct ValidateOptions {
    /// Check the structure before writing it, by other means than those that made it; fail if anything is wrong
    #[arg(long)]
    validate: bool,
}

impl ValidateOptions {
    /// Runs the check where it is asked for, and reports it.
    pub fn report(
        &self,
        report: &mut Report,
        validate: impl FnOnce() -> medax::Result<Validation>,
    ) -> Result<(), Failure> {
        report.parameters.insert("validate".into(), json!(self.validate));
        if !self.validate {
            return Ok(());
        }
        let found = validate()?;
        if let Some((kind, index, message)) = found.first {
            let message = format!("{} of {} checks fail: {message}", found.problems, found.checked);
            return Err(Error::new(Status::Internal, message).at(kind, index).into());
        }
        report.more.insert("validation".into(), json!({ "checked": found.checked, "problems": 0 }));
        report.lines.push(("validation", format!("{} checks hold", found.checked)));
        Ok(())
    }
}

/// Why a command failed: the error, the file that it is about, and whether the command line itself was
/// at fault.
pub struct Failure {
    pub error: Error,
    pub path: Option<PathBuf>,
    pub usage: bool,
}

impl Failure {
    /// The command line makes no sense.
    pub fn usage(message: impl Into<String>) -> Self {
        Failure { error: Error::new(Status::InvalidArgument, message), path: None, usage: true }
    }

    /// The error is about a file.
    pub fn about(path: &Path) -> impl Fn(Error) -> Failure {
        move |error| Failure { error, path: Some(path.to_path_buf()), usage: false }
    }

    /// The same, said of the file with the sample where it is the sample that nothing can be made of.
    pub fn of_sample(mut self, session: &Session) -> Self {
        let of_sample = [Status::Degenerate, Status::TooFewPoints, Status::CoordinateRange];
        if of_sample.contains(&self.error.status()) {
            self.path = self.path.or_else(|| session.sample.clone());
        }
        self
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        // What the library calls an invalid argument came from the command line.
        let usage = error.status() == Status::InvalidArgument;
        Failure { error, path: None, usage }
    }
}

/// Ctrl-C and the signals to terminate cancel the job, so that no file is left half written. A second one
/// ends the program at once: it may be waiting for a pipe.
fn cancel_on_signals(job: &Arc<Job>) {
    let job = job.clone();
    // Where no handler can be set, the system's own stays.
    let _ = ctrlc::set_handler(move || {
        if job.is_cancelled() {
            std::process::exit(130);
        }
        job.cancel();
    });
}

/// One run of the program.
pub struct Session {
    pub job: Arc<Job>,
    bar: Bar,
    warnings: Vec<String>,
    parameters: Map<String, Value>,
    /// The file that the points are of.
    sample: Option<PathBuf>,
}

impl Session {
    pub fn new(options: &Options) -> Self {
        let bar = Bar::new(options.quiet);
        let job = Arc::new(Job::new(JobOptions {
            threads: options.threads,
            memory_ceiling: options.memory_mib.saturating_mul(1 << 20),
            progress: Some(bar.callback()),
        }));
        cancel_on_signals(&job);
        let mut parameters = Map::new();
        parameters.insert("threads".into(), json!(job.threads()));
        parameters.insert("memory_mib".into(), json!(options.memory_mib));
        Session { job, bar, warnings: Vec::new(), parameters, sample: None }
    }

    /// Ends the work: takes the progress bar off the screen.
    pub fn finish(&self) {
        self.bar.clear();
    }

    /// The common options in effect, as the report shows them.
    pub fn parameters(&self) -> Map<String, Value> {
        self.parameters.clone()
    }

    /// Says something that the user should know of a result that is no failure.
    pub fn warn(&mut self, warning: &str) {
        self.warnings.push(warning.into());
    }

    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Reads a file.
    pub fn read(&mut self, path: &Path) -> Result<Soup, Failure> {
        let soup = io::read(path, &self.job).map_err(Failure::about(path))?;
        self.warnings.extend_from_slice(soup.warnings());
        Ok(soup)
    }

    /// Makes a set of points of what a file holds.
    pub fn points(
        &mut self,
        path: &Path,
        soup: &Soup,
        options: &ReadOptions,
    ) -> Result<(Arc<Points>, Input), Failure> {
        let points = soup.points(options.points_options(), &self.job).map_err(|error| {
            let hint = match error.status() {
                Status::NonFinite => format!("{} (--skip-invalid)", error.message()),
                _ => error.message().into(),
            };
            let said = Error::new(error.status(), hint);
            Failure::about(path)(
                error.element().map_or(said.clone(), |(kind, index)| said.at(kind, index)),
            )
        })?;
        let input = Input::of_points(path, soup, &points);
        self.sample = Some(path.to_path_buf());
        Ok((Arc::new(points), input))
    }

    /// Makes a complex of what a file holds.
    pub fn complex(&mut self, path: &Path, soup: Soup) -> Result<Complex, Failure> {
        soup.into_complex().map_err(Failure::about(path))
    }

    /// Reads a file as a complex.
    pub fn read_complex(&mut self, path: &Path) -> Result<Complex, Failure> {
        let soup = self.read(path)?;
        self.complex(path, soup)
    }

    /// Writes a result where a path is given, and describes it in any case.
    pub fn deliver(
        &mut self,
        name: &'static str,
        complex: &Complex,
        path: Option<&Path>,
        options: &OutputOptions,
    ) -> Result<Output, Failure> {
        if let Some(path) = path {
            let options = WriteOptions { text: options.text };
            let warnings = io::write_complex(path, complex, options, &self.job)
                .map_err(Failure::about(path))?;
            self.warnings.extend(warnings.iter().map(|w| format!("'{}': {w}", path.display())));
        }
        Ok(Output {
            name,
            path: path.map(Path::to_path_buf),
            counts: complex.into(),
            topology: complex.topology(&self.job)?,
        })
    }
}
