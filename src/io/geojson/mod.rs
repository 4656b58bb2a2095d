//! GeoJSON (RFC 7946): plane figures in, plane complexes out.
//!
//! The JSON itself is left to `serde_json`, which tells the line of an error and never builds a tree here: coordinates go
//! straight into flat arrays.

mod geometry;
mod object;
mod source;
mod write;

pub(super) use write::{check, write};

use crate::error::{ElementKind, Error, Result, Status};
use crate::figure::{Figure, FigureOptions};
use crate::job::{Job, Run, Stage};
use object::{Collector, Expected, Object};
use serde_core::de::DeserializeSeed;
use source::Source;

/// Which features of a file make up a figure.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum FeatureChoice {
    /// All of them.
    #[default]
    All,
    /// Those of which the `id`, or one of the properties `name`, `NAME`, `glyph` and `id`, is this text, or a number written so.
    Named(String),
    /// The one of this number, from 0. A geometry that is no feature's is number 0.
    Numbered(usize),
}

/// How to read a figure.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadFigureOptions {
    /// Which features.
    pub feature: FeatureChoice,
    /// How to make a figure of them.
    pub figure: FigureOptions,
}

/// The figure that the bytes of a GeoJSON file hold.
///
/// A polygon is one, a line an open polyline, a point a point, or a circle where its feature has a property `radius`
/// greater than 0. Further coordinates, and members that are not known, are passed over. Rings are counted over the chosen features.
///
/// Errors: [`Status::Format`] with the line where the bytes are malformed, with byte 0 where there are none;
/// [`Status::InvalidArgument`] where no feature has the name or number; those of [`Figure::new`], which name the feature, too.
/// Cost: that of [`Figure::new`].
pub fn parse_figure(bytes: &[u8], options: &ReadFigureOptions, job: &Job) -> Result<Figure> {
    job.run(&[(Stage::Read, 0.5), (Stage::Order, 0.5)], |run| {
        run.enter(Stage::Read)?;
        parse_figure_in(bytes, options, run)
    })
}

pub(super) fn parse_figure_in(
    bytes: &[u8],
    options: &ReadFigureOptions,
    run: &Run<'_>,
) -> Result<Figure> {
    if bytes.is_empty() {
        let error = Error::new(Status::Format, "the file is empty");
        return Err(error.at(ElementKind::Byte, 0));
    }
    let source = Source::new(bytes, run);
    let mut collector = Collector::new(&options.feature, &source);
    let mut deserializer = serde_json::Deserializer::from_reader(source.reader());
    let object = Object { collector: &mut collector, expected: Expected::Any };
    object
        .deserialize(&mut deserializer)
        .and_then(|()| deserializer.end())
        .map_err(|error| source.error(&error))?;
    collector.check_choice()?;
    Figure::new_in(collector.parts(), options.figure, run)
        .map_err(|error| collector.of_feature(error))
}
