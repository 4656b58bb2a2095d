//! Holes that stay open (Amenta, Choi, Kolluri 2001, section 7.1).

use super::PowerCrust;
use super::links::same_side_weight;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};

/// Which faces of a power crust fill holes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoleOptions {
    /// The two balls of a face intersect deeply where -cos of the angle between their spheres exceeds this; in [0, 1], 0.1 by
    /// default: less than for labels, as balls that intersect more deeply have the same label nearly always.
    pub depth: f64,
    /// And both radii exceed this, in input units; 0 by default, so that every deep intersection is a hole.
    pub radius: f64,
}

impl Default for HoleOptions {
    fn default() -> Self {
        HoleOptions { depth: 0.1, radius: 0.0 }
    }
}

/// A power crust without the faces that fill holes.
#[derive(Clone, Debug)]
pub struct OpenSurface {
    /// The faces that are left, with the attributes that they had, and the vertices that these use.
    pub surface: Complex,
    /// The faces that were left out, in the same way; `face` is each one's number in the whole surface.
    pub left_out: Complex,
}

impl PowerCrust {
    /// The surface without the faces between an inner and an outer ball that intersect deeply and are large: where the sample has
    /// a hole, large balls protrude through it. The boundary loops are counted by [`Complex::topology`] of what is left.
    ///
    /// Errors: [`Status::InvalidArgument`] for options out of range, and those of the job. Cost: O(size of the surface).
    pub fn open(&self, options: HoleOptions, job: &Job) -> Result<OpenSurface> {
        let HoleOptions { depth, radius } = options;
        if !((0.0..=1.0).contains(&depth) && radius.is_finite() && radius >= 0.0) {
            let message = "depth must lie in [0, 1], and radius must be finite and not negative";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let mut room = Room::new(run);
            let face_poles = |name: &str| match self.surface.attribute(Element::Face, name) {
                Some(attribute) => match attribute.values() {
                    Values::U32(poles) => &poles[..],
                    Values::F64(_) => &[],
                },
                None => &[],
            };
            let pairs = face_poles("inner_pole").iter().zip(face_poles("outer_pole"));
            let ball = |pole: u32| {
                let [x, y, z, _] = self.poles.balls()[pole as usize];
                [x, y, z, self.weight(pole as usize).map_or(0.0, f64::sqrt)]
            };
            let is_hole = pairs.map(|(&inner, &outer)| {
                let (inner, outer) = (ball(inner), ball(outer));
                inner[3].min(outer[3]) > radius && same_side_weight(&inner, &outer) > depth
            });
            let is_hole = room.collect(is_hole)?;
            Ok(OpenSurface {
                surface: self.part(|face| !is_hole[face], false, run)?,
                left_out: self.part(|face| is_hole[face], true, run)?,
            })
        })
    }

    /// Some faces of the surface, with their numbers if asked for.
    fn part(
        &self,
        is_in: impl Fn(usize) -> bool,
        with_numbers: bool,
        run: &Run<'_>,
    ) -> Result<Complex> {
        let surface = &*self.surface;
        let mut room = Room::new(run);
        let mut faces = Vec::new();
        let mut number = room.filled(surface.vertices().len(), NONE)?;
        for face in run.watch((0..surface.faces().len()).filter(|&face| is_in(face))) {
            let face = face?;
            room.push(&mut faces, face as u32)?;
            surface.faces().row(face).iter().for_each(|&v| number[v as usize] = 0);
        }
        let mut vertices = Vec::new();
        for (vertex, number) in number.iter_mut().enumerate().filter(|(_, used)| **used != NONE) {
            *number = vertices.len() as u32;
            room.push(&mut vertices, vertex as u32)?;
        }
        let mut rows = Rows::default();
        let mut ring = Vec::new();
        for face in run.watch(faces.iter()) {
            ring.clear();
            ring.extend(surface.faces().row(*face? as usize).iter().map(|&v| number[v as usize]));
            rows.push(&ring)?;
        }
        let mut attributes = Vec::new();
        for attribute in surface.attributes() {
            let kept = match attribute.element() {
                Element::Vertex => &vertices,
                _ => &faces,
            };
            if let Values::U32(values) = attribute.values() {
                let values = room.collect(kept.iter().map(|&i| values[i as usize]))?;
                let (name, element) = (attribute.name(), attribute.element());
                attributes.push(Attribute::new(name, element, 1, Values::U32(values))?);
            }
        }
        let positions = room.collect(vertices.iter().map(|&v| surface.vertices()[v as usize]))?;
        if with_numbers {
            attributes.push(Attribute::new("face", Element::Face, 1, Values::U32(faces))?);
        }
        let parts =
            ComplexParts { vertices: positions, faces: rows, attributes, ..Default::default() };
        Complex::sound_in(parts, run)
    }
}
