//! `medax pair`: a solid between its inner structure and its boundary.

use crate::extend::Extend;
use crate::labels::LabelArguments;
use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use medax::complex::ComplexParts;
use medax::dual::{Dual, DualOptions};
use medax::flow::{CoreOptions, Flow, FlowOptions};
use medax::medial::{Medial, MedialFilter, MedialOptions};
use medax::pair::{PairMesh, PairOntoOptions, PairReason};
use medax::{Complex, Labels, Triangulation};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Divide a solid into pyramids and tetrahedra between its inner structure and its boundary (Shaham, Shamir and Cohen-Or)
#[derive(clap::Args)]
pub struct Options {
    /// A file of points; of a mesh the vertices that it uses
    input: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    output: OutputOptions,
    #[command(flatten)]
    labels: LabelArguments,
    /// The inner structure: all of the Voronoi diagram that is inside; its facets that pass a filter; those in which a core lies; or a spine, as little as can be
    #[arg(long, value_enum, value_name = "WHAT", default_value_t = Inner::Voronoi)]
    inner: Inner,
    /// The Voronoi facets that pass a filter of `medax medial`, as with `medax flow --extend`: those of --inner medial, where it is `medial` by default; or those by which the core is
    /// extended, none by default
    #[arg(long, value_name = "FILTERS")]
    facets: Option<Extend>,
    /// Divide triangles of the boundary where no more of the inner structure goes without
    #[arg(long)]
    subdivide: bool,
    /// Fail where any of the inner structure stays that was not asked for, or what was is not there
    #[arg(long)]
    exact: bool,
    /// Write the inner structure
    #[arg(long, value_name = "FILE")]
    inner_out: Option<PathBuf>,
    /// Write the surfaces on which each node is so far on the way from the inner structure (0) to the boundary (1)
    #[arg(long, value_name = "T", value_delimiter = ',', requires = "iso_out")]
    iso: Vec<f64>,
    /// Where to write them; of several each gets its T before the ending, as in solid-0.5.ply
    #[arg(long, value_name = "FILE", requires = "iso")]
    iso_out: Option<PathBuf>,
    #[command(flatten)]
    validate: ValidateOptions,
}

/// What the inner structure is.
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
enum Inner {
    Voronoi,
    Medial,
    Core,
    Spine,
}

impl Inner {
    fn name(self) -> &'static str {
        match self {
            Inner::Voronoi => "voronoi",
            Inner::Medial => "medial",
            Inner::Core => "core",
            Inner::Spine => "spine",
        }
    }
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    let paths = options.iso_paths()?;
    options.check_inner()?;
    let others: Vec<_> = paths.iter().chain([&options.inner_out]).collect();
    options.output.check(&others)?;
    let soup = session.read(&options.input)?;
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    drop(soup);
    let triangulation = Arc::new(Triangulation::delaunay(&points, &session.job)?);
    let dual = Arc::new(Dual::new(&triangulation, DualOptions { facets: true }, &session.job)?);
    let mut report = Report { command: "pair", input, ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.output.describe(&mut report.parameters);
    for (name, value) in [
        ("iso", json!(options.iso)),
        ("inner", json!(options.inner.name())),
        ("facets", json!(options.facets.map(|facets| facets.to_string()))),
        ("subdivide", json!(options.subdivide)),
        ("exact", json!(options.exact)),
    ] {
        report.parameters.insert(name.into(), value);
    }
    let labels = Arc::new(options.labels.labels(&dual, &mut report, session)?);
    let mut pair = PairMesh::voronoi(&dual, &labels, &session.job)?;
    if let Some(part) = options.part(&dual, &labels, session)? {
        let onto = PairOntoOptions { subdivide: options.subdivide, exact: options.exact };
        pair = pair.onto(&part, onto, &session.job)?;
    }
    options.validate.report(&mut report, || pair.validate(&session.job))?;
    describe(&pair, &mut report, session)?;
    let solid = pair.solid(&session.job)?;
    report.counts = Counts::from(&solid);
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver("solid", &solid, path, &options.output)?);
    drop(solid);
    let inner = pair.inner(&session.job)?;
    let path = options.inner_out.as_deref();
    report.outputs.push(session.deliver("inner structure", &inner, path, &options.output)?);
    for (&t, path) in options.iso.iter().zip(&paths) {
        let surface = pair.iso_surface(t, &session.job)?;
        report.outputs.push(session.deliver(
            "iso-surface",
            &surface,
            path.as_deref(),
            &options.output,
        )?);
    }
    Ok(report)
}

impl Options {
    /// Options that would do nothing are refused.
    fn check_inner(&self) -> Result<(), Failure> {
        let is_filtered = matches!(self.inner, Inner::Medial | Inner::Core);
        if self.facets.is_some() && !is_filtered {
            return Err(Failure::usage("--facets goes with --inner medial and --inner core"));
        }
        if (self.subdivide || self.exact) && self.inner == Inner::Voronoi {
            let message = "--subdivide and --exact go with another --inner than voronoi";
            return Err(Failure::usage(message));
        }
        Ok(())
    }

