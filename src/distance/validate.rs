//! The check of medial points, and of what they are put together to.

use super::arcs::MedialGraph;
use super::bound::largest_missed_angle;
use super::closest::Shape;
use super::field::{Cover, FieldAxis};
use super::locate::MedialPoint;
use super::piece::Piece;
use super::sites::Sites;
use super::space::Lattice;
use crate::error::{ElementKind, Result};
use crate::job::{Job, Room, Run, Stage};
use crate::validation::Validation;
use crate::vector::{Vec3, add, length, scale, sub};
use std::f64::consts::PI;

/// How near the points of a graph are to the axis, as a share of the boundary's size.
const GRAPH_EPSILON: f64 = 1e-8;
/// What rounding may do to an angle.
const ANGLE_EPSILON: f64 = 1e-9;

impl FieldAxis {
    /// Checks all points: each has its feet on their pieces, at its radius within twice epsilon, and nothing nearer than its radius less epsilon; its object angle is that between the
    /// ways to its feet; it passes the thresholds, lies on the side that was asked for, between such sites, and within its cover; in space it has a cube for itself. Checks that covers
    /// count their points, and that no circle in the plane is entered by the boundary, or claims more than theorem 10 does. Errors: those of the job. Cost: some queries for each
    /// point and each circle.
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            self.check_points(&mut report, run)?;
            self.check_covers(&mut report, run)?;
            if self.sites.dimension() == 3 {
                self.check_cubes(&mut report, run)?;
            }
            Ok(report)
        })
    }

    fn check_points(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let epsilon = self.options.decide.epsilon;
        let centers = Room::new(run).collect(self.points.iter().map(|point| point.center))?;
        let is_here = self.sites.are_on(self.options.side, &centers, run)?;
        for item in run.watch((0..).zip(self.points.iter().zip(is_here))) {
            let (i, (point, is_here)) = item?;
            self.sites.check_ball(point, epsilon, i, report);
            if !self.sites.check_feet(point, epsilon, i, report) {
                continue;
            }
            let passes = self.options.pass(point);
            report.check(passes, ElementKind::Vertex, i, || "it is below a threshold".into());
            report.check(is_here, ElementKind::Vertex, i, || "it is on the other side".into());
            let is_between = self.pairs.holds(&self.sites, point);
            report.check(is_between, ElementKind::Vertex, i, || {
                "it is between sites that nobody asked for".into()
            });
        }
        Ok(())
    }

    fn check_covers(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let (points, covers) = (&self.points, &self.covers);
        let right = self.cover_of_point.len() == points.len()
            && self.cover_of_point.is_sorted()
            && self.cover_of_point.iter().all(|&cover| (cover as usize) < covers.len());
        report.check(right, ElementKind::Vertex, 0, || "points have no covers in order".into());
        if !right {
            return Ok(());
        }
        let mut found = Room::new(run).filled(covers.len(), 0)?;
        for item in run.watch((0..).zip(points.iter().zip(&self.cover_of_point))) {
            let (i, (point, &number)) = item?;
            let Cover { center, radius, .. } = covers[number as usize];
            let away = length(sub(point.center, center));
            let is_in = away <= radius * (1.0 + 1e-9) + self.options.decide.epsilon;
            report.check(is_in, ElementKind::Vertex, i, || {
                format!("it is {away} from the middle of cover {number}")
            });
            found[number as usize] += 1;
        }
        for item in run.watch((0..).zip(covers.iter().zip(found))) {
            let (i, (cover, found)) = item?;
            report.check(cover.found == found, ElementKind::Cell, i, || {
                format!("it counts {} points and has {found}", cover.found)
            });
            let Cover { center, radius, gap, .. } = *cover;
            // In space there is no claim, and spheres may be entered.
            if self.sites.dimension() == 3 {
                let right = cover.missed_angle == PI;
                report.check(right, ElementKind::Cell, i, || "it claims something in space".into());
                continue;
            }
            let mut is_free = true;
            self.sites.tree().within(center, radius * radius * (1.0 - 1e-9), |_| is_free = false);
            report.check(is_free, ElementKind::Cell, i, || "the boundary enters it".into());
            let reach = cover.half * std::f64::consts::SQRT_2;
            let least = (cover.distance - reach).max(self.options.min_distance);
            let bound = largest_missed_angle(gap, radius, least).unwrap_or(PI);
            let claim = cover.missed_angle;
            // The distance from the boundary is that of rounded coordinates, and so is the radius.
            let room = least.min(radius);
            let slack = ANGLE_EPSILON + 64.0 * blur(center) / room;
            // What was looked at are more points than were asked for: so the bound may be less than the claim.
            let right = match found {
                0 => claim >= bound - slack && (claim == PI || claim <= self.options.bound),
                _ => claim == 0.0,
            };
            report.check(right, ElementKind::Cell, i, || {
                format!("it claims {claim}, where the bound is {bound}")
            });
        }
        Ok(())
    }

    fn check_cubes(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let lattice = Lattice::finest(&self.options)?;
        for item in run.watch((1..).zip(self.points.windows(2))) {
            let (i, pair) = item?;
            let ascend = lattice.place(pair[0].center) < lattice.place(pair[1].center);
            report.check(ascend, ElementKind::Vertex, i, || {
                "its cube does not come after that of the point before".into()
            });
        }
        Ok(())
    }
}

