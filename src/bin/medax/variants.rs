//! What `medax crust` makes of a power crust: a simpler one, an offset, one with holes.

use crate::report::Report;
use crate::session::{Failure, Session};
use medax::crust::{HoleOptions, SimplifyOptions};
use medax::{Complex, PowerCrust};
use serde_json::json;
use std::sync::Arc;

#[derive(clap::Args)]
pub struct VariantOptions {
    /// Simplify the power shape: leave out poles whose samples are close to each other, and those whose balls lie in a
    /// larger one, but for a little
    #[arg(long)]
    simplify: bool,
    /// For --simplify: how far samples may be from where they belong; by default a hundredth of the diagonal of their box
    #[arg(long, requires = "simplify", allow_hyphen_values = true, value_name = "LENGTH")]
    epsilon: Option<f64>,
    /// For --simplify: how far balls may protrude from a larger one; by default three thousandths of the diagonal
    #[arg(long, requires = "simplify", allow_hyphen_values = true, value_name = "LENGTH")]
    delta: Option<f64>,
    /// Make an approximate offset surface at this distance, outside if it is positive, inside if it is negative
    #[arg(long, allow_hyphen_values = true, value_name = "DISTANCE")]
    offset: Option<f64>,
    /// Leave out the faces that fill holes: those between an inner and an outer ball that intersect deeply and are large
    #[arg(long)]
    holes: bool,
    /// For --holes: balls intersect deeply where the angle between their spheres exceeds this; from 90 to 180, by default
    /// 95.74, which is arccos(-0.1)
    #[arg(long, requires = "holes", allow_hyphen_values = true, value_name = "DEGREES")]
    hole_degrees: Option<f64>,
    /// For --holes: balls are large if their radii exceed this; by default all are
    #[arg(long, requires = "holes", allow_hyphen_values = true, value_name = "LENGTH")]
    hole_radius: Option<f64>,
}

impl VariantOptions {
    /// Which faces fill holes, if any are to be left out.
    fn hole_options(&self) -> Result<Option<HoleOptions>, Failure> {
        let mut holes = HoleOptions::default();
        if let Some(degrees) = self.hole_degrees {
            if !(90.0..=180.0).contains(&degrees) {
                let message =
                    format!("--hole-degrees must lie between 90 and 180, not {degrees:?}");
                return Err(Failure::usage(message));
            }
            // The cosine of 90 degrees comes out as 6e-17.
            holes.depth = (-libm::cos(degrees.to_radians())).clamp(0.0, 1.0);
        }
        holes.radius = self.hole_radius.unwrap_or(holes.radius);
        Ok(self.holes.then_some(holes))
    }

    /// Refuses what cannot be, before anything is read.
    pub fn check(&self) -> Result<(), Failure> {
        self.hole_options()?;
        let lengths = [
            ("--epsilon", self.epsilon),
            ("--delta", self.delta),
            ("--hole-radius", self.hole_radius),
        ];
        for (name, value) in lengths {
            if let Some(value) = value
                && !(value.is_finite() && value >= 0.0)
            {
                let message = format!("{name} must be a length and not negative, not {value:?}");
                return Err(Failure::usage(message));
            }
        }
        match self.offset {
            Some(distance) if !distance.is_finite() => {
                Err(Failure::usage(format!("--offset must be a number, not {distance:?}")))
            }
            _ => Ok(()),
        }
    }

    /// Whether balls may be left out.
    pub fn leaves_out(&self) -> bool {
        self.simplify || self.offset.is_some()
    }

    /// The power crust that is asked for: simplified first, then offset.
    pub fn apply(
        &self,
        crust: PowerCrust,
        report: &mut Report,
        session: &Session,
    ) -> Result<Arc<PowerCrust>, Failure> {
        let mut crust = Arc::new(crust);
        if self.simplify {
            let options = SimplifyOptions { epsilon: self.epsilon, delta: self.delta };
            let simplified = crust.simplify(options, &session.job)?;
            let (unstable, redundant) = (simplified.unstable.len(), simplified.redundant.len());
            report.parameters.insert("epsilon".into(), json!(simplified.epsilon));
            report.parameters.insert("delta".into(), json!(simplified.delta));
            let counts = json!({ "unstable": unstable, "redundant": redundant });
            report.more.insert("simplified".into(), counts);
            let line = format!("{unstable} unstable and {redundant} redundant poles left out");
            report.lines.push(("simplified", line));
            crust = simplified.crust;
        }
        report.parameters.insert("offset".into(), json!(self.offset));
        if let Some(distance) = self.offset {
            crust = Arc::new(crust.offset(distance, &session.job)?);
        }
        Ok(crust)
    }

    /// The surface without the faces that fill holes, if that is asked for.
    pub fn opened(
        &self,
        crust: &PowerCrust,
        report: &mut Report,
        session: &Session,
    ) -> Result<Option<Complex>, Failure> {
        let Some(options) = self.hole_options()? else { return Ok(None) };
        let open = crust.open(options, &session.job)?;
        let left_out = open.left_out.faces().len();
        report.parameters.insert("hole_depth".into(), json!(options.depth));
        report.parameters.insert("hole_radius".into(), json!(options.radius));
        report.more.insert("hole_faces_left_out".into(), json!(left_out));
        report.lines.push(("holes", format!("{left_out} faces left out")));
        Ok(Some(open.surface))
    }
}
