//! The invariants of a figure, checked by other means than those that keep them.

use super::build::{corners, right_turn};
use super::crossings::{Curves, Found};
use super::nesting::direction;
use super::report::ring_problem;
use super::{ChainKind, Crossings, Figure, Point};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::points::{Bounds, check_coordinates};
use crate::predicates::orient2d;
use crate::sort::{float_key, sort_by_key};
use crate::validation::Validation;

impl Figure {
    /// Checks every invariant of the figure. Figures are made valid, so a problem is a defect of medax.
    ///
    /// Crossings are looked for by a sweep over sorted boxes, and each ring's place is told by a ray through all edges, instead of by the
    /// hierarchy and the sweep that made the figure. Errors: those of the job. Cost: O(n log n + b + r n) with b
    /// pairs of edges side by side and r rings and circles.
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| self.validate_in(run))
    }

    fn validate_in(&self, run: &Run<'_>) -> Result<Validation> {
        run.enter(Stage::Validate)?;
        let mut report = Validation::new();
        self.check_arrays(&mut report, run)?;
        if !report.is_valid() {
            return Ok(report);
        }
        self.check_chains(&mut report, run)?;
        if report.is_valid() {
            self.check_curves(&mut report, run)?;
        }
        Ok(report)
    }

    /// Lengths, numbers and coordinates.
    fn check_arrays(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let chains = self.chains.len();
        let lengths = [self.kinds.len(), self.parts.len()] == [chains; 2]
            && self.chains.indices().len() == self.vertices.len();
        report.check(lengths, ElementKind::Row, chains as u64, || {
            "the arrays of a figure differ in length".into()
        });
        for v in run.watch(self.chains.indices().iter().enumerate()) {
            let (i, &v) = v?;
            report.check(v as usize == i, ElementKind::Vertex, i as u64, || {
                "a chain's vertices do not follow each other".into()
            });
        }
        let same = |given: [f64; 3]| {
            let bits = |row: [f64; 3]| row.map(f64::to_bits);
            check_coordinates(given).is_ok_and(|kept| bits(kept) == bits(given))
        };
        for vertex in run.watch(self.vertices.iter().enumerate()) {
            let (i, &[x, y]) = vertex?;
            report.check(same([x, y, 0.0]), ElementKind::Vertex, i as u64, || {
                "a coordinate is out of range".into()
            });
        }
        for circle in run.watch(self.circles.iter().enumerate()) {
            let (i, &circle) = circle?;
            report.check(same(circle) && circle[2] > 0.0, ElementKind::Circle, i as u64, || {
                "a circle is out of range".into()
            });
        }
        let bounds = Bounds::of(corners(&self.vertices, &self.circles));
        report.check(bounds == Some(self.bounds), ElementKind::Row, 0, || {
            "the box is not the one round the figure".into()
        });
        Ok(())
    }

    /// Kinds, parts, and each chain by itself.
    fn check_chains(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        for chain in run.watch(0..self.chains.len()) {
            let chain = chain?;
            let problem = self.order_problem(chain).or_else(|| self.chain_problem(chain));
            report.check(problem.is_none(), ElementKind::Ring, chain as u64, || {
                problem.unwrap_or_default().into()
            });
        }
        Ok(())
    }

    fn order_problem(&self, chain: usize) -> Option<&'static str> {
        let (kind, part) = (self.kinds[chain], self.parts[chain]);
        let before = chain.checked_sub(1).map(|i| (self.kinds[i], self.parts[i]));
        let sound = match (before, kind) {
            (None, ChainKind::Hole) => false,
            (None, _) => part == 0,
            (Some((before, its)), ChainKind::Hole) => before.is_ring() && its == part,
            (Some((before, its)), _) => {
                let rank = |kind: ChainKind| (kind as u32).max(ChainKind::Hole as u32);
                rank(before) <= rank(kind) && its + 1 == part
            }
        };
        (!sound).then_some("a chain has a part out of order")
    }

    fn chain_problem(&self, chain: usize) -> Option<&'static str> {
        let range = self.range(chain);
        let kind = self.kinds[chain];
        let vertices = &self.vertices[range.start as usize..range.end as usize];
        let counts = match kind {
            ChainKind::Outer | ChainKind::Hole => vertices.len() >= 3,
            ChainKind::Polyline => vertices.len() >= 2,
            ChainKind::Point => vertices.len() == 1,
        };
        if !counts {
            return Some("a chain has too few vertices");
        }
        let at = |v: u32| self.vertices[v as usize];
        if self.edges(chain).any(|[a, b]| at(a) == at(b)) {
            return Some("a vertex is where the one before is");
        }
        if !kind.is_ring() {
            return None;
        }
        let turns = |w: &[Point]| !orient2d(&w[0], &w[1], &w[2]).is_zero();
        if !vertices.windows(3).any(turns) {
            return Some("a ring is on a line");
        }
        (direction(vertices) == -right_turn(kind)).then_some("a ring turns the wrong way")
    }

    /// Crossings, and where rings and circles are.
    fn check_curves(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut room = Room::new(run);
        let curves = Curves::new(self, &mut room, run)?;
        let found = swept(&curves, &mut room, run)?;
        let first = found.first.map_or(0, |[s, _]| s);
        report.check(
            found.crossings == self.normalised.crossings,
            ElementKind::Edge,
            u64::from(first),
            || format!("{} pairs of curves cross or touch", found.crossings),
        );
        if found.crossings > 0 {
            return Ok(());
        }
        let rings = self.ring_count();
        let mut misplaced = 0;
        for place in 0..rings + self.circles.len() {
            let is_inside = |&[inner, _]: &[u32; 2]| match curves.circle_of(inner) {
                Some(circle) => rings + circle == place,
                None => self.chain_of(inner) == place,
            };
            let problem = match found.inside.iter().any(is_inside) {
                true => Some("lies in a disc".to_string()),
                false => ring_problem(self, place, self.container(place, &curves, run)?),
            };
            misplaced += u64::from(problem.is_some());
            let is_accepted = self.options.crossings == Crossings::Accept;
            let kind = if place < rings { ElementKind::Ring } else { ElementKind::Circle };
            let index = if place < rings { place } else { place - rings };
            report.check(problem.is_none() || is_accepted, kind, index as u64, || {
                problem.unwrap_or_default()
            });
        }
        report.check(misplaced == self.normalised.misplaced, ElementKind::Row, 0, || {
            format!("{misplaced} rings and circles are in the wrong place")
        });
        Ok(())
    }

    /// The smallest of the rings round a ring or circle: of rings one in another, the one with the most round it.
    fn container(&self, place: usize, curves: &Curves<'_>, run: &Run<'_>) -> Result<u32> {
        let rings = self.ring_count();
        let from = match place.checked_sub(rings) {
            None => self.vertices[self.range(place).start as usize],
            Some(circle) => [self.circles[circle][0], self.circles[circle][1]],
        };
        let mut found = NONE;
        for ring in 0..rings {
            run.poll()?;
            if ring == place || !self.is_round(ring, &from) {
                continue;
            }
            // What lies in the disc of the circle is not round it.
            if let Some(circle) = place.checked_sub(rings) {
                let first = self.range(ring).start;
                let number = (self.vertices.len() + circle) as u32;
                if curves.relation(first, number) == super::meeting::Relation::Within {
                    continue;
                }
            }
            let inner = self.vertices[self.range(ring).start as usize];
            if found == NONE || self.is_round(found as usize, &inner) {
                found = ring as u32;
            }
        }
        Ok(found)
    }

    /// Whether a ray upward from a point crosses a ring an odd number of times.
    fn is_round(&self, ring: usize, p: &Point) -> bool {
        let above = self.edges(ring).filter(|edge| {
            let [a, b] = edge.map(|v| self.vertices[v as usize]);
            let (left, right) = if a[0] <= b[0] { (a, b) } else { (b, a) };
            left[0] <= p[0] && p[0] < right[0] && orient2d(&left, &right, p).is_negative()
        });
        above.count() % 2 == 1
    }
}

