//! From plain arrays to a figure: checked, normalised, counted.

use super::crossings::{Curves, circle_box};
use super::nesting::direction;
use super::report::Report;
use super::{ChainKind, Crossings, Figure, FigureOptions, FigureParts, Normalised, Point};
use crate::complex::Rows;
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Room, Run};
use crate::points::{Bounds, check_coordinates};
use crate::predicates::{Sign, orient2d};

pub(super) fn build(
    parts: FigureParts<'_>,
    options: FigureOptions,
    run: &Run<'_>,
) -> Result<Figure> {
    let mut draft = Draft::new(&parts, run)?;
    draft.rings(&parts)?;
    draft.polylines(&parts)?;
    draft.points(parts.points)?;
    draft.circles(parts.circles)?;
    run.tick(10, 100)?;
    let sources = std::mem::take(&mut draft.sources);
    let mut figure = draft.finish(options)?;
    let mut room = Room::new(run);
    let curves = Curves::new(&figure, &mut room, run)?;
    let found = curves.find(&mut room, run)?;
    let report = Report { curves: &curves, sources: &sources };
    if let (Crossings::Refuse, Some(pair)) = (options.crossings, found.first) {
        return Err(report.crossing(pair));
    }
    let misplaced = match found.crossings {
        0 => report.misplaced(&found, options.crossings, &mut room, run)?,
        _ => 0,
    };
    figure.normalised.crossings = found.crossings;
    figure.normalised.misplaced = misplaced;
    for ring in run.watch(0..figure.ring_count()) {
        let ring = ring?;
        let range = figure.range(ring);
        let vertices = &mut figure.vertices[range.start as usize..range.end as usize];
        if direction(vertices) == -right_turn(figure.kinds[ring]) {
            // The first vertex stays the first.
            vertices[1..].reverse();
            figure.normalised.turned_rings += 1;
        }
    }
    Ok(figure)
}

/// Where a ring turns at its least vertex.
pub(super) fn right_turn(kind: ChainKind) -> Sign {
    match kind {
        ChainKind::Hole => Sign::Negative,
        _ => Sign::Positive,
    }
}

/// A figure in the making.
struct Draft<'a> {
    run: &'a Run<'a>,
    room: Room<'a>,
    vertices: Vec<Point>,
    offsets: Vec<u32>,
    kinds: Vec<ChainKind>,
    parts: Vec<u32>,
    circles: Vec<[f64; 3]>,
    normalised: Normalised,
    /// The place of each vertex in its chain as it was given.
    sources: Vec<u32>,
    /// The number of parts so far.
    part: u32,
}

impl<'a> Draft<'a> {
    fn new(parts: &FigureParts<'_>, run: &'a Run<'a>) -> Result<Self> {
        let rows = [
            (parts.ring_vertices.len(), parts.ring_offsets, "ring_offsets"),
            (parts.ring_offsets.len().saturating_sub(1), parts.polygon_offsets, "polygon_offsets"),
            (parts.polyline_vertices.len(), parts.polyline_offsets, "polyline_offsets"),
        ];
        for (count, offsets, name) in rows {
            check_offsets(count, offsets, name, run)?;
        }
        let count = [
            parts.ring_vertices.len(),
            parts.polyline_vertices.len(),
            parts.points.len(),
            parts.circles.len(),
        ];
        if count.iter().sum::<usize>() >= u32::MAX as usize {
            return Err(Error::new(
                Status::LimitExceeded,
                "more than 2^32 - 2 vertices and circles",
            ));
        }
        let rows = |offsets: &[u32]| offsets.len().saturating_sub(1);
        let chains = rows(parts.ring_offsets) + rows(parts.polyline_offsets);
        if count.iter().all(|&n| n == 0) && chains == 0 {
            return Err(Error::new(Status::TooFewPoints, "the figure holds nothing"));
        }
        let mut room = Room::new(run);
        let mut offsets = Vec::new();
        room.push(&mut offsets, 0)?;
        Ok(Draft {
            run,
            room,
            offsets,
            vertices: Vec::new(),
            kinds: Vec::new(),
            parts: Vec::new(),
            circles: Vec::new(),
            normalised: Normalised::default(),
            sources: Vec::new(),
            part: 0,
        })
    }

    fn rings(&mut self, parts: &FigureParts<'_>) -> Result<()> {
        for (polygon, rings) in parts.polygon_offsets.windows(2).enumerate() {
            if rings[0] == rings[1] {
                let error = Error::new(Status::InvalidArgument, "a polygon has no ring");
                return Err(error.at(ElementKind::Row, polygon as u64));
            }
            for ring in rings[0]..rings[1] {
                let kind = match ring == rings[0] {
                    true => ChainKind::Outer,
                    false => ChainKind::Hole,
                };
                let given = row(parts.ring_vertices, parts.ring_offsets, ring as usize);
                let at = (ElementKind::Ring, u64::from(ring));
                let begin = self.chain(given, kind, at)?;
                let vertices = &self.vertices[begin..];
                if vertices.len() > 1 && vertices.first() == vertices.last() {
                    self.vertices.pop();
                    self.sources.pop();
                    self.normalised.closing_vertices += 1;
                }
                check_ring(&self.vertices[begin..]).map_err(|error| error.at(at.0, at.1))?;
                self.close()?;
            }
            self.part += 1;
        }
        Ok(())
    }

