//! `medax field`: the medial axis read off the distance to a plane figure or a mesh.

use crate::boundary::{self, Boundary, BoundaryOptions};
use crate::figure::is_figure;
use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, Session, ValidateOptions};
use crate::side::Side;
use medax::distance::{DecideOptions, FieldAxis, FieldOptions, GraphOptions, MedialGraph, Sites};
use medax::{Complex, Error, Status, medial};
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::path::PathBuf;
use std::sync::Arc;

/// The bound on missed object angles if nobody says which.
const MISSED_DEGREES: f64 = 20.0;
/// The least number of points at which a circle or a sphere can be looked at, and the largest.
const SAMPLES: std::ops::RangeInclusive<usize> = 12..=1 << 20;

/// Find the medial axis of a plane figure or a mesh by the distance to it (Stolpner and Whitesides)
#[derive(clap::Args)]
pub struct Options {
    /// A plane figure, in GeoJSON; or a mesh, which may be open, or a soup of polygons
    input: PathBuf,
    #[command(flatten)]
    output: OutputOptions,
    #[command(flatten)]
    boundary: BoundaryOptions,
    /// Write points of the axis in place of the arcs and junctions of a figure's, with a claim of what can have been missed, or of the polygons of a mesh's
    #[arg(long)]
    points: bool,
    /// The side of the rings, circles or faces whose axis is written
    #[arg(long, value_enum, default_value_t = Side::Inner)]
    side: Side,
    /// How dense the result is, in input units: the longest edge of an arc, or how near a point is to whatever is found of the axis. 0 means a hundredth of the diagonal
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH", default_value_t = 0.0)]
    density: f64,
    /// The least distance from the figure or mesh. For points of a figure 0 means a quarter of the density
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH", default_value_t = 0.0)]
    min_distance: f64,
    /// The least object angle: between the directions to the nearest points
    #[arg(long, allow_hyphen_values = true, value_name = "DEGREES", default_value_t = 0.0)]
    object_degrees: f64,
    /// For points of a figure: the largest object angle of what may be missed; 20 by default
    #[arg(long, allow_hyphen_values = true, value_name = "DEGREES")]
    missed_degrees: Option<f64>,
    /// For points, and for a mesh: at how many points each circle or sphere is looked at, from 12; by default what --missed-degrees needs, and 60 for a mesh
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
    /// For points, and for a mesh: how far from the axis they may be; a millionth of the diagonal by default
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH")]
    epsilon: Option<f64>,
    /// For points, and for a mesh: nearest points no farther apart than this are the same; 1e-9 of the diagonal by default
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH")]
    tolerance: Option<f64>,
    /// Write only what lies between two sites: polygons, lines, points, circles of a figure; connected components of a mesh
    #[arg(long)]
    between_sites: bool,
    /// Write only what lies between the sites of these pairs, such as 0-1,2-3; of a site and itself what lies within it
    #[arg(long, value_name = "A-B[,A-B..]", value_delimiter = ',', value_parser = pair)]
    pairs: Vec<[u32; 2]>,
    /// Look no further than the box of the input, grown by this share of its diagonal on every side; 0 by default for the inner axis, else 0.5
    #[arg(long, allow_hyphen_values = true, value_name = "SHARE")]
    clip: Option<f64>,
    #[command(flatten)]
    validate: ValidateOptions,
}

/// What is written.
#[derive(Clone, Copy, PartialEq)]
enum What {
    /// Arcs and junctions, in the plane.
    Graph,
    /// Polygons, in space.
    Surface,
    Points,
}

impl What {
    fn name(self) -> &'static str {
        match self {
            What::Graph => "graph",
            What::Surface => "surface",
            What::Points => "points",
        }
    }
}

/// Reads a pair of sites.
fn pair(words: &str) -> Result<[u32; 2], String> {
    let site = |word: &str| word.parse().ok();
    let sites = words.split_once('-').and_then(|(a, b)| Some([site(a)?, site(b)?]));
    sites.ok_or_else(|| "a pair is two numbers of sites with '-' between, such as 0-1".into())
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    options.check()?;
    let mut report = Report { command: "field", ..Report::default() };
    let Boundary { sites, has_inside, crossings } = match is_figure(&options.input) {
        true => options.boundary.figure(&options.input, &mut report, session)?,
        false => {
            let sides_matter = options.side != Side::Both;
            boundary::mesh(&options.input, sides_matter, &mut report, session)?
        }
    };
    let what = options.what();
    if crossings > 0 && what == What::Graph {
        let message = format!(
            "curves that cross or touch have no graph (pairs of them: {crossings}); give --points"
        );
        return Err(Failure::about(&options.input)(Error::new(Status::Unsupported, message)));
    }
    options.describe(&mut report);
    let complex = match what {
        What::Graph => options.graph(&sites, &mut report, session)?,
        What::Surface | What::Points => options.sample(&sites, &mut report, session)?,
    };
    let name = if what == What::Points { "points" } else { "axis" };
    if complex.vertices().is_empty() {
        session.warn(match options.side {
            Side::Inner if !has_inside => {
                "nothing is inside of points, lines and loose edges; give --side outer"
            }
            _ if options.between_sites && sites.site_count() == 1 => {
                "the result is empty: there is one site, and nothing lies between two"
            }
            _ => "the result is empty: nothing of the axis is on this side and passes",
        });
    }
    report.counts = Counts::from(&complex);
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver(name, &complex, path, &options.output)?);
    Ok(report)
}

