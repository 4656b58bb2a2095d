//! Coordinates: arrays of arrays of numbers, read before their geometry's type may be known.

use super::source::Source;
use crate::job::Room;
use serde_core::de::{DeserializeSeed, Deserializer, Error, SeqAccess, Visitor};
use std::fmt;

/// The levels of arrays that hold arrays, at most: polygons, rings, positions.
const LEVELS: usize = 3;

/// The types of geometries with coordinates, and at which level their positions are.
pub(super) const GEOMETRIES: [(&str, usize); 6] = [
    ("Point", 0),
    ("MultiPoint", 1),
    ("LineString", 1),
    ("MultiLineString", 2),
    ("Polygon", 2),
    ("MultiPolygon", 3),
];

/// The `coordinates` of a geometry.
pub(super) struct Shape<'a> {
    source: &'a Source<'a>,
    room: Room<'a>,
    pub positions: Vec<[f64; 2]>,
    /// For each array of a level, outermost first, how many arrays or positions of the next level there are up to its end.
    pub ends: [Vec<u32>; LEVELS],
    /// The level of the positions, all of which have one.
    level: Option<usize>,
}

impl<'a> Shape<'a> {
    pub fn new(source: &'a Source<'a>) -> Self {
        let room = Room::new(source.run);
        Shape { source, room, positions: Vec::new(), ends: Default::default(), level: None }
    }

    /// What is wrong with the shape as the coordinates of a type, whose positions are at this level.
    pub fn problem(&self, kind: &str, level: usize) -> Option<String> {
        let is_deep = self.ends.iter().skip(level).any(|ends| !ends.is_empty());
        match self.level {
            Some(found) if found != level => {
                let (level, found) = (level + 1, found + 1);
                Some(format!(
                    "the coordinates of a {kind} are {level} arrays deep, and these {found}"
                ))
            }
            _ if is_deep => Some("a position needs two numbers or more".to_string()),
            _ => None,
        }
    }

    fn position(&mut self, position: [f64; 2]) -> crate::Result<()> {
        self.room.push(&mut self.positions, position)
    }

    fn end(&mut self, level: usize) -> crate::Result<()> {
        let count = match self.ends.get(level + 1) {
            Some(ends) if self.level != Some(level + 1) => ends.len(),
            _ => self.positions.len(),
        };
        self.room.push(&mut self.ends[level], count as u32)
    }
}

/// An array of numbers or arrays, so many arrays deep.
pub(super) struct Coordinates<'s, 'a> {
    pub shape: &'s mut Shape<'a>,
    pub level: usize,
}

impl<'de> DeserializeSeed<'de> for Coordinates<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Coordinates<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array of coordinates")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        let Coordinates { shape, level } = self;
        let (mut xy, mut numbers, mut arrays) = ([0.0; 2], 0, 0);
        while let Some(item) = seq.next_element_seed(Item { shape: &mut *shape, level })? {
            match item {
                Some(number) => {
                    if let Some(x) = xy.get_mut(numbers) {
                        *x = number;
                    }
                    numbers += 1;
                }
                None => arrays += 1,
            }
            if numbers > 0 && arrays > 0 {
                return Err(A::Error::custom("numbers and arrays are mixed"));
            }
        }
        let source = shape.source;
        match numbers {
            0 if level < LEVELS => shape.end(level).map_err(|error| source.stop(error)),
            0 => Err(A::Error::custom("coordinates are nested too deep")),
            1 => Err(A::Error::custom("a position needs two numbers or more")),
            _ if *shape.level.get_or_insert(level) != level => {
                Err(A::Error::custom("positions are nested differently"))
            }
            _ => shape.position(xy).map_err(|error| source.stop(error)),
        }
    }
}

/// What an array holds: a number, or an array, which leaves nothing to return.
struct Item<'s, 'a> {
    shape: &'s mut Shape<'a>,
    level: usize,
}

impl<'de> DeserializeSeed<'de> for Item<'_, '_> {
    type Value = Option<f64>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Option<f64>, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Item<'_, '_> {
    type Value = Option<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an array")
    }

    fn visit_u64<E>(self, value: u64) -> Result<Option<f64>, E> {
        Ok(Some(value as f64))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Option<f64>, E> {
        Ok(Some(value as f64))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Option<f64>, E> {
        self.shape.source.number(value).map(Some)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Option<f64>, A::Error> {
        if self.level == LEVELS {
            return Err(A::Error::custom("coordinates are nested too deep"));
        }
        Coordinates { shape: self.shape, level: self.level + 1 }.visit_seq(seq).map(|()| None)
    }
}
