//! Which poles are left out, for `medax poles` and `medax crust`.

use crate::report::Report;
use crate::session::Failure;
use medax::Poles;
use medax::poles::{Omit, PolesOptions};
use serde_json::json;
use std::f64::consts::FRAC_PI_4;

#[derive(clap::Args)]
pub struct OmitOptions {
    /// The sample is noisy: leave out poles that are nearer than the spacing of the sample allows
    #[arg(long, conflicts_with = "sharp_corners")]
    noise: bool,
    /// The solid has sharp edges: leave out both poles of a sample where one is too near
    #[arg(long)]
    sharp_corners: bool,
    /// The spacing of the sample, relative to the local feature size, for --noise and --sharp-corners; from 0 to 0.78. Without it,
    /// or with 0, it is estimated
    #[arg(long, allow_hyphen_values = true, value_name = "RATIO")]
    lambda: Option<f64>,
}

impl OmitOptions {
    pub fn translate(&self) -> Result<PolesOptions, Failure> {
        let omit = match (self.noise, self.sharp_corners) {
            (true, _) => Omit::Side,
            (_, true) => Omit::Both,
            _ if self.lambda.is_some() => {
                return Err(Failure::usage("--lambda needs --noise or --sharp-corners"));
            }
            _ => Omit::Nothing,
        };
        let lambda = self.lambda.unwrap_or(0.0);
        if !(0.0..FRAC_PI_4).contains(&lambda) {
            let message = format!("--lambda must lie between 0 and 0.78, not {lambda:?}");
            return Err(Failure::usage(message));
        }
        Ok(PolesOptions { omit, lambda })
    }

    /// What was asked for, and the lambda that was found.
    pub fn report(&self, report: &mut Report, poles: &Poles) {
        report.parameters.insert("noise".into(), json!(self.noise));
        report.parameters.insert("sharp_corners".into(), json!(self.sharp_corners));
        report.parameters.insert("lambda".into(), json!(poles.lambda()));
    }
}