impl Options {
    fn what(&self) -> What {
        match (self.points, is_figure(&self.input)) {
            (true, _) => What::Points,
            (false, true) => What::Graph,
            (false, false) => What::Surface,
        }
    }

    /// Refuses what makes no sense, before the input is read.
    fn check(&self) -> Result<(), Failure> {
        let lengths = [
            ("--density", Some(self.density)),
            ("--min-distance", Some(self.min_distance)),
            ("--epsilon", self.epsilon),
            ("--tolerance", self.tolerance),
            ("--clip", self.clip),
        ];
        for (name, length) in lengths {
            if let Some(length) = length.filter(|length| !(0.0..f64::INFINITY).contains(length)) {
                let message = format!("{name} must be 0 or more and finite, not {length:?}");
                return Err(Failure::usage(message));
            }
        }
        let angle = self.object_degrees;
        if !(0.0..=180.0).contains(&angle) {
            let message = format!("--object-degrees must lie between 0 and 180, not {angle:?}");
            return Err(Failure::usage(message));
        }
        let is_between = |angle: &f64| *angle > 0.0 && *angle < 180.0;
        if let Some(angle) = self.missed_degrees.filter(|angle| !is_between(angle)) {
            let message = format!("--missed-degrees must lie between 0 and 180, not {angle:?}");
            return Err(Failure::usage(message));
        }
        if let Some(samples) = self.samples.filter(|samples| !SAMPLES.contains(samples)) {
            let message = format!("--samples must lie between 12 and 2^20, not {samples}");
            return Err(Failure::usage(message));
        }
        self.check_kind()
    }

