//! What distances are measured to: a plane figure or a mesh.

use crate::figure::FeatureOptions;
use crate::report::{Input, Report};
use crate::session::{Failure, Session};
use medax::complex::{ComplexParts, Rows};
use medax::distance::Sites;
use medax::figure::{ChainKind, Crossings};
use medax::{Complex, NONE};
use serde_json::json;
use std::path::Path;
use std::sync::Arc;

/// How a plane figure becomes a boundary.
#[derive(clap::Args)]
pub struct BoundaryOptions {
    #[command(flatten)]
    feature: FeatureOptions,
    /// Accept curves of a figure that cross or touch, and polygons in others: inside is where a ray crosses rings and circles an odd number of times
    #[arg(long)]
    crossings: bool,
}

/// What can be nearest.
pub struct Boundary {
    pub sites: Arc<Sites>,
    /// Whether it may have an inside.
    pub has_inside: bool,
    /// The pairs of curves that cross or touch, of a figure.
    pub crossings: u64,
}

impl BoundaryOptions {
    pub fn describe(&self, report: &mut Report) {
        self.feature.describe(report);
        report.parameters.insert("crossings".into(), json!(self.crossings));
    }

    /// An option that was given, if any.
    pub fn given(&self) -> Option<&'static str> {
        self.feature.given().or(self.crossings.then_some("--crossings"))
    }

    /// The rings, lines, points and circles of a GeoJSON file.
    pub fn figure(
        &self,
        path: &Path,
        report: &mut Report,
        session: &Session,
    ) -> Result<Boundary, Failure> {
        let crossings = if self.crossings { Crossings::Accept } else { Crossings::Refuse };
        let figure = self.feature.read(path, crossings, report, session)?;
        Ok(Boundary {
            sites: Arc::new(Sites::of_figure(&figure, &session.job)?),
            has_inside: figure.chain_count(ChainKind::Outer) + figure.circles().len() > 0,
            crossings: figure.normalised().crossings,
        })
    }
}

/// The faces and loose edges of a file, or its points where it has neither; each connected component is a site. Whether sides matter decides on a warning.
pub fn mesh(
    path: &Path,
    sides_matter: bool,
    report: &mut Report,
    session: &mut Session,
) -> Result<Boundary, Failure> {
    let about = Failure::about(path);
    let soup = session.read(path)?;
    let is_mesh = soup.is_mesh();
    let mut mesh = session.complex(path, soup)?;
    let count = mesh.vertices().len();
    if is_mesh {
        mesh = used(&mesh).map_err(&about)?;
    }
    report.input = Input::of_mesh(path, &mesh, count - mesh.vertices().len());
    let has_inside = !mesh.faces().is_empty();
    let topology = mesh.topology(&session.job)?;
    if sides_matter && has_inside && !(topology.closed && topology.oriented) {
        session.warn("the faces are no closed surface: inside is where they wind round a point more than half a time");
    }
    let sites = Sites::of_components(&Arc::new(mesh), &session.job).map_err(&about)?;
    Ok(Boundary { sites: Arc::new(sites), has_inside, crossings: 0 })
}

/// The same faces and edges, with the vertices that they use.
fn used(mesh: &Complex) -> medax::Result<Complex> {
    let mut number = vec![NONE; mesh.vertices().len()];
    for &v in mesh.faces().indices().iter().chain(mesh.edges().as_flattened()) {
        number[v as usize] = 0;
    }
    let mut vertices = Vec::new();
    for (number, &at) in number.iter_mut().zip(mesh.vertices()).filter(|(n, _)| **n != NONE) {
        *number = vertices.len() as u32;
        vertices.push(at);
    }
    let renumbered = |v: u32| number[v as usize];
    let corners = mesh.faces().indices().iter().map(|&v| renumbered(v)).collect();
    Complex::new(ComplexParts {
        dimension: mesh.dimension(),
        vertices,
        faces: Rows::new(mesh.faces().offsets().to_vec(), corners)?,
        edges: mesh.edges().iter().map(|edge| edge.map(renumbered)).collect(),
        ..ComplexParts::default()
    })
}
