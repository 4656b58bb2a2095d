//! `medax flow`: the flow of the distance to the samples, cores, critical points and orbits.

use crate::extend::Extend;
use crate::labels::LabelArguments;
use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use crate::side::Side;
use medax::dual::{Dual, DualOptions};
use medax::flow::{Core, CoreOptions, CriticalClass, Flow, FlowComplex, FlowOptions};
use medax::medial::{self, Medial, MedialOptions};
use medax::{Complex, ElementKind, Error, Status, Triangulation};
use serde_json::{Map, json};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Find the core of a solid: an axis with the right topology (Giesen, Ramos and Sadri)
#[derive(clap::Args)]
pub struct Options {
    /// A file of points; of a mesh the vertices that it uses
    input: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    output: OutputOptions,
    #[command(flatten)]
    what: What,
    /// The side of the surface whose core is written
    #[arg(long, value_enum, default_value_t = Side::Inner, conflicts_with_all = NO_CORE)]
    side: Side,
    #[command(flatten)]
    labels: LabelArguments,
    /// Extend the core by the flow of the Voronoi facets that pass a filter of `medax medial`: medial, angle=DEGREES (the object angle), lambda=LENGTH,
    /// scale=FACTOR, or several, joined by commas, all of which they must pass
    #[arg(long, value_name = "FILTER", conflicts_with_all = NO_CORE)]
    extend: Option<Extend>,
    /// Do not repair the inner core where the sample is too sparse for it to have the homotopy type of the solid
    #[arg(long, conflicts_with_all = NO_CORE)]
    plain: bool,
    /// The slope above which a critical point belongs to the medial axis and not to the surface: the mean cosine between its directions from its nearest
    /// samples and their poles
    #[arg(long, allow_hyphen_values = true, value_name = "COSINE", default_value_t = 0.5)]
    least_slope: f64,
    #[command(flatten)]
    validate: ValidateOptions,
}

/// What is written instead of a core.
const NO_CORE: [&str; 4] = ["critical", "orbits", "manifold", "complex"];

/// What is written.
#[derive(clap::Args)]
#[group(multiple = false)]
struct What {
    /// Write the core; the default
    #[arg(long)]
    core: bool,
    /// Write the critical points of the distance to the samples, but for these themselves
    #[arg(long)]
    critical: bool,
    /// Write the orbits of the points of a file
    #[arg(long, value_name = "POINTS")]
    orbits: Option<PathBuf>,
    /// Write the unstable manifold of a critical point, counted from 0 as in --critical, or of several
    #[arg(long, value_name = "ROW", value_delimiter = ',')]
    manifold: Vec<u32>,
    /// Write the whole unstable flow complex, but for what is unbounded
    #[arg(long)]
    complex: bool,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    let slope = options.least_slope;
    if !(slope > 0.0 && slope < 1.0) {
        let message = format!("--least-slope must lie between 0 and 1, not {slope:?}");
        return Err(Failure::usage(message));
    }
    let soup = session.read(&options.input)?;
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    drop(soup);
    let starts = match &options.what.orbits {
        Some(path) => Some((path, options.starts(path, session)?)),
        None => None,
    };
    let triangulation = Arc::new(Triangulation::delaunay(&points, &session.job)?);
    let dual = Arc::new(Dual::new(&triangulation, DualOptions { facets: true }, &session.job)?);
    let mut report = Report { command: "flow", input, ..Report::default() };
    options.describe(&mut report);
    let labels = Arc::new(options.labels.labels(&dual, &mut report, session)?);
    let asked = FlowOptions { least_slope: slope };
    let flow = Arc::new(Flow::new(&dual, &labels, asked, &session.job)?);
    options.validate.report(&mut report, || {
        let mut found = flow.validate(&session.job)?;
        if options.what.complex {
            found.absorb(FlowComplex::new(&flow, &session.job)?.validate(&session.job)?);
        }
        Ok(found)
    })?;
    let mut more = describe(&flow);
    let (name, complex) = match &starts {
        Some((path, starts)) => ("orbits", orbits(&flow, path, starts, &mut more, session)?),
        None if options.what.critical => ("critical points", flow.critical_complex(&session.job)?),
        None if options.what.complex => {
            ("flow complex", FlowComplex::new(&flow, &session.job)?.complex(&session.job)?)
        }
        None if !options.what.manifold.is_empty() => {
            ("manifold", options.manifolds(&flow, session)?)
        }
        None => {
            let core = options.core(&flow, session)?;
            more.insert("core".into(), describe_core(&core));
            if core.unbounded() > 0 && options.side == Side::Inner {
                session.warn("the inner core leaves the solid: the sample is too sparse somewhere");
            }
            report.lines.push(("facets added", core.taken().to_string()));
            ("core", core.into_complex())
        }
    };
    report.more.insert("flow".into(), more.into());
    report.counts =
        Counts { cells: Some(triangulation.cells().len() as u64), ..Counts::from(&complex) };
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver(name, &complex, path, &options.output)?);
    Ok(report)
}