    /// The part of the Voronoi diagram that is asked for, if not all of it.
    fn part(
        &self,
        dual: &Arc<Dual>,
        labels: &Arc<Labels>,
        session: &Session,
    ) -> Result<Option<Complex>, Failure> {
        let job = &session.job;
        let medial = |extend: &Extend| {
            let asked = MedialOptions { normals: None, scales: extend.needs_scales() };
            Medial::new(dual, Some(labels), asked, job)
        };
        Ok(match self.inner {
            Inner::Voronoi => None,
            Inner::Spine => Some(Complex::new(ComplexParts::default())?),
            Inner::Medial => {
                let filter = match &self.facets {
                    Some(facets) => facets.filter(),
                    None => MedialFilter::default(),
                };
                let filter = MedialFilter { side: medax::medial::Side::Inner, ..filter };
                Some(medial(&self.facets.unwrap_or_default())?.axis(&filter, job)?)
            }
            Inner::Core => {
                let facets = match &self.facets {
                    Some(facets) => medial(facets)?.selected(&facets.filter(), job)?,
                    None => Vec::new(),
                };
                let flow = Flow::new(dual, labels, FlowOptions::default(), job)?;
                Some(flow.core(CoreOptions::default(), &facets, job)?.into_complex())
            }
        })
    }

    /// A file for each surface that is asked for.
    fn iso_paths(&self) -> Result<Vec<Option<PathBuf>>, Failure> {
        if let Some(t) = self.iso.iter().find(|t| !(0.0..=1.0).contains(*t)) {
            return Err(Failure::usage(format!("--iso must lie between 0 and 1, not {t:?}")));
        }
        let path = |t: &f64| match (&self.iso_out, self.iso.len()) {
            (Some(path), 2..) => Some(with_time(path, *t)),
            (path, _) => path.clone(),
        };
        Ok(self.iso.iter().map(path).collect())
    }
}

/// The name of a file with a number before its ending.
fn with_time(path: &Path, t: f64) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    let t = if t == 0.0 || t >= 1e-6 { format!("{t}") } else { format!("{t:e}") };
    path.with_file_name(format!("{stem}-{t}.{ending}"))
}

fn describe(pair: &PairMesh, report: &mut Report, session: &mut Session) -> Result<(), Failure> {
    let [pyramids, between, over] = pair.counts();
    let places = pair.inner_vertices().iter().zip(pair.voronoi_vertices());
    let moved = places.filter(|(place, voronoi)| place != voronoi).count();
    let folded = pair.folded(&session.job)?.len();
    let enclosed = pair.enclosed_volume();
    let is_unasked = |reason: &PairReason| *reason != PairReason::Asked;
    let unasked: Vec<PairReason> = pair.reasons().iter().copied().filter(is_unasked).collect();
    let its = json!({
        "face_vertex": pyramids,
        "edge_edge": between,
        "vertex_face": over,
        "nodes": pair.nodes().len(),
        "boundary_vertices": pair.boundary_vertices().len(),
        "inner_vertices": pair.inner_vertices().len(),
        "inner_faces": pair.inner_faces().len(),
        "volume": enclosed,
        "removed": pair.removed().len(),
        "moved": moved,
        "folded": folded,
        "asked": pair.inner_faces().len() - unasked.len(),
        "enclosed": unasked.iter().filter(|&&reason| reason == PairReason::Enclosed).count(),
        "unseen": unasked.iter().filter(|&&reason| reason == PairReason::Unseen).count(),
        "unasked_edges": pair.unasked_edges().len(),
        "missing": pair.missing(),
    });
    report.more.insert("pair".into(), its);
    let words = format!("{pyramids} pyramids, {between} between edges, {over} over triangles");
    report.lines.push(("elements", words));
    report.lines.push(("volume", format!("{enclosed:.9e}")));
    let words = format!("{moved} of {}", pair.inner_vertices().len());
    report.lines.push(("inner vertices moved", words));
    if !pair.reasons().is_empty() {
        let words = format!("{} of {}", unasked.len(), pair.inner_faces().len());
        report.lines.push(("inner faces not asked for", words));
    }
    if pair.missing() > 0 {
        let count = pair.missing();
        session.warn(&format!(
            "{count} Voronoi facets and edges asked for are not in the inner structure"
        ));
    }
    if !pair.removed().is_empty() {
        let count = pair.removed().len();
        session.warn(&format!("{count} samples inside the solid were removed"));
    }
    if folded > 0 {
        session.warn(&format!("{folded} elements are turned inside out by rounding"));
    }
    Ok(())
}
