//! `medax pair`: a solid between its inner structure and its boundary.

use crate::labels::LabelArguments;
use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use medax::dual::{Dual, DualOptions};
use medax::{PairMesh, Triangulation};
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
    /// Write the surfaces on which each node is so far on the way from the inner structure (0) to the boundary (1)
    #[arg(long, value_name = "T", value_delimiter = ',', requires = "iso_out")]
    iso: Vec<f64>,
    /// Where to write them; of several each gets its T before the ending, as in solid-0.5.ply
    #[arg(long, value_name = "FILE", requires = "iso")]
    iso_out: Option<PathBuf>,
    #[command(flatten)]
    validate: ValidateOptions,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    let paths = options.iso_paths()?;
    options.output.check(&paths.iter().collect::<Vec<_>>())?;
    let soup = session.read(&options.input)?;
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    drop(soup);
    let triangulation = Arc::new(Triangulation::delaunay(&points, &session.job)?);
    let dual = Arc::new(Dual::new(&triangulation, DualOptions { facets: true }, &session.job)?);
    let mut report = Report { command: "pair", input, ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.output.describe(&mut report.parameters);
    report.parameters.insert("iso".into(), json!(options.iso));
    let labels = options.labels.labels(&dual, &mut report, session)?;
    let pair = PairMesh::voronoi(&dual, &labels, &session.job)?;
    options.validate.report(&mut report, || pair.validate(&session.job))?;
    describe(&pair, &mut report, session)?;
    let solid = pair.solid(&session.job)?;
    report.counts = Counts::from(&solid);
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver("solid", &solid, path, &options.output)?);
    drop(solid);
    let inner = pair.inner(&session.job)?;
    report.outputs.push(session.deliver("inner structure", &inner, None, &options.output)?);
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
    path.with_file_name(format!("{stem}-{t}.{ending}"))
}

fn describe(pair: &PairMesh, report: &mut Report, session: &mut Session) -> Result<(), Failure> {
    let [pyramids, between, over] = pair.counts();
    let places = pair.inner_vertices().iter().zip(pair.voronoi_vertices());
    let moved = places.filter(|(place, voronoi)| place != voronoi).count();
    let folded = pair.folded(&session.job)?.len();
    let enclosed = pair.enclosed_volume();
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
    });
    report.more.insert("pair".into(), its);
    let words = format!("{pyramids} pyramids, {between} between edges, {over} over triangles");
    report.lines.push(("elements", words));
    report.lines.push(("volume", format!("{enclosed:.9e}")));
    let words = format!("{moved} of {}", pair.inner_vertices().len());
    report.lines.push(("inner vertices moved", words));
    if !pair.removed().is_empty() {
        let count = pair.removed().len();
        session.warn(&format!("{count} samples inside the solid were removed"));
    }
    if folded > 0 {
        session.warn(&format!("{folded} elements are turned inside out by rounding"));
    }
    Ok(())
}