    fn polylines(&mut self, parts: &FigureParts<'_>) -> Result<()> {
        for i in 0..parts.polyline_offsets.len().saturating_sub(1) {
            let given = row(parts.polyline_vertices, parts.polyline_offsets, i);
            let at = (ElementKind::Polyline, i as u64);
            let begin = self.chain(given, ChainKind::Polyline, at)?;
            if self.vertices.len() < begin + 2 {
                let message = format!(
                    "a polyline needs two distinct vertices or more{}; give a point",
                    first_of(&self.vertices[begin..])
                );
                return Err(Error::new(Status::TooFewPoints, message).at(at.0, at.1));
            }
            self.close()?;
            self.part += 1;
        }
        Ok(())
    }

    fn points(&mut self, points: &[Point]) -> Result<()> {
        for (i, point) in points.iter().enumerate() {
            self.chain(
                std::slice::from_ref(point),
                ChainKind::Point,
                (ElementKind::Row, i as u64),
            )?;
            self.close()?;
            self.part += 1;
        }
        Ok(())
    }

    fn circles(&mut self, circles: &[[f64; 3]]) -> Result<()> {
        for circle in self.run.watch(circles.iter().enumerate()) {
            let (i, &circle) = circle?;
            let checked = check_coordinates(circle).and_then(|circle| match circle[2] > 0.0 {
                true => Ok(circle),
                false => {
                    Err(Error::new(Status::InvalidArgument, "a radius must be greater than 0"))
                }
            });
            let circle = checked.map_err(|error| {
                let [x, y, radius] = circle;
                let message = format!("{}: centre ({x}, {y}), radius {radius}", error.message());
                Error::new(error.status(), message).at(ElementKind::Circle, i as u64)
            })?;
            self.room.push(&mut self.circles, circle)?;
        }
        Ok(())
    }

    /// Appends the vertices of a chain, which is not closed yet; returns where they begin.
    fn chain(&mut self, given: &[Point], kind: ChainKind, at: (ElementKind, u64)) -> Result<usize> {
        let begin = self.vertices.len();
        for vertex in self.run.watch(given.iter().enumerate()) {
            let (i, &[x, y]) = vertex?;
            let [x, y, _] = check_coordinates([x, y, 0.0]).map_err(|error| {
                let message = format!("{}: vertex {i}, ({x}, {y})", error.message());
                Error::new(error.status(), message).at(at.0, at.1)
            })?;
            if self.vertices[begin..].last() == Some(&[x, y]) {
                self.normalised.repeated_vertices += 1;
                // The edge goes on from the last of them.
                self.sources.pop();
                self.sources.push(i as u32);
                continue;
            }
            self.room.push(&mut self.vertices, [x, y])?;
            self.room.push(&mut self.sources, i as u32)?;
        }
        self.room.push(&mut self.kinds, kind)?;
        self.room.push(&mut self.parts, self.part)?;
        Ok(begin)
    }

    fn close(&mut self) -> Result<()> {
        self.room.push(&mut self.offsets, self.vertices.len() as u32)
    }

    fn finish(self, options: FigureOptions) -> Result<Figure> {
        let Draft { run, mut room, vertices, offsets, kinds, parts, circles, normalised, .. } =
            self;
        let numbers = room.collect((0..vertices.len()).map(|v| v as u32))?;
        let mut bounds: Option<Bounds> = None;
        for corner in run.watch(corners(&vertices, &circles)) {
            bounds = Some(Bounds::with(bounds, corner?));
        }
        Ok(Figure {
            vertices,
            chains: Rows::new(offsets, numbers)?,
            kinds,
            parts,
            circles,
            bounds: bounds.unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] }),
            normalised,
            options,
        })
    }
}

/// What the bounds of a figure are made of.
pub(super) fn corners<'a>(
    vertices: &'a [Point],
    circles: &'a [[f64; 3]],
) -> impl Iterator<Item = [f64; 3]> + 'a {
    let vertices = vertices.iter().map(|&[x, y]| [x, y, 0.0]);
    vertices.chain(circles.iter().flat_map(circle_box))
}

/// Row `i` of what offsets divide.
fn row<'a>(values: &'a [Point], offsets: &[u32], i: usize) -> &'a [Point] {
    &values[offsets[i] as usize..offsets[i + 1] as usize]
}

fn check_offsets(count: usize, offsets: &[u32], name: &str, run: &Run<'_>) -> Result<()> {
    let mut last = 0;
    for offset in run.watch(offsets.iter().enumerate()) {
        let (i, &offset) = offset?;
        if offset < last || i == 0 && offset != 0 {
            let message = format!("'{name}' must begin with 0 and never fall");
            return Err(Error::new(Status::InvalidArgument, message).at(ElementKind::Row, i as u64));
        }
        last = offset;
    }
    if last as usize != count {
        let message = format!("'{name}' ends with {last}, and must end with {count}");
        return Err(Error::new(Status::Mismatch, message));
    }
    Ok(())
}

/// What is wrong with a ring, of which no vertex repeats the one before.
fn check_ring(ring: &[Point]) -> Result<()> {
    let third = match ring {
        [a, b, rest @ ..] => rest.iter().any(|p| p != a && p != b),
        _ => false,
    };
    if !third {
        let message = format!("a ring needs three distinct vertices or more{}", first_of(ring));
        return Err(Error::new(Status::TooFewPoints, message));
    }
    if ring[2..].iter().all(|p| orient2d(&ring[0], &ring[1], p).is_zero()) {
        let message = format!("a ring has no area: all vertices are on a line{}", first_of(ring));
        return Err(Error::new(Status::Degenerate, message));
    }
    Ok(())
}

/// Where a chain begins, for messages.
fn first_of(chain: &[Point]) -> String {
    chain.first().map_or_else(String::new, |[x, y]| format!("; this one begins at ({x}, {y})"))
}
