//! Flat tetrahedra of the power shapes, counted and collapsed.

use crate::report::Report;
use crate::session::{Failure, Session};
use medax::complex::{Element, FlattenOptions, Values};
use medax::{Complex, PowerCrust};
use serde_json::json;

#[derive(clap::Args)]
pub struct FlattenArguments {
    /// Collapse the flat tetrahedra of the power shape to their triangles, without changing its homotopy type
    #[arg(long, requires = "shape")]
    flatten: bool,
    /// Tetrahedra are flat if their least altitude is at most this share of their longest edge; 0.1 by default
    #[arg(long, allow_hyphen_values = true, value_name = "RATIO")]
    flatness: Option<f64>,
}

impl FlattenArguments {
    fn options(&self) -> FlattenOptions {
        self.flatness.map_or_else(FlattenOptions::default, |flatness| FlattenOptions { flatness })
    }

    /// Refuses what cannot be, before anything is read.
    pub fn check(&self) -> Result<(), Failure> {
        match self.flatness {
            Some(ratio) if ratio.is_nan() || ratio < 0.0 => {
                Err(Failure::usage(format!("--flatness must not be negative, and is {ratio:?}")))
            }
            _ => Ok(()),
        }
    }

    /// How many tetrahedra the shapes have, and how many of them are flat.
    pub fn describe(&self, crust: &PowerCrust, report: &mut Report) {
        let limit = self.options().flatness;
        let flat = |shape: &Complex| match shape.attribute(Element::Cell, "flatness") {
            Some(attribute) => match attribute.values() {
                Values::F64(values) => values.iter().filter(|&&value| value <= limit).count(),
                Values::U32(_) => 0,
            },
            None => 0,
        };
        let mut words = Vec::new();
        let mut object = serde_json::Map::new();
        for (name, shape) in [("inner", crust.inner_shape()), ("outer", crust.outer_shape())] {
            let (all, flat) = (shape.cells().len(), flat(shape));
            words.push(format!("{all} {name} ({flat} flat)"));
            object.insert(name.into(), json!({ "all": all, "flat": flat }));
        }
        report.parameters.insert("flatten".into(), json!(self.flatten));
        report.parameters.insert("flatness".into(), json!(limit));
        report.more.insert("tetrahedra".into(), object.into());
        report.lines.push(("tetrahedra", words.join(", ")));
    }

    /// The shape without its flat tetrahedra, if that is asked for.
    pub fn apply(
        &self,
        shape: Complex,
        report: &mut Report,
        session: &Session,
    ) -> Result<Complex, Failure> {
        if !self.flatten {
            return Ok(shape);
        }
        let flattened = shape.flatten(self.options(), &session.job)?;
        let (collapsed, left) = (flattened.collapses.len(), flattened.left);
        let counts = json!({ "collapsed": collapsed, "left": left });
        report.more.insert("flattened".into(), counts);
        let mut line = format!("{collapsed} tetrahedra collapsed");
        if left > 0 {
            line += &format!(", {left} flat ones left between others");
        }
        report.lines.push(("flattened", line));
        Ok(flattened.complex)
    }
}
