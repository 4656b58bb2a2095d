//! Plane figures: which features of a file they are made of, and what is said of them.

use crate::report::{Input, Report};
use crate::session::{Failure, Session};
use medax::figure::{ChainKind, Crossings, Figure, FigureOptions};
use medax::io::{self, FeatureChoice, Format, ReadFigureOptions};
use medax::{Error, Status};
use serde_json::json;
use std::path::Path;

/// Which features of a GeoJSON file make up the figure.
#[derive(clap::Args)]
#[group(multiple = false)]
pub struct FeatureOptions {
    /// Of a GeoJSON file take only the features whose id, or property name, NAME, glyph or id, is this
    #[arg(long, value_name = "NAME")]
    feature: Option<String>,
    /// Of a GeoJSON file take only the feature of this number, from 0
    #[arg(long, value_name = "NUMBER")]
    feature_number: Option<usize>,
}

/// Whether a path names a file with a plane figure.
pub fn is_figure(path: &Path) -> bool {
    matches!(Format::of_path(path), Ok(Format::GeoJson))
}

impl FeatureOptions {
    pub fn describe(&self, report: &mut Report) {
        report.parameters.insert("feature".into(), json!(self.feature));
        report.parameters.insert("feature_number".into(), json!(self.feature_number));
    }

    /// The option that was given, if any.
    pub fn given(&self) -> Option<&'static str> {
        let name = self.feature.as_ref().map(|_| "--feature");
        name.or(self.feature_number.map(|_| "--feature-number"))
    }

    /// Reads the figure of a file, and reports what it is.
    pub fn read(
        &self,
        path: &Path,
        crossings: Crossings,
        report: &mut Report,
        session: &Session,
    ) -> Result<Figure, Failure> {
        let feature = match (&self.feature, self.feature_number) {
            (Some(name), _) => FeatureChoice::Named(name.clone()),
            (None, Some(number)) => FeatureChoice::Numbered(number),
            (None, None) => FeatureChoice::All,
        };
        let options = ReadFigureOptions { feature, figure: FigureOptions { crossings } };
        let figure = io::read_figure(path, &options, &session.job).map_err(|error| {
            let is_argument = error.status() == Status::InvalidArgument;
            match error.element() {
                Some((kind, index)) if is_argument => {
                    let hint = format!("{} (--crossings)", error.message());
                    Failure::about(path)(Error::new(error.status(), hint).at(kind, index))
                }
                // No feature has the name or the number.
                _ => Failure { usage: is_argument, ..Failure::about(path)(error) },
            }
        })?;
        describe(&figure, report);
        report.input = Input::of_figure(path, &figure);
        Ok(figure)
    }
}

fn describe(figure: &Figure, report: &mut Report) {
    let count = |kind| figure.chain_count(kind);
    let counts = [
        ("polygons", count(ChainKind::Outer)),
        ("holes", count(ChainKind::Hole)),
        ("polylines", count(ChainKind::Polyline)),
        ("points", count(ChainKind::Point)),
        ("circles", figure.circles().len()),
    ];
    let normalised = figure.normalised();
    let changes = [
        ("closing_vertices", normalised.closing_vertices),
        ("repeated_vertices", normalised.repeated_vertices),
        ("turned_rings", normalised.turned_rings),
        ("crossings", normalised.crossings),
        ("misplaced", normalised.misplaced),
    ];
    let words = counts.iter().filter(|(_, count)| *count > 0);
    let words: Vec<String> = words.map(|(name, count)| format!("{name} {count}")).collect();
    report.lines.push(("figure", words.join(", ")));
    let curious = changes.iter().filter(|(name, n)| *name != "closing_vertices" && *n > 0);
    let words: Vec<String> =
        curious.map(|(name, count)| format!("{} {count}", name.replace('_', " "))).collect();
    report.lines.push(("normalised", words.join(", ")));
    let all = counts.iter().map(|&(name, n)| (name, n as u64)).chain(changes);
    let all = all.map(|(name, count)| (name.to_string(), json!(count))).collect();
    report.more.insert("figure".into(), serde_json::Value::Object(all));
}
