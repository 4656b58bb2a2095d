//! `.ma`, the medial meshes of Q-MAT (Li and others 2015) and MATFP (Wang and others 2022).
//!
//! The counts of vertices, edges and faces, then `v x y z radius`, `e i j` and `f i j k`, from 0.
//! Columns that programs add behind these are passed over. The edges list the sides of the faces,
//! too.

use super::sink::Sink;
use super::soup::{Builder, Soup};
use super::text::{Lines, at_line, shown};
use crate::complex::{Attribute, Complex, Element, Values};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::Run;

/// The statements: letter, name, least bytes of a line.
const KINDS: [(&[u8], &str, u64); 3] = [
    (b"v", "vertices", "v 0 0 0 0\n".len() as u64),
    (b"e", "edges", "e 0 0\n".len() as u64),
    (b"f", "faces", "f 0 0 0\n".len() as u64),
];

pub(super) fn parse(bytes: &[u8], run: &Run<'_>) -> Result<Soup> {
    let mut lines = Lines::new(bytes, run);
    let first = lines.expect("the counts")?;
    let mut words = first.words();
    let mut left = [0u64; 3];
    for (left, (_, name, row)) in left.iter_mut().zip(KINDS) {
        *left = words.whole(&format!("the number of {name}"))?;
        lines.check_room(*left, row, name)?;
    }
    words.finish("the counts")?;
    let vertex_count = left[0] as usize;
    let mut builder = Builder::new(run);
    let mut radii = Vec::new();
    builder.room.reserve(&mut builder.vertices, vertex_count)?;
    builder.room.reserve(&mut radii, vertex_count)?;
    while let Some(line) = lines.next_filled()? {
        let mut words = line.words();
        let letter = words.next().unwrap_or_default();
        let Some(kind) = KINDS.iter().position(|(known, ..)| *known == letter) else {
            let message = format!("a line begins with v, e or f, not {}", shown(letter));
            return Err(at_line(line.number, message));
        };
        left[kind] = left[kind].checked_sub(1).ok_or_else(|| {
            at_line(line.number, format!("there are more {} than promised", KINDS[kind].1))
        })?;
        let mut vertex = || words.index("a corner", vertex_count);
        match kind {
            0 => {
                builder.vertex(words.xyz()?)?;
                radii.push(words.f64("the radius")?);
            }
            1 => {
                let edge = [vertex()?, vertex()?];
                builder.edge(edge)?;
            }
            _ => {
                let face = [vertex()?, vertex()?, vertex()?];
                builder.face(face)?;
            }
        }
    }
    if let Some(kind) = left.iter().position(|&left| left > 0) {
        return Err(
            lines.ended(&format!("the last {} of the {} promised", left[kind], KINDS[kind].1))
        );
    }
    let values = Values::F64(radii);
    builder.attributes.push(Attribute::new("radius", Element::Vertex, 1, values)?);
    builder.finish((ElementKind::Line, first.number))
}

pub(super) fn write(complex: &Complex, out: &mut Sink<'_>) -> Result<()> {
    let radii = match complex.attribute(Element::Vertex, "radius").map(|a| (a.width(), a.values()))
    {
        Some((1, Values::F64(radii))) => radii,
        _ => {
            return Err(Error::new(
                Status::Unsupported,
                "MA holds balls, and the complex has no vertex attribute 'radius'; write PLY",
            ));
        }
    };
    let sorted = |a: u32, b: u32| [a.min(b), a.max(b)];
    let triangles = complex.triangles().iter();
    let mut sides: Vec<[u32; 2]> =
        triangles.flat_map(|&[a, b, c]| [sorted(a, b), sorted(b, c), sorted(c, a)]).collect();
    sides.sort_unstable();
    sides.dedup();
    let edges = || complex.edges().iter().chain(&sides);
    let counts = [complex.vertices().len(), edges().count(), complex.triangles().len()];
    out.text(format_args!("{} {} {}\n", counts[0], counts[1], counts[2]))?;
    for ([x, y, z], radius) in complex.vertices().iter().zip(radii) {
        out.text(format_args!("v {x:?} {y:?} {z:?} {radius:?}\n"))?;
        out.row()?;
    }
    for [a, b] in edges() {
        out.text(format_args!("e {a} {b}\n"))?;
        out.row()?;
    }
    for [a, b, c] in complex.triangles() {
        out.text(format_args!("f {a} {b} {c}\n"))?;
        out.row()?;
    }
    Ok(())
}
