//! `medax medial`: the medial axis straight from the Voronoi diagram.

use crate::labels::LabelArguments;
use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use crate::side::Side;
use medax::dual::{Dual, DualOptions};
use medax::medial::{self, Medial, MedialFilter, MedialOptions, MedialRule};
use medax::{Complex, Error, Status, Triangulation};
use serde_json::json;
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::PathBuf;
use std::sync::Arc;

/// Find the medial axis of a sample among the facets of its Voronoi diagram (Dey and Zhao's MEDIAL)
#[derive(clap::Args)]
pub struct Options {
    /// A file of points; of a mesh the vertices that it uses
    input: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    output: OutputOptions,
    /// The side of the surface whose axis is written; both takes the facets that cross the surface, too. Labels, which tell the side of every
    /// facet, are then made only if one of their options is given
    #[arg(long, value_enum, default_value_t = Side::Inner)]
    side: Side,
    #[command(flatten)]
    labels: LabelArguments,
    /// Which conditions a facet must fulfil: one of the two, the angle condition, the ratio condition, or none
    #[arg(long, value_enum, value_name = "RULE", default_value_t = RuleName::Either)]
    rule: RuleName,
    /// The angle condition: the dual edge makes more than this with the surface at one of its ends
    #[arg(long, allow_hyphen_values = true, value_name = "DEGREES", default_value_t = 22.5)]
    theta_degrees: f64,
    /// The ratio condition: the dual edge is more than so many times as long as the surface's triangles there are wide
    #[arg(long, allow_hyphen_values = true, value_name = "RATIO", default_value_t = 8.0)]
    rho: f64,
    /// The least object angle that some point of a facet must have: between the directions to its two samples
    #[arg(long, allow_hyphen_values = true, value_name = "DEGREES", default_value_t = 0.0)]
    object_degrees: f64,
    /// The least lambda: half the distance between the two samples of a facet, in input units
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH", default_value_t = 0.0)]
    lambda: f64,
    /// The least pairwise scale: some ball of the facet must not be covered by another one when both are grown so many times
    #[arg(long, allow_hyphen_values = true, value_name = "FACTOR", default_value_t = 0.0)]
    scale: f64,
    /// Use the mesh's own normals in place of pole vectors: those of its discrete curvature
    #[arg(long)]
    mesh_normals: bool,
    /// Keep unbounded facets, clipped to the box of the samples grown by this share of its diagonal on every side
    #[arg(long, value_name = "SHARE")]
    clip: Option<f64>,
    #[command(flatten)]
    validate: ValidateOptions,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum RuleName {
    Either,
    Angle,
    Ratio,
    None,
}

impl RuleName {
    fn translate(self) -> (MedialRule, &'static str) {
        match self {
            RuleName::Either => (MedialRule::AngleOrRatio, "either"),
            RuleName::Angle => (MedialRule::Angle, "angle"),
            RuleName::Ratio => (MedialRule::Ratio, "ratio"),
            RuleName::None => (MedialRule::Every, "none"),
        }
    }
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    let (rule, rule_name) = options.rule.translate();
    let (theta, angle) = (options.theta_degrees, options.object_degrees);
    if !(0.0..90.0).contains(&theta) {
        let message = format!("--theta-degrees must be 0 or more and below 90, not {theta:?}");
        return Err(Failure::usage(message));
    }
    if !(0.0..=180.0).contains(&angle) {
        let message = format!("--object-degrees must lie between 0 and 180, not {angle:?}");
        return Err(Failure::usage(message));
    }
    if options.clip.is_some_and(|share| !share.is_finite() || share < 0.0) {
        return Err(Failure::usage("--clip must be a share of the diagonal, and not negative"));
    }
    let mut filter = MedialFilter {
        rule,
        // A product of what is next below 90 may be rounded up.
        theta: (theta * (PI / 180.0)).min(FRAC_PI_2.next_down()),
        rho: options.rho,
        object_angle: (angle * (PI / 180.0)).min(PI),
        lambda: options.lambda,
        scale: options.scale,
        side: match options.side {
            Side::Inner => medial::Side::Inner,
            Side::Outer => medial::Side::Outer,
            Side::Both => medial::Side::Both,
        },
        clip: None,
    };
    let soup = session.read(&options.input)?;
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    let normals = match options.mesh_normals {
        true => Some(normals(options, session, soup, points.vertex_of_row())?),
        false => {
            drop(soup);
            None
        }
    };
    filter.clip = options.clip.map(|share| grown(points.coords(), share));
    let triangulation = Arc::new(Triangulation::delaunay(&points, &session.job)?);
    let dual = Arc::new(Dual::new(&triangulation, DualOptions { facets: true }, &session.job)?);
    let mut report = Report { command: "medial", input, ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.output.describe(&mut report.parameters);
    for (name, value) in [
        ("side", json!(options.side.name())),
        ("rule", json!(rule_name)),
        ("theta_degrees", json!(options.theta_degrees)),
        ("rho", json!(options.rho)),
        ("object_degrees", json!(options.object_degrees)),
        ("lambda", json!(options.lambda)),
        ("scale", json!(options.scale)),
        ("mesh_normals", json!(options.mesh_normals)),
        ("clip", json!(options.clip)),
    ] {
        report.parameters.insert(name.into(), value);
    }
    let labels = match options.side == Side::Both && !options.labels.are_asked_for() {
        true => {
            LabelArguments::without(&mut report);
            None
        }
        false => Some(Arc::new(options.labels.labels(&dual, &mut report, session)?)),
    };
    let asked = MedialOptions { normals, scales: options.scale > 0.0 };
    let medial = Medial::new(&dual, labels.as_ref(), asked, &session.job)?;
    options.validate.report(&mut report, || medial.validate(&session.job))?;
    let axis = medial.axis(&filter, &session.job)?;
    describe(&medial, &axis, &mut report);
    if axis.faces().is_empty() {
        session.warn("no facet passes, so the axis is empty; take a smaller theta or rho");
    }
    report.counts =
        Counts { cells: Some(triangulation.cells().len() as u64), ..Counts::from(&axis) };
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver("axis", &axis, path, &options.output)?);
    Ok(report)
}

/// The normals of the input's mesh, by vertices of the points.
fn normals(
    options: &Options,
    session: &mut Session,
    soup: medax::io::Soup,
    vertex_of_row: &[u32],
) -> Result<Vec<[f64; 3]>, Failure> {
    let mesh = session.complex(&options.input, soup)?;
    if mesh.faces().is_empty() {
        let error = Error::new(Status::InvalidArgument, "there are no faces, and so no normals");
        return Err(Failure::about(&options.input)(error));
    }
    let of_rows = mesh.vertex_normals(&session.job).map_err(Failure::about(&options.input))?;
    let count = vertex_of_row.iter().filter(|&&v| v != medax::NONE).max().map_or(0, |&v| v + 1);
    let mut normals = vec![[0.0; 3]; count as usize];
    for (&vertex, normal) in vertex_of_row.iter().zip(of_rows) {
        if let Some(at) = normals.get_mut(vertex as usize) {
            *at = [0, 1, 2].map(|k| at[k] + normal[k]);
        }
    }
    Ok(normals)
}

/// The box of points, grown by a share of its diagonal on every side.
fn grown(coords: &[[f64; 3]], share: f64) -> [[f64; 3]; 2] {
    let extreme = |pick: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|k| coords.iter().map(|p| p[k]).fold(coords[0][k], pick))
    };
    let (low, high) = (extreme(f64::min), extreme(f64::max));
    let diagonal = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
    // A box has a volume, however flat the points are.
    let margin = (share * diagonal).max(f64::MIN_POSITIVE);
    [low.map(|x| x - margin), high.map(|x| x + margin)]
}

fn describe(medial: &Medial, axis: &Complex, report: &mut Report) {
    let torn = medial.umbrellas().torn_count();
    let samples = medial.umbrellas().is_disk().len();
    let facets = medial.sines().len();
    report.more.insert(
        "medial".into(),
        json!({ "facets": facets, "selected": axis.faces().len(), "torn_umbrellas": torn }),
    );
    report.lines.push(("facets", format!("{} of {facets}", axis.faces().len())));
    if torn > 0 {
        report.lines.push(("umbrellas", format!("{torn} of {samples} are no disks")));
    }
}
