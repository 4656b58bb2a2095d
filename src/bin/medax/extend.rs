//! The filters by which a core is extended, as an option gives them.

use medax::medial::{MedialFilter, MedialRule, Side};
use std::f64::consts::PI;
use std::fmt::{self, Display, Formatter};
use std::mem;
use std::str::FromStr;

/// Thresholds that a facet must pass.
#[derive(Clone, Copy, Default)]
pub struct Extend {
    medial: bool,
    degrees: Option<f64>,
    lambda: Option<f64>,
    scale: Option<f64>,
}

impl FromStr for Extend {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut extend = Extend::default();
        for part in text.split(',') {
            let (name, value) = match part.split_once('=') {
                None if part == "medial" => {
                    if mem::replace(&mut extend.medial, true) {
                        return Err("medial is given twice".into());
                    }
                    continue;
                }
                Some(pair) => pair,
                None => return Err(refusal(part)),
            };
            let number: f64 = value.parse().map_err(|_| format!("'{value}' is no number"))?;
            let (place, most) = match name {
                "angle" => (&mut extend.degrees, 180.0),
                "lambda" => (&mut extend.lambda, f64::MAX),
                "scale" => (&mut extend.scale, f64::MAX),
                _ => return Err(refusal(part)),
            };
            if !(0.0..=most).contains(&number) {
                return Err(format!("{name} cannot be {value}"));
            }
            if place.replace(number).is_some() {
                return Err(format!("{name} is given twice"));
            }
        }
        Ok(extend)
    }
}

fn refusal(part: &str) -> String {
    format!("'{part}' is none of medial, angle=DEGREES, lambda=LENGTH, scale=FACTOR")
}

impl Display for Extend {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let thresholds = [("angle", self.degrees), ("lambda", self.lambda), ("scale", self.scale)];
        let given = thresholds.iter().filter_map(|(name, value)| Some((name, (*value)?)));
        let thresholds = given.map(|(name, value)| format!("{name}={value:?}"));
        let medial = self.medial.then(|| "medial".to_string());
        f.write_str(&medial.into_iter().chain(thresholds).collect::<Vec<_>>().join(","))
    }
}

impl Extend {
    pub fn needs_scales(&self) -> bool {
        self.scale.is_some_and(|scale| scale > 0.0)
    }

    /// On both sides of the surface.
    pub fn filter(&self) -> MedialFilter {
        MedialFilter {
            rule: if self.medial { MedialRule::AngleOrRatio } else { MedialRule::Every },
            object_angle: (self.degrees.unwrap_or(0.0) * (PI / 180.0)).min(PI),
            lambda: self.lambda.unwrap_or(0.0),
            scale: self.scale.unwrap_or(0.0),
            side: Side::Both,
            ..MedialFilter::default()
        }
    }
}