/// What [`Curves::find`] finds, by a sweep over the boxes from left to right.
fn swept(curves: &Curves<'_>, room: &mut Room<'_>, run: &Run<'_>) -> Result<Found> {
    let mut boxes = Vec::new();
    for curve in run.watch(curves.numbers()) {
        let curve = curve?;
        let corners = curves.corners(curve);
        room.push(&mut boxes, (Bounds::of(corners.into_iter()), curve))?;
    }
    let least = |bounds: &Option<Bounds>| bounds.map_or(0.0, |b| b.min[0]);
    sort_by_key(&mut boxes, |(bounds, _)| float_key(least(bounds)), run)?;
    let mut found = Found::default();
    for (i, (bounds, s)) in boxes.iter().enumerate() {
        let Some(bounds) = bounds else { continue };
        let later = boxes[i + 1..].iter();
        let beside = later.take_while(|(other, _)| least(other) <= bounds.max[0]);
        for other in run.watch(beside) {
            let (other, t) = other?;
            let meets = |b: &Bounds| b.min[1] <= bounds.max[1] && bounds.min[1] <= b.max[1];
            if other.as_ref().is_some_and(meets) {
                curves.look(*s, *t, &mut found, room)?;
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{FigureOptions, FigureParts};

    fn sound(options: FigureOptions) -> Figure {
        let square =
            |x: f64, side: f64| [[x, x], [x + side, x], [x + side, x + side], [x, x + side]];
        let parts = FigureParts {
            ring_vertices: &[square(0.0, 10.0), square(1.0, 8.0), square(2.0, 5.0)].concat(),
            ring_offsets: &[0, 4, 8, 12],
            polygon_offsets: &[0, 2, 3],
            polyline_vertices: &[[20.0, 0.0], [21.0, 0.0], [21.0, 3.0]],
            polyline_offsets: &[0, 3],
            points: &[[5.0, 5.0]],
            circles: &[[30.0, 30.0, 2.0]],
        };
        Figure::new(parts, options, &Job::default()).unwrap()
    }

    #[test]
    fn what_is_broken_by_hand_is_noticed() {
        let figure = sound(FigureOptions::default());
        assert!(figure.validate(&Job::default()).unwrap().is_valid());
        type Break = (ElementKind, u64, fn(&mut Figure));
        let breaks: [Break; 19] = [
            (ElementKind::Row, 5, |f| drop(f.kinds.pop())),
            (ElementKind::Row, 5, |f| f.parts.push(9)),
            (ElementKind::Vertex, 3, |f| f.vertices[3][0] = f64::NAN),
            (ElementKind::Vertex, 0, |f| f.vertices[0][0] = -0.0),
            (ElementKind::Circle, 0, |f| f.circles[0][2] = -1.0),
            (ElementKind::Row, 0, |f| f.bounds.max[0] += 1.0),
            (ElementKind::Ring, 0, |f| f.kinds[0] = ChainKind::Hole),
            (ElementKind::Ring, 2, |f| f.parts[2] = 0),
            (ElementKind::Ring, 1, |f| f.kinds[1] = ChainKind::Outer),
            (ElementKind::Ring, 4, |f| f.kinds[3] = ChainKind::Point),
            (ElementKind::Ring, 0, |f| f.vertices[1] = f.vertices[0]),
            (ElementKind::Ring, 0, |f| f.vertices[..4].reverse()),
            (ElementKind::Ring, 1, |f| f.vertices[4..8].reverse()),
            (ElementKind::Edge, 0, |f| f.vertices[2] = [5.0, 0.5]),
            (ElementKind::Edge, 0, |f| f.vertices[4] = [5.0, 0.0]),
            (ElementKind::Edge, 12, |f| f.vertices[13] = [28.5, 30.0]),
            // In the polygon, not in its hole any more.
            (ElementKind::Ring, 2, |f| {
                f.vertices[8..12].iter_mut().for_each(|p| *p = p.map(|x| 0.1 * x + 0.3))
            }),
            (ElementKind::Edge, 0, |f| f.normalised.crossings = 1),
            (ElementKind::Row, 0, |f| f.normalised.misplaced = 1),
        ];
        for (i, (kind, index, break_it)) in breaks.into_iter().enumerate() {
            let mut broken = figure.clone();
            break_it(&mut broken);
            let report = broken.validate(&Job::default()).unwrap();
            let (found, at, message) = report.first.unwrap_or_else(|| panic!("break {i}"));
            assert_eq!((found, at), (kind, index), "break {i}: {message}");
        }
    }
}
