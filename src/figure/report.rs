//! Curves that may not be where they are: what is said of them.

use super::crossings::{Curves, Found};
use super::nesting::containers;
use super::{ChainKind, Crossings, Figure, Point};
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run};

/// What to do about a curve.
const ADVICE: &str = "correct it, or accept crossings";

/// Errors about curves, with the numbers that their vertices were given with.
pub(super) struct Report<'a> {
    pub curves: &'a Curves<'a>,
    /// The place of each vertex in its chain as it was given.
    pub sources: &'a [u32],
}

impl Report<'_> {
    /// Two curves cross or touch.
    pub fn crossing(&self, [s, t]: [u32; 2]) -> Error {
        let place = match self.place(s, t) {
            Some([x, y]) => format!(", at ({x}, {y}) or near it"),
            None => String::new(),
        };
        let (kind, index) = self.element(s);
        let [s, t] = [s, t].map(|curve| self.name(curve));
        let message = format!("{s} crosses or touches {t}{place}; {ADVICE}");
        Error::new(Status::InvalidArgument, message).at(kind, index)
    }

    /// The number of rings and circles in a place where none may be, of curves without crossings; an error for the first if they are
    /// refused.
    pub fn misplaced(
        &self,
        found: &Found,
        crossings: Crossings,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<u64> {
        let figure = self.curves.figure;
        let rings = figure.ring_count();
        let containers = containers(self.curves, room, run)?;
        // The disc that a ring or circle is in.
        let mut discs = room.filled(containers.len(), NONE)?;
        for pair in run.watch(&found.inside) {
            let &[inner, disc] = pair?;
            let place = match self.curves.circle_of(inner) {
                Some(circle) => rings + circle,
                None => figure.chain_of(inner),
            };
            discs[place] = discs[place].min(disc);
        }
        let mut count = 0;
        for place in run.watch(0..containers.len()) {
            let place = place?;
            let problem = match (discs[place], containers[place]) {
                (NONE, container) => ring_problem(figure, place, container),
                (disc, _) => Some(format!("lies in {}", self.name(disc))),
            };
            if let Some(problem) = problem {
                if crossings == Crossings::Refuse {
                    return Err(self.displaced(place, &problem));
                }
                count += 1;
            }
        }
        Ok(count)
    }

    fn displaced(&self, place: usize, problem: &str) -> Error {
        let figure = self.curves.figure;
        let (kind, index, what, [x, y]) = match place.checked_sub(figure.ring_count()) {
            Some(circle) => {
                let [x, y, _] = figure.circles[circle];
                (ElementKind::Circle, circle, "the circle with its centre", [x, y])
            }
            None => {
                let first = figure.vertices[figure.range(place).start as usize];
                let what = match figure.kinds[place] {
                    ChainKind::Hole => "the hole with its first vertex",
                    _ => "the polygon with its first vertex",
                };
                (ElementKind::Ring, place, what, first)
            }
        };
        let message = format!("{what} at ({x}, {y}) {problem}; {ADVICE}");
        Error::new(Status::InvalidArgument, message).at(kind, index as u64)
    }

    /// What a curve belongs to.
    fn element(&self, curve: u32) -> (ElementKind, u64) {
        let figure = self.curves.figure;
        if let Some(circle) = self.curves.circle_of(curve) {
            return (ElementKind::Circle, circle as u64);
        }
        let (chain, rings) = (figure.chain_of(curve), figure.ring_count());
        match figure.kinds[chain].is_ring() {
            true => (ElementKind::Ring, chain as u64),
            false => (ElementKind::Polyline, (chain - rings) as u64),
        }
    }

    /// What a curve is, and where.
    fn name(&self, curve: u32) -> String {
        let (kind, index) = self.element(curve);
        let whose = format!("{} {index}", kind.name());
        let Some([a, b]) = self.curves.ends(curve) else {
            let circle =
                self.curves.circle_of(curve).and_then(|i| self.curves.figure.circles.get(i));
            let Some([x, y, radius]) = circle else { return whose };
            return format!("{whose} of radius {radius} round ({x}, {y})");
        };
        let edge = self.sources[a as usize];
        let [[ax, ay], [bx, by]] = [a, b].map(|v| *self.curves.position(v));
        format!("edge {edge} of {whose} from ({ax}, {ay}) to ({bx}, {by})")
    }

    /// Where two edges meet: at a vertex, or nearly there where they cross; `None` for circles.
    fn place(&self, s: u32, t: u32) -> Option<Point> {
        let [s, t] = [self.curves.ends(s)?, self.curves.ends(t)?];
        let [[p, q], [r, u]] = [s, t].map(|ends| ends.map(|v| *self.curves.position(v)));
        let minor = |a: Point, b: Point, c: Point| {
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        let (from, to) = (minor(r, u, p), minor(r, u, q));
        if from == to {
            // On a line: the middle two of the four ends bound what they have in common.
            let mut ends = [p, q, r, u];
            ends.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
            return Some(ends[1]);
        }
        let weight = (from / (from - to)).clamp(0.0, 1.0);
        Some([0, 1].map(|i| p[i] + weight * (q[i] - p[i])))
    }
}

/// What is wrong with the place of a ring or circle, given the ring that it lies in next.
pub(super) fn ring_problem(figure: &Figure, place: usize, container: u32) -> Option<String> {
    let kind = figure.kinds.get(place).filter(|kind| kind.is_ring());
    let in_ring = || format!("lies in ring {container}");
    let around = figure.kinds.get(container as usize);
    match (kind, around) {
        (Some(ChainKind::Hole), None) => Some("lies outside the polygon".to_string()),
        (Some(ChainKind::Hole), Some(ChainKind::Outer))
            if figure.parts[container as usize] == figure.parts[place] =>
        {
            None
        }
        (Some(ChainKind::Hole), Some(_)) => {
            Some(format!("{}, not next in its own polygon", in_ring()))
        }
        (_, None | Some(ChainKind::Hole)) => None,
        (_, Some(_)) => Some(in_ring()),
    }
}