    /// Refuses options that the kind of the input or of the result has no use for.
    fn check_kind(&self) -> Result<(), Failure> {
        let of_points = [
            ("--missed-degrees", self.missed_degrees.is_some()),
            ("--samples", self.samples.is_some()),
            ("--epsilon", self.epsilon.is_some()),
            ("--tolerance", self.tolerance.is_some()),
        ];
        let given = |options: &[(&'static str, bool)]| {
            options.iter().find(|(_, is_given)| *is_given).map(|(name, _)| *name)
        };
        if !is_figure(&self.input) {
            let of_figures = [
                (self.boundary.given().unwrap_or_default(), self.boundary.given().is_some()),
                ("--missed-degrees", self.missed_degrees.is_some()),
            ];
            if let Some(name) = given(&of_figures) {
                let message = format!("{name} is for plane figures, which GeoJSON files hold");
                return Err(Failure::usage(message));
            }
            if self.output.output.as_deref().is_some_and(is_figure) {
                let message = "GeoJSON holds what is in the plane, and no axis of a mesh";
                return Err(Failure::usage(message));
            }
            return Ok(());
        }
        match given(&of_points).filter(|_| !self.points) {
            Some(name) => Err(Failure::usage(format!("{name} is for points; give --points"))),
            None => Ok(()),
        }
    }

    /// The options in effect, but for defaults that are numbers of the input.
    fn describe(&self, report: &mut Report) {
        self.output.describe(&mut report.parameters);
        self.boundary.describe(report);
        let clip = match (self.clip, self.side) {
            (Some(share), _) => share,
            (None, Side::Inner) => 0.0,
            (None, _) => 0.5,
        };
        for (name, value) in [
            ("what", json!(self.what().name())),
            ("side", json!(self.side.name())),
            ("object_degrees", json!(self.object_degrees)),
            ("between_sites", json!(self.between_sites)),
            ("pairs", json!((!self.pairs.is_empty()).then_some(&self.pairs))),
            ("clip", json!(clip)),
        ] {
            report.parameters.insert(name.into(), value);
        }
    }

    fn side(&self) -> medial::Side {
        match self.side {
            Side::Inner => medial::Side::Inner,
            Side::Outer => medial::Side::Outer,
            Side::Both => medial::Side::Both,
        }
    }

    /// The least object angle, in radians.
    fn angle(&self) -> f64 {
        (self.object_degrees * (PI / 180.0)).min(PI)
    }

    /// The corners of the box to look at, if it is asked for.
    fn clip(&self, sites: &Sites) -> Option<[[f64; 3]; 2]> {
        let bounds = sites.bounds()?;
        self.clip.map(|share| {
            let margin = share * sites.size();
            [bounds.min.map(|x| x - margin), bounds.max.map(|x| x + margin)]
        })
    }

    /// The arcs and junctions of a figure's axis.
    fn graph(
        &self,
        sites: &Arc<Sites>,
        report: &mut Report,
        session: &mut Session,
    ) -> Result<Complex, Failure> {
        let spacing = if self.density > 0.0 { self.density } else { 0.01 * sites.size() };
        let asked = GraphOptions {
            side: self.side(),
            spacing,
            angle: self.angle(),
            min_distance: self.min_distance,
            between_sites: self.between_sites,
            clip: self.clip(sites),
        };
        let graph = match self.pairs.is_empty() {
            true => MedialGraph::new(sites, asked, &session.job)?,
            false => MedialGraph::between(sites, &self.pairs, asked, &session.job)?,
        };
        self.validate.report(report, || graph.validate(&session.job))?;
        let complex = graph.complex(&session.job)?;
        let length = length(&complex);
        report.parameters.insert("density".into(), json!(spacing));
        report.parameters.insert("min_distance".into(), json!(self.min_distance));
        for name in ["missed_degrees", "samples", "epsilon", "tolerance"] {
            report.parameters.insert(name.into(), Value::Null);
        }
        let field = json!({
            "sites": sites.site_count(),
            "pieces": sites.pieces().len(),
            "nodes": graph.node_count(),
            "arcs": graph.arcs().len(),
            "length": length,
            "torn": graph.torn(),
        });
        report.more.insert("field".into(), field);
        report.more.insert("claim".into(), Value::Null);
        let (nodes, arcs) = (graph.node_count(), graph.arcs().len());
        report.lines.push(("graph", format!("{nodes} nodes, {arcs} arcs of length {length}")));
        if graph.torn() > 0 {
            let torn = graph.torn();
            session.warn(&format!(
                "{torn} sides of arcs have no other side that agrees: the graph may be wrong where parts are apart by next to nothing, or vertices nearly straight"
            ));
        }
        Ok(complex)
    }

    /// Points of the axis, and what can have been missed; or the surface that goes on from them.
    fn sample(
        &self,
        sites: &Arc<Sites>,
        report: &mut Report,
        session: &Session,
    ) -> Result<Complex, Failure> {
        let missed = self.missed_degrees.unwrap_or(MISSED_DEGREES);
        let asked = FieldOptions {
            side: self.side(),
            density: self.density,
            angle: self.angle(),
            min_distance: self.min_distance,
            bound: (missed * (PI / 180.0)).min(PI.next_down()),
            samples: self.samples.unwrap_or(0),
            between_sites: self.between_sites,
            clip: self.clip(sites),
            decide: DecideOptions {
                tolerance: self.tolerance.unwrap_or(0.0),
                epsilon: self.epsilon.unwrap_or(0.0),
            },
        };
        let axis = match self.pairs.is_empty() {
            true => FieldAxis::new(sites, asked, &session.job)?,
            false => FieldAxis::between(sites, &self.pairs, asked, &session.job)?,
        };
        self.validate.report(report, || axis.validate(&session.job))?;
        let found = axis.options();
        let in_plane = sites.dimension() == 2;
        for (name, value) in [
            ("density", json!(found.density)),
            ("min_distance", json!(found.min_distance)),
            ("missed_degrees", json!(in_plane.then_some(missed))),
            ("samples", json!(found.samples)),
            ("epsilon", json!(found.decide.epsilon)),
            ("tolerance", json!(found.decide.tolerance)),
        ] {
            report.parameters.insert(name.into(), value);
        }
        let field = json!({
            "sites": sites.site_count(),
            "pieces": sites.pieces().len(),
            "points": axis.points().len(),
            "covers": axis.covers().len(),
            "unconfirmed": axis.unconfirmed(),
        });
        report.more.insert("field".into(), field);
        let (claim, words) = claim(&axis);
        report.more.insert("claim".into(), claim);
        report.lines.push(("claim", words));
        Ok(match self.points {
            true => axis.complex(&session.job)?,
            false => axis.surface(&session.job)?,
        })
    }
}

/// What theorem 10 says of a result: for scripts, and in words.
fn claim(axis: &FieldAxis) -> (Value, String) {
    if axis.sites().dimension() != 2 {
        let words = "none: in space no theorem tells what can have been missed";
        return (Value::Null, words.into());
    }
    let (angle, without) = axis.claim();
    let degrees = angle * (180.0 / PI);
    let circles = axis.covers().len();
    let FieldOptions { density, min_distance, .. } = axis.options();
    let claim = json!({
        "missed_degrees": degrees,
        "circles": circles,
        "circles_without_claim": without,
    });
    // Never less than it is.
    let shown = (degrees * 100.0).ceil() / 100.0;
    let mut words = format!(
        "whatever of the axis lies {min_distance} or more from the figure, with an object angle above {shown} degrees, has a point within {density}"
    );
    if without > 0 {
        words +=
            &format!(", but in {without} of {circles} circles, where what was found does not pass");
    }
    (claim, words)
}

/// The length of all edges.
fn length(complex: &Complex) -> f64 {
    let at = |v: u32| complex.vertices()[v as usize];
    let edge = |&[a, b]: &[u32; 2]| {
        let (a, b) = (at(a), at(b));
        (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
    };
    complex.edges().iter().map(edge).fold(0.0, |all, length| all + length)
}
