//! `medax sample`: points of a built-in shape or of a mesh.

use crate::report::{Counts, Input, Report};
use crate::session::{Failure, OutputOptions, Session};
use medax::sample::{SampleOptions, Shape, sample, sample_mesh};
use serde_json::{Map, json};
use std::path::{Path, PathBuf};

/// Take points of a built-in shape, or of the faces of a mesh
///
/// The points are spread evenly and at random: no two are nearer than the spacing, and no point of the
/// surface is farther than about 1.3 spacings from one of them.
#[derive(clap::Args)]
pub struct Options {
    /// torus, box, capsule, ellipsoid, trefoil, genus3, bracket, sphere, or a mesh file
    input: PathBuf,
    #[command(flatten)]
    output: OutputOptions,
    /// The least distance between two points, in input units; by default a quarter of a smooth
    /// shape's least feature size, a hundredth of a mesh's diagonal
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH", conflicts_with = "density")]
    spacing: Option<f64>,
    /// About how many points a unit of area gets
    #[arg(long, allow_hyphen_values = true, value_name = "COUNT")]
    density: Option<f64>,
    /// The standard deviation of Gaussian noise along the normal, in input units
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH", default_value_t = 0.0)]
    noise: f64,
    /// Which of the many samples: the same seed gives the same points
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
}

/// Fewer samples span no solid.
const FEWEST: usize = 4;

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    let positive = |name: &str, value: Option<f64>| match value {
        Some(value) if value.is_nan() || value <= 0.0 => {
            Err(Failure::usage(format!("--{name} must be a positive number, not {value:?}")))
        }
        value => Ok(value.unwrap_or(0.0)),
    };
    let asked = SampleOptions {
        spacing: positive("spacing", options.spacing)?,
        density: positive("density", options.density)?,
        noise: options.noise,
        seed: options.seed,
    };
    let shape = options.input.to_str().and_then(Shape::from_name);
    let (samples, input) = match shape {
        Some(shape) => (sample(shape, asked, &session.job)?, Input::default()),
        None => {
            let mesh = read_mesh(&options.input, session)?;
            let samples = sample_mesh(&mesh, asked, &session.job)?;
            (samples, Input::of_complex(&options.input, &mesh))
        }
    };
    let count = samples.points().len();
    if count < FEWEST {
        let noun = if count == 1 { "sample" } else { "samples" };
        let spacing = samples.spacing();
        session.warn(&format!(
            "a spacing of {spacing:?} leaves {count} {noun}: too few to tell anything of the shape"
        ));
    }
    let points = samples.to_complex()?;
    let mut parameters = Map::new();
    parameters.insert("spacing".into(), json!(samples.spacing()));
    parameters.insert("density".into(), json!(options.density));
    parameters.insert("noise".into(), json!(options.noise));
    parameters.insert("seed".into(), json!(options.seed));
    options.output.describe(&mut parameters);
    let mut more = Map::new();
    more.insert("area".into(), json!(samples.area()));
    let mut lines = Vec::new();
    if let Some(shape) = shape {
        let (name, genus) = (shape.name(), shape.genus());
        let known = json!({
            "name": name,
            "genus": genus,
            "components": shape.components(),
            "smooth": shape.is_smooth(),
        });
        more.insert("shape".into(), known);
        let edges = if shape.is_smooth() { "smooth" } else { "sharp edges" };
        lines.push(("shape", format!("{name}, genus {genus}, {edges}")));
    }
    lines.push(("spacing", format!("{}", samples.spacing())));
    lines.push(("area", format!("{:.4}", samples.area())));
    let output =
        session.deliver("samples", &points, options.output.output.as_deref(), &options.output)?;
    Ok(Report {
        command: "sample",
        input,
        parameters,
        counts: Counts { vertices: Some(samples.points().len() as u64), ..Counts::default() },
        outputs: vec![output],
        more,
        lines,
    })
}

fn read_mesh(path: &Path, session: &mut Session) -> Result<medax::Complex, Failure> {
    if path.extension().is_none() && !path.exists() {
        let names = Shape::ALL.map(Shape::name).join(", ");
        let shown = path.display();
        return Err(Failure::usage(format!("'{shown}' is neither a shape ({names}) nor a file")));
    }
    session.read_complex(path)
}