impl MedialGraph {
    /// Checks that the balls of all points are free of the boundary and touch it; that points which are no nodes have their feet on their pieces, at their radius, and seen under their object
    /// angle; and that arcs have nodes at their ends only, nodes arcs, unless they are centres of discs, and other points one place on one arc. Errors: those of the job. Cost: some queries for each point.
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            let epsilon = GRAPH_EPSILON * self.sites.size();
            for item in run.watch((0..).zip(&self.points)) {
                let (i, point) = item?;
                self.sites.check_ball(point, epsilon, i, &mut report);
                // Those of a node are those of a point beside it.
                if i >= self.node_count as u64 {
                    self.sites.check_feet(point, epsilon, i, &mut report);
                }
            }
            self.check_arcs(&mut report, run)?;
            Ok(report)
        })
    }

    fn check_arcs(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut places = Room::new(run).filled(self.points.len(), 0u32)?;
        let is_node = |v: u32| (v as usize) < self.node_count;
        for item in run.watch((0..).zip(&self.arcs)) {
            let (i, arc) = item?;
            let count = self.points.len();
            let right = arc.len() >= 2 && arc.iter().all(|&v| (v as usize) < count);
            report.check(right, ElementKind::Edge, i, || "it is no arc of points".into());
            if !right {
                continue;
            }
            let inner = &arc[1..arc.len() - 1];
            report.check(!inner.iter().any(|&v| is_node(v)), ElementKind::Edge, i, || {
                "a node lies within it".into()
            });
            let moves = arc.windows(2).all(|pair| pair[0] != pair[1]);
            report.check(moves, ElementKind::Edge, i, || "a point follows itself".into());
            // A loop comes back to its first point, which has one place all the same.
            let is_loop = arc[0] == arc[arc.len() - 1];
            arc[usize::from(is_loop)..].iter().for_each(|&v| places[v as usize] += 1);
        }
        for (v, places) in (0..).zip(places) {
            let right = if is_node(v) { places > 0 || self.is_disc(v) } else { places == 1 };
            report.check(right, ElementKind::Vertex, u64::from(v), || {
                format!("it has {places} places on arcs")
            });
        }
        Ok(())
    }
}

impl MedialGraph {
    /// Whether a node is the centre of a disc, which no arc comes to.
    fn is_disc(&self, node: u32) -> bool {
        let MedialPoint { center, pieces, .. } = self.points[node as usize];
        let near = 1e-9 * self.sites.size();
        pieces.iter().any(|&piece| match self.sites.pieces().get(piece as usize) {
            Some(&Piece::Sphere(middle, _)) => length(sub(center, middle)) <= near,
            _ => false,
        })
    }
}

