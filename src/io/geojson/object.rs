//! The objects of a file: collections, features, geometries.

use super::FeatureChoice;
use super::geometry::{Coordinates, GEOMETRIES, Shape};
use super::source::Source;
use crate::error::{ElementKind, Error, Status};
use crate::figure::FigureParts;
use crate::job::Room;
use serde_core::de::{
    self, DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor,
};
use std::fmt;

/// The properties that may name a feature.
const NAMES: [&str; 4] = ["name", "NAME", "glyph", "id"];
/// How many names an error lists.
const LISTED: usize = 16;

/// The arrays of a figure in the making.
pub(super) struct Collector<'a> {
    choice: &'a FeatureChoice,
    source: &'a Source<'a>,
    room: Room<'a>,
    ring_vertices: Vec<[f64; 2]>,
    ring_offsets: Vec<u32>,
    polygon_offsets: Vec<u32>,
    polyline_vertices: Vec<[f64; 2]>,
    polyline_offsets: Vec<u32>,
    points: Vec<[f64; 2]>,
    circles: Vec<[f64; 3]>,
    /// The features seen, how many of them are chosen, and the first few names.
    seen: usize,
    chosen: usize,
    names: Vec<String>,
    features: Vec<Feature>,
}

/// A chosen feature, for messages: its number, its name, and how much there is up to its end.
struct Feature {
    number: usize,
    name: Option<String>,
    rings: usize,
    polylines: usize,
    points: usize,
    circles: usize,
}

/// How much there is before a feature.
#[derive(Clone, Copy)]
struct Mark {
    lengths: [usize; 6],
}

impl<'a> Collector<'a> {
    pub fn new(choice: &'a FeatureChoice, source: &'a Source<'a>) -> Self {
        Collector {
            choice,
            source,
            room: Room::new(source.run),
            ring_vertices: Vec::new(),
            ring_offsets: vec![0],
            polygon_offsets: vec![0],
            polyline_vertices: Vec::new(),
            polyline_offsets: vec![0],
            points: Vec::new(),
            circles: Vec::new(),
            seen: 0,
            chosen: 0,
            names: Vec::new(),
            features: Vec::new(),
        }
    }

    pub fn parts(&self) -> FigureParts<'_> {
        FigureParts {
            ring_vertices: &self.ring_vertices,
            ring_offsets: &self.ring_offsets,
            polygon_offsets: &self.polygon_offsets,
            polyline_vertices: &self.polyline_vertices,
            polyline_offsets: &self.polyline_offsets,
            points: &self.points,
            circles: &self.circles,
        }
    }

    /// Checks that some feature has been chosen, unless all are.
    pub fn check_choice(&self) -> crate::Result<()> {
        let what = match self.choice {
            FeatureChoice::All => return Ok(()),
            _ if self.chosen > 0 => return Ok(()),
            FeatureChoice::Named(name) => format!("named '{}'", name.escape_debug()),
            FeatureChoice::Numbered(number) => format!("number {number}"),
        };
        let names = match &self.names[..] {
            [] => String::new(),
            names if names.len() < LISTED => format!(": {}", names.join(", ")),
            names => format!(": {}, ...", names.join(", ")),
        };
        let message =
            format!("the file has no feature {what}; it has {}, counted from 0{names}", self.seen);
        Err(Error::new(Status::InvalidArgument, message))
    }

    /// The same error, which names the feature of its element where there are several.
    pub fn of_feature(&self, error: Error) -> Error {
        let Some((kind, index)) = error.element().filter(|_| self.seen > 1) else { return error };
        let count = |feature: &Feature| match kind {
            ElementKind::Ring => feature.rings,
            ElementKind::Polyline => feature.polylines,
            ElementKind::Row => feature.points,
            ElementKind::Circle => feature.circles,
            _ => 0,
        };
        let at = self.features.partition_point(|feature| count(feature) as u64 <= index);
        let Some(Feature { number, name, .. }) = self.features.get(at) else { return error };
        let name = name.as_ref().map_or(String::new(), |name| format!(" '{name}'"));
        let message = format!("feature {number}{name}: {}", error.message());
        Error::new(error.status(), message).at(kind, index)
    }

    fn mark(&self) -> Mark {
        Mark {
            lengths: [
                self.ring_vertices.len(),
                self.ring_offsets.len(),
                self.polygon_offsets.len(),
                self.polyline_vertices.len(),
                self.polyline_offsets.len(),
                self.points.len(),
            ],
        }
    }

    /// Ends a feature that began at the mark: keeps or drops what it added, and makes circles of its points.
    fn end_feature(&mut self, mark: Mark, traits: &Traits) -> crate::Result<()> {
        let is_chosen = match self.choice {
            FeatureChoice::All => true,
            FeatureChoice::Named(name) => traits.names.contains(name),
            FeatureChoice::Numbered(number) => *number == self.seen,
        };
        self.seen += 1;
        self.chosen += usize::from(is_chosen);
        let name = || traits.names.first().map(|name| name.escape_debug().take(40).collect());
        if self.names.len() < LISTED {
            self.names.extend(name());
        }
        let [rings, ring_offsets, polygons, polylines, polyline_offsets, points] = mark.lengths;
        if !is_chosen {
            self.ring_vertices.truncate(rings);
            self.ring_offsets.truncate(ring_offsets);
            self.polygon_offsets.truncate(polygons);
            self.polyline_vertices.truncate(polylines);
            self.polyline_offsets.truncate(polyline_offsets);
            self.points.truncate(points);
        } else if let Some(radius) = traits.radius.filter(|&radius| radius > 0.0) {
            for &[x, y] in &self.points[points..] {
                self.room.push(&mut self.circles, [x, y, radius])?;
            }
            self.points.truncate(points);
        }
        if is_chosen {
            let feature = Feature {
                number: self.seen - 1,
                name: name(),
                rings: self.ring_offsets.len() - 1,
                polylines: self.polyline_offsets.len() - 1,
                points: self.points.len(),
                circles: self.circles.len(),
            };
            self.room.push(&mut self.features, feature)?;
        }
        Ok(())
    }

    /// Adds a geometry of this type.
    fn add(&mut self, kind: &str, shape: &Shape<'_>) -> crate::Result<()> {
        let positions = &shape.positions;
        let [first, second, third] = &shape.ends;
        match kind {
            "Point" | "MultiPoint" => extend(&mut self.points, positions, &mut self.room),
            "LineString" if positions.is_empty() => Ok(()),
            "LineString" => self.lines(positions, first),
            "MultiLineString" => self.lines(positions, second),
            "Polygon" => self.polygons(positions, second, first),
            _ => self.polygons(positions, third, second),
        }
    }

    fn lines(&mut self, positions: &[[f64; 2]], ends: &[u32]) -> crate::Result<()> {
        append(&mut self.polyline_offsets, ends, self.polyline_vertices.len(), &mut self.room)?;
        extend(&mut self.polyline_vertices, positions, &mut self.room)
    }

    fn polygons(
        &mut self,
        positions: &[[f64; 2]],
        rings: &[u32],
        polygons: &[u32],
    ) -> crate::Result<()> {
        let before = self.ring_offsets.len() - 1;
        append(&mut self.ring_offsets, rings, self.ring_vertices.len(), &mut self.room)?;
        extend(&mut self.ring_vertices, positions, &mut self.room)?;
        // A polygon without a ring is nothing.
        let mut last = 0;
        for &end in polygons {
            if end > last {
                append(&mut self.polygon_offsets, &[end], before, &mut self.room)?;
            }
            last = end;
        }
        Ok(())
    }
}