impl Options {
    fn describe(&self, report: &mut Report) {
        self.read.describe(&mut report.parameters);
        self.output.describe(&mut report.parameters);
        let what = match &self.what {
            What { orbits: Some(_), .. } => "orbits",
            What { critical: true, .. } => "critical",
            What { complex: true, .. } => "complex",
            What { manifold, .. } if !manifold.is_empty() => "manifold",
            _ => "core",
        };
        let path = self.what.orbits.as_deref().map(Path::to_string_lossy);
        for (name, value) in [
            ("what", json!(what)),
            ("orbits", json!(path)),
            ("manifold", json!(self.what.manifold)),
            ("side", json!(self.side.name())),
            ("extend", json!(self.extend.as_ref().map(ToString::to_string))),
            ("plain", json!(self.plain)),
            ("least_slope", json!(self.least_slope)),
        ] {
            report.parameters.insert(name.into(), value);
        }
    }

    /// The points whose orbits are asked for.
    fn starts(&self, path: &Path, session: &mut Session) -> Result<Vec<[f64; 3]>, Failure> {
        let mut starts = session.read(path)?.vertices().to_vec();
        if self.read.skip_invalid {
            let all = starts.len();
            starts.retain(|start| start.iter().all(|x| x.is_finite()));
            if starts.len() < all {
                let message = format!("skipped {} of the points of", all - starts.len());
                session.warn(&format!("{message} {}", path.display()));
            }
        }
        Ok(starts)
    }

    /// The core, extended by the facets that pass.
    fn core(&self, flow: &Flow, session: &mut Session) -> Result<Core, Failure> {
        let side = match self.side {
            Side::Inner => medial::Side::Inner,
            Side::Outer => medial::Side::Outer,
            Side::Both => medial::Side::Both,
        };
        let facets = match &self.extend {
            None => Vec::new(),
            Some(extend) => {
                let asked = MedialOptions { normals: None, scales: extend.needs_scales() };
                let medial = Medial::new(flow.dual(), Some(flow.labels()), asked, &session.job)?;
                // Facets of both sides, so that those that the theorem cannot take are counted.
                medial.selected(&extend.filter(), &session.job)?
            }
        };
        Ok(flow.core(CoreOptions { side, repair: !self.plain }, &facets, &session.job)?)
    }

    fn manifolds(&self, flow: &Flow, session: &mut Session) -> Result<Complex, Failure> {
        let samples = flow.dual().triangulation().coords().len();
        let simplices = &flow.critical().simplices()[samples..];
        let chosen = self.what.manifold.iter().map(|&row| {
            simplices.get(row as usize).copied().ok_or_else(|| {
                let message = format!("--manifold {row}: there are {} of them", simplices.len());
                let error = Error::new(Status::InvalidArgument, message);
                Failure::from(error.at(ElementKind::Row, u64::from(row)))
            })
        });
        let chosen = chosen.collect::<Result<Vec<_>, _>>()?;
        Ok(flow.closure(&chosen, &session.job)?)
    }
}

fn orbits(
    flow: &Flow,
    path: &Path,
    starts: &[[f64; 3]],
    more: &mut Map<String, serde_json::Value>,
    session: &mut Session,
) -> Result<Complex, Failure> {
    let orbits = flow.orbits(starts, &session.job).map_err(Failure::about(path))?;
    let infinite = orbits.ends().iter().filter(|&&end| end == medax::NONE).count();
    more.insert("orbits".into(), json!({ "count": orbits.len(), "to_infinity": infinite }));
    Ok(orbits.complex(&session.job)?)
}

/// How many critical points there are of each index, by their classes, and the gap between these.
fn describe(flow: &Flow) -> Map<String, serde_json::Value> {
    let critical = flow.critical();
    let mut counts = [[0u64; 4]; 3];
    for (simplex, &class) in critical.simplices().iter().zip(critical.classes()) {
        counts[class as usize][simplex.dimension()] += 1;
    }
    let of = |class: CriticalClass| json!(counts[class as usize]);
    let mut more = Map::new();
    more.insert(
        "critical".into(),
        json!({
            "surface": of(CriticalClass::Surface),
            "inner": of(CriticalClass::Inner),
            "outer": of(CriticalClass::Outer),
        }),
    );
    more.insert("gap".into(), json!(critical.gap(flow.options().least_slope)));
    more
}

fn describe_core(core: &Core) -> serde_json::Value {
    let excluded = core.excluded();
    json!({
        "taken": core.taken(),
        "excluded": {
            "of_surface": excluded.of_surface,
            "elsewhere": excluded.elsewhere,
            "leaving": excluded.leaving,
        },
        "unbounded": core.unbounded(),
    })
}