impl Sites {
    /// Checks that a ball touches the boundary, and that this does not enter it.
    fn check_ball(&self, point: &MedialPoint, epsilon: f64, i: u64, report: &mut Validation) {
        let MedialPoint { center, radius, .. } = *point;
        let epsilon = epsilon + blur(center);
        let mut nearest = f64::INFINITY;
        let far = radius + epsilon;
        let limit = far * far;
        self.tree().within(center, limit, |foot| nearest = nearest.min(foot.distance_squared));
        let nearest = nearest.sqrt();
        report.check(nearest.is_finite(), ElementKind::Vertex, i, || {
            format!("nothing is as near as {radius}")
        });
        report.check(nearest >= radius - epsilon, ElementKind::Vertex, i, || {
            format!("something is {nearest} away, and not {radius}")
        });
    }

    /// Checks feet, and the angle between the ways to them. Whether there are the pieces that are named.
    fn check_feet(
        &self,
        point: &MedialPoint,
        epsilon: f64,
        i: u64,
        report: &mut Validation,
    ) -> bool {
        let MedialPoint { center, radius, feet, pieces, object_angle } = *point;
        let epsilon = epsilon + blur(center);
        let are_there = pieces.iter().all(|&piece| (piece as usize) < self.pieces().len());
        report.check(are_there, ElementKind::Vertex, i, || "it names a piece that is not".into());
        if !are_there {
            return false;
        }
        for (foot, piece) in feet.into_iter().zip(pieces) {
            let shape = Shape::from(&self.pieces()[piece as usize]);
            let on = length(sub(shape.closest(foot), foot)) <= epsilon;
            report.check(on, ElementKind::Vertex, i, || format!("a foot is not on piece {piece}"));
            let away = length(sub(foot, center));
            report.check((away - radius).abs() <= 2.0 * epsilon, ElementKind::Vertex, i, || {
                format!("a foot is {away} away, and not {radius}")
            });
        }
        // Kahan's formula, another one than that which made the angle.
        let [a, b] = feet.map(|foot| sub(foot, center));
        let (a, b) = (scale(a, length(b)), scale(b, length(a)));
        let angle = 2.0 * libm::atan2(length(sub(a, b)), length(add(a, b)));
        let slack = ANGLE_EPSILON + 4.0 * blur(center) / radius;
        report.check((angle - object_angle).abs() <= slack, ElementKind::Vertex, i, || {
            format!("it sees its feet under {angle}, and not {object_angle}")
        });
        true
    }
}