fn extend(to: &mut Vec<[f64; 2]>, more: &[[f64; 2]], room: &mut Room<'_>) -> crate::Result<()> {
    room.grow(to, more.len())?;
    to.extend_from_slice(more);
    Ok(())
}

/// Appends ends that are counted from where earlier ones stopped.
fn append(
    to: &mut Vec<u32>,
    ends: &[u32],
    before: usize,
    room: &mut Room<'_>,
) -> crate::Result<()> {
    room.grow(to, ends.len())?;
    for &end in ends {
        let end = u32::try_from(before + end as usize)
            .map_err(|_| Error::new(Status::LimitExceeded, "more than 2^32 - 1 vertices"))?;
        to.push(end);
    }
    Ok(())
}

/// What a feature is chosen by, and what makes a point a circle.
#[derive(Default)]
struct Traits {
    names: Vec<String>,
    radius: Option<f64>,
}

/// Which objects may stand in a place.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Expected {
    /// Any object of GeoJSON.
    Any,
    Feature,
    /// A geometry, or null for none.
    Geometry,
}

/// An object, which adds what it holds.
pub(super) struct Object<'c, 'a> {
    pub collector: &'c mut Collector<'a>,
    pub expected: Expected,
}

impl<'de> DeserializeSeed<'de> for Object<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Object<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.expected {
            Expected::Any => "an object of GeoJSON",
            Expected::Feature => "a feature",
            Expected::Geometry => "a geometry",
        })
    }

    fn visit_unit<E: de::Error>(self) -> Result<(), E> {
        match self.expected {
            Expected::Geometry => Ok(()),
            _ => Err(E::invalid_type(de::Unexpected::Unit, &self)),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let Object { collector, expected } = self;
        let source = collector.source;
        let mark = collector.mark();
        let (mut kind, mut shape) = (None, None);
        let mut traits = Traits::default();
        // Features and geometries add themselves before the type may be known.
        let (mut features, mut geometry, mut geometries) = (false, false, false);
        let once = |seen: &mut bool, name| match std::mem::replace(seen, true) {
            true => Err(de::Error::duplicate_field(name)),
            false => Ok(()),
        };
        while let Some(key) = map.next_key::<String>()? {
            match (&key[..], expected) {
                ("type", _) => {
                    if kind.replace(map.next_value::<String>()?).is_some() {
                        return Err(de::Error::duplicate_field("type"));
                    }
                }
                ("features", Expected::Any) => {
                    once(&mut features, "features")?;
                    map.next_value_seed(Objects {
                        collector: &mut *collector,
                        expected: Expected::Feature,
                    })?;
                }
                ("geometry", Expected::Any | Expected::Feature) => {
                    once(&mut geometry, "geometry")?;
                    map.next_value_seed(Object {
                        collector: &mut *collector,
                        expected: Expected::Geometry,
                    })?;
                }
                ("geometries", Expected::Any | Expected::Geometry) => {
                    once(&mut geometries, "geometries")?;
                    map.next_value_seed(Objects {
                        collector: &mut *collector,
                        expected: Expected::Geometry,
                    })?;
                }
                ("coordinates", Expected::Any | Expected::Geometry) => {
                    let mut found = Shape::new(source);
                    map.next_value_seed(Coordinates { shape: &mut found, level: 0 })?;
                    if shape.replace(found).is_some() {
                        return Err(de::Error::duplicate_field("coordinates"));
                    }
                }
                ("properties", Expected::Any | Expected::Feature) => {
                    map.next_value_seed(Properties(&mut traits))?;
                }
                ("id", Expected::Any | Expected::Feature) => {
                    traits.names.extend(map.next_value_seed(Property)?.text);
                }
                _ => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        let Some(kind) = kind else { return Err(de::Error::missing_field("type")) };
        let lacks = |member| de::Error::custom(format!("a {kind} needs {member}"));
        let is_geometry = match (&kind[..], expected) {
            ("FeatureCollection", Expected::Any) if features => return Ok(()),
            ("FeatureCollection", Expected::Any) => return Err(lacks("features")),
            ("Feature", Expected::Any | Expected::Feature) if geometry => false,
            ("Feature", Expected::Any | Expected::Feature) => return Err(lacks("a geometry")),
            ("GeometryCollection", Expected::Any | Expected::Geometry) if geometries => true,
            ("GeometryCollection", Expected::Any | Expected::Geometry) => {
                return Err(lacks("geometries"));
            }
            (_, Expected::Any | Expected::Geometry) => {
                let known = GEOMETRIES.iter().find(|(name, _)| *name == kind);
                let Some(&(_, level)) = known else {
                    let kind: String = kind.escape_debug().take(40).collect();
                    let message = format!("'{kind}' is no type of GeoJSON that may stand here");
                    return Err(de::Error::custom(message));
                };
                let shape = shape.ok_or_else(|| lacks("coordinates"))?;
                if let Some(problem) = shape.problem(&kind, level) {
                    return Err(de::Error::custom(problem));
                }
                collector.add(&kind, &shape).map_err(|error| source.stop(error))?;
                true
            }
            (_, Expected::Feature) => {
                return Err(de::Error::custom("features must be of the type Feature"));
            }
        };
        match is_geometry && expected == Expected::Geometry {
            true => Ok(()),
            false => collector.end_feature(mark, &traits).map_err(|error| source.stop(error)),
        }
    }
}

/// An array of objects.
struct Objects<'c, 'a> {
    collector: &'c mut Collector<'a>,
    expected: Expected,
}

impl<'de> DeserializeSeed<'de> for Objects<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Objects<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array of objects")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        let Objects { collector, expected } = self;
        while seq.next_element_seed(Object { collector: &mut *collector, expected })?.is_some() {}
        Ok(())
    }
}

