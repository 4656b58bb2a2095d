//! `medax crust`: the power crust, the power shape and the labelled poles.

use crate::flatten::FlattenArguments;
use crate::omit::OmitOptions;
use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use crate::side::Side;
use crate::sizes::SizeOptions;
use crate::variants::VariantOptions;
use medax::crust::{CONFLICT_LIMIT, Label, LabelRule, PowerCrustOptions};
use medax::{Complex, PowerCrust};
use serde_json::json;
use std::f64::consts::PI;
use std::path::PathBuf;

/// Build the power crust: a closed surface from a sample, and an approximate medial axis
#[derive(clap::Args)]
pub struct Options {
    /// A file of points; of a mesh the vertices that it uses
    input: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    output: OutputOptions,
    /// Write the surface as triangles instead of convex polygons
    #[arg(long)]
    triangles: bool,
    /// Where to write the power shape, an approximation of the medial axis
    #[arg(long, value_name = "FILE")]
    shape: Option<PathBuf>,
    /// The side of the surface whose power shape is written
    #[arg(long, value_enum, default_value_t = Side::Inner)]
    side: Side,
    /// Write the scale axis of that side in place of the power shape: of balls grown by this factor, so that features are gone that are small
    /// beside what is near, and shrunk back
    #[arg(long, allow_hyphen_values = true, value_name = "FACTOR", requires = "shape")]
    scale_axis: Option<f64>,
    /// Where to write the poles, with radius, object angle and label (0 outer, 1 inner)
    #[arg(long, value_name = "FILE")]
    poles: Option<PathBuf>,
    /// Balls of neighbouring poles intersect deeply, and are of one side, where the angle between
    /// their spheres exceeds this; from 90 to 180, by default 113.58, which is arccos(-0.4)
    #[arg(long, allow_hyphen_values = true, value_name = "DEGREES")]
    deep_degrees: Option<f64>,
    /// Round the centres of the poles' balls to a grid, 2^-36 of the size of the sample, which is faster
    #[arg(long)]
    round_poles: bool,
    /// Keep the shards of every sample: vertices of the power diagram that are the sample but for rounding
    #[arg(long)]
    keep_shards: bool,
    /// How poles are labelled inner and outer: by labels that spread from outside and are never taken back, by changing them until
    /// they contradict each other least, or automatically by the latter where the former leaves much conflict
    #[arg(long, value_enum, value_name = "RULE", default_value_t = Rule::Auto, conflicts_with = "label_mesh")]
    labels: Rule,
    /// Where the scanner of a one-sided scan was: what it sees is the outside
    #[arg(long, num_args = 3, allow_hyphen_values = true, value_names = ["X", "Y", "Z"], conflicts_with = "label_mesh")]
    viewpoint: Option<Vec<f64>>,
    /// Label the poles by this mesh instead, which may be the input itself: inner where its faces, which must point out of
    /// the solid, wind round a pole
    #[arg(long, value_name = "MESH")]
    label_mesh: Option<PathBuf>,
    #[command(flatten)]
    omit: OmitOptions,
    #[command(flatten)]
    variants: VariantOptions,
    #[command(flatten)]
    sizes: SizeOptions,
    #[command(flatten)]
    flatten: FlattenArguments,
    #[command(flatten)]
    validate: ValidateOptions,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Rule {
    Auto,
    Spread,
    LeastConflict,
}

impl Rule {
    fn translate(self) -> (LabelRule, &'static str) {
        match self {
            Rule::Auto => (LabelRule::Auto, "auto"),
            Rule::Spread => (LabelRule::Spread, "spread"),
            Rule::LeastConflict => (LabelRule::LeastConflict, "least-conflict"),
        }
    }
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    let [samples, sizes] = options.sizes.files();
    options.output.check(&[&options.shape, &options.poles, &samples, &sizes])?;
    options.variants.check()?;
    options.flatten.check()?;
    if options.scale_axis.is_some() && options.side == Side::Both {
        return Err(Failure::usage("--scale-axis is of one side, inner or outer"));
    }
    let mut asked = match options.deep_degrees {
        None => PowerCrustOptions::default(),
        Some(degrees) if (90.0..=180.0).contains(&degrees) => {
            // The cosine of 90 degrees comes out as 6e-17.
            let deep = (-libm::cos(degrees * (PI / 180.0))).clamp(0.0, 1.0);
            PowerCrustOptions { deep, ..PowerCrustOptions::default() }
        }
        Some(degrees) => {
            let message = format!("--deep-degrees must lie between 90 and 180, not {degrees:?}");
            return Err(Failure::usage(message));
        }
    };
    asked.round_poles = options.round_poles;
    asked.keep_shards = options.keep_shards;
    let (rule, rule_name) = options.labels.translate();
    asked.label_rule = rule;
    asked.viewpoint = options.viewpoint.as_ref().map(|at| [at[0], at[1], at[2]]);
    asked.poles = options.omit.translate()?;
    let soup = session.read(&options.input)?;
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    drop(soup);
    let points_to_measure = options.sizes.read(session)?;
    let mesh = match &options.label_mesh {
        Some(path) => Some((path, session.read_complex(path)?)),
        None => None,
    };
    let mut crust = PowerCrust::build(&points, asked, &session.job)?;
    if let Some((path, mesh)) = mesh {
        crust = crust.labelled_by_mesh(&mesh, &session.job).map_err(Failure::about(path))?;
    }
    let mut report = Report { command: "crust", input, ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.output.describe(&mut report.parameters);
    let degrees = libm::acos(-asked.deep) * (180.0 / PI);
    for (name, value) in [
        ("deep_degrees", json!(options.deep_degrees.unwrap_or(degrees))),
        ("round_poles", json!(options.round_poles)),
        ("keep_shards", json!(options.keep_shards)),
        ("labels", json!(if options.label_mesh.is_some() { "mesh" } else { rule_name })),
        ("viewpoint", json!(options.viewpoint)),
        ("triangles", json!(options.triangles)),
        ("side", json!(options.side.name())),
        ("scale_axis", json!(options.scale_axis)),
        ("label_mesh", json!(options.label_mesh.as_ref().map(|path| path.to_string_lossy()))),
    ] {
        report.parameters.insert(name.into(), value);
    }
    options.omit.report(&mut report, crust.poles());
    let was_empty = crust.surface().faces().is_empty();
    let crust = options.variants.apply(crust, &mut report, session)?;
    options.validate.report(&mut report, || crust.validate(&session.job))?;
    describe(&crust, &mut report);
    if crust.conflict() > CONFLICT_LIMIT {
        session.warn(&format!(
            "labels contradict each other ({:.3} a pole): the sample is noisy or has gaps, and parts of the surface may be guesses",
            crust.conflict()
        ));
    }
    options.flatten.describe(&crust, &mut report);
    if crust.surface().faces().is_empty() {
        session.warn(match options.label_mesh {
            _ if options.variants.leaves_out() && !was_empty => {
                "no inner ball is left, so the surface is empty; take a smaller offset, epsilon or delta"
            }
            None => "no pole is inner, so the surface is empty: the sample is too sparse for its shape",
            Some(_) => {
                "no pole is inner, so the surface is empty: the mesh winds round none; it may be turned inside out, or be elsewhere"
            }
        });
    }

    let open = options.variants.opened(&crust, &mut report, session)?;
    let whole = open.as_ref().unwrap_or(crust.surface());
    let triangles = if options.triangles { Some(whole.triangulated()?) } else { None };
    let surface = triangles.as_ref().unwrap_or(whole);
    let sized = options.sizes.of_surface(&crust, surface, session)?;
    let surface = sized.as_ref().unwrap_or(surface);
    report.counts = Counts {
        cells: Some(crust.regular().cells().len() as u64),
        hidden: Some(crust.regular().hidden().len() as u64),
        poles: Some(crust.poles().len() as u64),
        ..Counts::from(surface)
    };
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver("surface", surface, path, &options.output)?);
    if let Some(path) = &options.shape {
        let (name, shape) = match (options.scale_axis, options.side) {
            (None, side) => shape(&crust, side)?,
            (Some(factor), Side::Inner) => {
                ("inner scale axis", crust.scale_axis(Label::Inner, factor, &session.job)?)
            }
            (Some(factor), _) => {
                ("outer scale axis", crust.scale_axis(Label::Outer, factor, &session.job)?)
            }
        };
        let shape = options.flatten.apply(shape, &mut report, session)?;
        report.outputs.push(session.deliver(name, &shape, Some(path), &options.output)?);
    }
    if let Some(path) = &options.poles {
        let poles = crust.poles_to_complex()?;
        report.outputs.push(session.deliver("poles", &poles, Some(path), &options.output)?);
    }
    options.sizes.deliver(&crust, points_to_measure, &options.output, &mut report, session)?;
    Ok(report)
}

/// What the labelling found.
fn describe(crust: &PowerCrust, report: &mut Report) {
    let inner = crust.labels().iter().filter(|&&label| label == Label::Inner).count();
    let outer = crust.labels().len() - inner;
    let (unreached, forced) = (crust.unreached_count(), crust.forced_count());
    let (conflict, settled) = (crust.conflict(), crust.is_settled());
    let labels = json!({
        "inner": inner,
        "outer": outer,
        "unreached": unreached,
        "forced": forced,
        "conflict": conflict,
        "settled": settled,
    });
    report.more.insert("labels".into(), labels);
    let mut line = format!("{inner} inner, {outer} outer poles");
    if unreached > 0 {
        line += &format!(", {unreached} reached by no other");
    }
    if forced > 0 {
        line += &format!(", {forced} forced out");
    }
    report.lines.push(("labels", line));
    let how = if settled { ", after labels were changed to lessen it" } else { "" };
    report.lines.push(("conflict", format!("{conflict:.2e} a pole{how}")));
}

fn shape(crust: &PowerCrust, side: Side) -> Result<(&'static str, Complex), Failure> {
    Ok(match side {
        Side::Inner => ("inner shape", crust.inner_shape().as_ref().clone()),
        Side::Outer => ("outer shape", crust.outer_shape().as_ref().clone()),
        Side::Both => ("shape", crust.both_shapes()?),
    })
}
