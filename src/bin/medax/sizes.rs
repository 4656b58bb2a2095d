//! Local feature size and thickness, for `medax crust`.

use crate::report::Report;
use crate::session::{Failure, OutputOptions, Session};
use medax::complex::{Element, Values};
use medax::{Complex, PowerCrust};
use serde_json::{Map, json};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct SizeOptions {
    /// Give the vertices of the surface the local feature size and the thickness of the solid
    #[arg(long)]
    sizes: bool,
    /// Where to write the samples, with local feature size, thickness and row
    #[arg(long, value_name = "FILE")]
    samples: Option<PathBuf>,
    /// Read points, or a mesh, and write it with local feature size and thickness at its vertices
    #[arg(long, num_args = 2, value_names = ["POINTS", "FILE"])]
    sizes_at: Option<Vec<PathBuf>>,
}

impl SizeOptions {
    /// The files that are written, besides the surface.
    pub fn files(&self) -> [Option<PathBuf>; 2] {
        [self.samples.clone(), self.at().map(|[_, file]| file.clone())]
    }

    /// The points to be measured, if there are any to read.
    pub fn read(&self, session: &mut Session) -> Result<Option<Complex>, Failure> {
        self.at().map(|[points, _]| session.read_complex(points)).transpose()
    }

    /// The surface with its sizes, if they are asked for.
    pub fn of_surface(
        &self,
        crust: &PowerCrust,
        surface: &Complex,
        session: &Session,
    ) -> Result<Option<Complex>, Failure> {
        let sized = self.sizes.then(|| crust.with_sizes(surface, &session.job));
        Ok(sized.transpose()?)
    }

    /// Writes samples and points, and says what the sizes of the samples are.
    pub fn deliver(
        &self,
        crust: &PowerCrust,
        points: Option<Complex>,
        output: &OutputOptions,
        report: &mut Report,
        session: &mut Session,
    ) -> Result<(), Failure> {
        report.parameters.insert("sizes".into(), json!(self.sizes));
        let at = self.at().map(|[points, _]| points.to_string_lossy());
        report.parameters.insert("sizes_at".into(), json!(at));
        if !self.sizes && self.samples.is_none() && self.sizes_at.is_none() {
            return Ok(());
        }
        let samples = crust.samples_to_complex(&session.job)?;
        let mut summary = Map::new();
        for (name, words) in [("feature_size", "feature size"), ("thickness", "thickness")] {
            let Some([min, median, max]) = summarised(&samples, name) else { continue };
            let lengths = json!({ "min": min, "median": median, "max": max });
            summary.insert(name.into(), lengths);
            report.lines.push((words, format!("min {min}, median {median}, max {max}")));
        }
        report.more.insert("sizes".into(), summary.into());
        if let Some(path) = &self.samples {
            report.outputs.push(session.deliver("samples", &samples, Some(path), output)?);
        }
        if let (Some(points), Some([from, path])) = (points, self.at()) {
            let sized = crust.with_sizes(&points, &session.job).map_err(Failure::about(from))?;
            report.outputs.push(session.deliver("sizes", &sized, Some(path), output)?);
        }
        Ok(())
    }

    /// What is read and what is written.
    fn at(&self) -> Option<&[PathBuf; 2]> {
        self.sizes_at.as_deref()?.first_chunk()
    }
}

/// The least, the middle and the largest value of an attribute; of two in the middle the lesser.
fn summarised(samples: &Complex, name: &str) -> Option<[f64; 3]> {
    let Values::F64(values) = samples.attribute(Element::Vertex, name)?.values() else {
        return None;
    };
    let mut values = values.clone();
    values.sort_unstable_by(f64::total_cmp);
    Some([*values.first()?, values[(values.len() - 1) / 2], *values.last()?])
}