/// The properties of a feature, or null for none.
struct Properties<'t>(&'t mut Traits);

impl<'de> DeserializeSeed<'de> for Properties<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Properties<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object of properties")
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            if key == "radius" {
                self.0.radius = map.next_value_seed(Property)?.number;
            } else if NAMES.contains(&&key[..]) {
                self.0.names.extend(map.next_value_seed(Property)?.text);
            } else {
                map.next_value::<IgnoredAny>()?;
            }
        }
        Ok(())
    }
}

/// A property's value; nothing is kept of one that is neither a text nor a number.
struct Property;

#[derive(Default)]
struct Value {
    text: Option<String>,
    number: Option<f64>,
}

impl Value {
    fn number(number: f64, text: String) -> Self {
        Value { text: Some(text), number: Some(number) }
    }
}

impl<'de> DeserializeSeed<'de> for Property {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Property {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(Value { text: Some(text.to_string()), number: None })
    }

    fn visit_u64<E>(self, number: u64) -> Result<Value, E> {
        Ok(Value::number(number as f64, number.to_string()))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Value, E> {
        Ok(Value::number(number as f64, number.to_string()))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Value, E> {
        Ok(Value::number(number, number.to_string()))
    }

    fn visit_bool<E>(self, _: bool) -> Result<Value, E> {
        Ok(Value::default())
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::default())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Value, A::Error> {
        while seq.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Value::default())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(Value::default())
    }
}