/// What rounding may do to coordinates there.
fn blur(p: Vec3) -> f64 {
    4.0 * f64::EPSILON * p.into_iter().fold(0.0, |size, x| x.abs().max(size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::distance::{FieldOptions, GraphOptions};
    use crate::medial::Side;
    use std::sync::Arc;

    /// A square, as one site for each side.
    fn square() -> Arc<Sites> {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let pieces = (0..4).map(|i| Piece::Segment([corners[i], corners[(i + 1) % 4]])).collect();
        let sites = Sites::new(2, pieces, vec![0, 1, 2, 3], &Job::default()).unwrap();
        Arc::new(sites.with_closed(vec![true; 4]).unwrap())
    }

    fn in_plane() -> FieldAxis {
        let options = FieldOptions { density: 0.1, angle: 0.2, ..FieldOptions::default() };
        FieldAxis::new(&square(), options, &Job::default()).unwrap()
    }

    fn in_space() -> FieldAxis {
        let pieces = [-1.0, 1.0].map(|x| Piece::Point([x, 0.0, 0.0])).to_vec();
        let sites = Arc::new(Sites::new(3, pieces, vec![0, 1], &Job::default()).unwrap());
        let clip = Some([[-1.5; 3], [1.5; 3]]);
        let options =
            FieldOptions { side: Side::Outer, density: 0.5, clip, ..FieldOptions::default() };
        FieldAxis::new(&sites, options, &Job::default()).unwrap()
    }

    #[test]
    fn whatever_is_changed_in_an_axis_is_noticed() {
        type Change = fn(&mut FieldAxis);
        let changes: [(&str, Change); 14] = [
            ("center", |axis| axis.points[3].center[0] += 0.01),
            ("radius", |axis| axis.points[3].radius *= 1.01),
            ("smaller radius", |axis| axis.points[3].radius *= 0.99),
            ("foot", |axis| axis.points[3].feet[1] = axis.points[3].center),
            ("foot beside", |axis| axis.points[3].feet[0][2] += 1e-3),
            ("piece", |axis| axis.points[3].pieces[0] = 77),
            ("angle", |axis| axis.points[3].object_angle += 1e-6),
            ("threshold", |axis| axis.options.angle = 3.2),
            ("least distance", |axis| axis.options.min_distance = 10.0),
            ("covers", |axis| axis.cover_of_point.truncate(3)),
            ("order", |axis| axis.cover_of_point.reverse()),
            ("count", |axis| axis.covers[0].found += 1),
            ("place", |axis| {
                let cover = axis.cover_of_point[3] as usize;
                axis.covers[cover].center[1] += 100.0;
            }),
            ("claim", |axis| axis.covers[0].missed_angle = 1e-3),
        ];
        for axis in [in_plane(), in_space()] {
            let report = axis.validate(&Job::default()).unwrap();
            assert!(report.is_valid() && report.checked > 100, "{report:?}");
            for (name, change) in changes {
                let mut axis = axis.clone();
                change(&mut axis);
                assert!(!axis.validate(&Job::default()).unwrap().is_valid(), "{name}");
            }
        }
        let mut other_side = in_plane();
        other_side.options.side = Side::Outer;
        assert!(!other_side.validate(&Job::default()).unwrap().is_valid());
        let mut other_sites = in_plane();
        other_sites.pairs =
            super::super::pairs::SitePairs::of(&square(), false, &[[0, 1]]).unwrap();
        assert!(!other_sites.validate(&Job::default()).unwrap().is_valid());
        let mut entered = in_plane();
        entered.covers[0].radius *= 50.0;
        assert!(!entered.validate(&Job::default()).unwrap().is_valid());
        let mut two_in_a_cube = in_space();
        two_in_a_cube.points[1] = two_in_a_cube.points[0];
        two_in_a_cube.covers[1] = two_in_a_cube.covers[0];
        let report = two_in_a_cube.validate(&Job::default()).unwrap();
        assert_eq!((report.problems, report.first.unwrap().1), (1, 1));
    }

    #[test]
    fn whatever_is_changed_in_a_graph_is_noticed() {
        let job = Job::default();
        let graph = MedialGraph::new(&square(), GraphOptions::default(), &job).unwrap();
        let report = graph.validate(&job).unwrap();
        assert!(report.is_valid() && report.checked > 100, "{report:?}");
        type Change = fn(&mut MedialGraph);
        let changes: [(&str, Change); 8] = [
            ("node", |graph| graph.points[0].center = graph.points[0].center.map(|x| x + 1e-3)),
            ("center", |graph| graph.points[20].center[0] += 1e-3),
            ("angle", |graph| graph.points[20].object_angle += 1e-6),
            ("foot", |graph| graph.points[20].feet[0][0] += 1e-3),
            ("a node within", |graph| graph.arcs[0][3] = 0),
            ("twice", |graph| graph.arcs[0][3] = graph.arcs[0][4]),
            ("short", |graph| graph.arcs[1].truncate(1)),
            ("no arc", |graph| {
                graph.arcs.pop();
            }),
        ];
        for (name, change) in changes {
            let mut graph = graph.clone();
            change(&mut graph);
            assert!(!graph.validate(&job).unwrap().is_valid(), "{name}");
        }
    }
}
