//! Arcs as polylines.

use super::envelope::Envelope;
use super::frame::Frame;
use super::sides::{ArcSide, Node, Position};
use super::walk::Walks;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Values};
use crate::distance::decide::DecideOptions;
use crate::distance::locate::{MedialPoint, Search};
use crate::distance::pairs::SitePairs;
use crate::distance::plane::FINEST;
use crate::distance::sites::Sites;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::medial::Side;
use crate::points::{Bounds, COORDINATE_MAX};
use crate::vector::{add, cross, length, scale, sub};
use std::f64::consts::PI;
use std::sync::Arc;

/// How often a part of an arc is halved at most.
const DEPTH: usize = 24;
/// How often the place is halved where an arc passes a threshold.
const HALVED: usize = 48;
/// How far a part of an arc may bulge, as a share of the spacing.
const BULGE: f64 = 0.02;

/// Which part of the axis, and how finely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GraphOptions {
    /// On which side of closed curves; inside by default. Without these all is outside.
    pub side: Side,
    /// The longest edge of a polyline, in input units. 0, the default, asks for a hundredth of the size of the boundary's box.
    pub spacing: f64,
    /// The least object angle, in radians in [0, pi]; 0 by default.
    pub angle: f64,
    /// The least distance from the boundary, in input units; 0 by default.
    pub min_distance: f64,
    /// Keep only what has its nearest points on two sites; off by default. With sites that are not convex the rest is no part of their Voronoi diagram.
    pub between_sites: bool,
    /// The corners of a box that holds what is looked at, as for [`FieldOptions`](crate::distance::FieldOptions).
    pub clip: Option<[[f64; 3]; 2]>,
}

impl Default for GraphOptions {
    fn default() -> Self {
        GraphOptions {
            side: Side::Inner,
            spacing: 0.0,
            angle: 0.0,
            min_distance: 0.0,
            between_sites: false,
            clip: None,
        }
    }
}

/// The medial axis of a boundary in the plane: nodes, where arcs meet or end, and arcs.
///
/// Without thresholds it is a deformation retract of the region, and has its Betti numbers. Invariants: `arcs` has for each arc its points in order, at least two; nodes, whose numbers are below that of the
/// nodes, are ends of arcs and lie within none, and one without arcs is the centre of a disc; other points lie on one arc, once, but for those of which a loop without nodes begins and ends; every point is the centre of a ball that the boundary does
/// not enter.
#[derive(Clone, Debug)]
pub struct MedialGraph {
    pub(in crate::distance) sites: Arc<Sites>,
    pub(in crate::distance) node_count: usize,
    pub(in crate::distance) points: Vec<MedialPoint>,
    pub(in crate::distance) arcs: Vec<Vec<u32>>,
    torn: usize,
}

impl MedialGraph {
    /// Follows the axis of segments, points and circles in the plane. Segments must meet in common ends only, and touch no circle: those of a [`Figure`](crate::figure::Figure) do. Points may lie anywhere.
    ///
    /// Errors: [`Status::InvalidArgument`] in space and for options out of range; [`Status::LimitExceeded`] for a spacing of less than 2^-20 of the box; [`Status::Unsupported`] with its row for a line or a ray; those of the job. Cost: O((n + size) log n).
    pub fn new(sites: &Arc<Sites>, options: GraphOptions, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Field, 1.0)], |run| MedialGraph::new_in(sites, options, run))
    }

    /// The same, of which only what has its nearest points on one of some pairs of sites is kept, as [`FieldAxis::between`](crate::distance::FieldAxis::between) does.
    ///
    /// Errors: as [`MedialGraph::new`]; [`Status::InvalidArgument`] with the row of a pair that names no site.
    pub fn between(
        sites: &Arc<Sites>,
        pairs: &[[u32; 2]],
        options: GraphOptions,
        job: &Job,
    ) -> Result<Self> {
        job.run(&[(Stage::Field, 1.0)], |run| MedialGraph::between_in(sites, pairs, options, run))
    }

    /// [`MedialGraph::between`] as a stage of a larger build.
    pub(crate) fn between_in(
        sites: &Arc<Sites>,
        pairs: &[[u32; 2]],
        options: GraphOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        let pairs = SitePairs::of(sites, options.between_sites, pairs)?;
        MedialGraph::of(sites, options, pairs, run)
    }

    /// [`MedialGraph::new`] as a stage of a larger build.
    pub(crate) fn new_in(sites: &Arc<Sites>, options: GraphOptions, run: &Run<'_>) -> Result<Self> {
        MedialGraph::of(sites, options, SitePairs::any(options.between_sites), run)
    }

    fn of(
        sites: &Arc<Sites>,
        options: GraphOptions,
        pairs: SitePairs,
        run: &Run<'_>,
    ) -> Result<Self> {
        let (spacing, rim) = options.resolved(sites)?;
        let frame = Frame::new(sites, run)?;
        let (given, sites, rim) = (sites, &frame.sites, frame.inward(rim));
        run.enter(Stage::Field)?;
        let mut room = Room::new(run);
        let walks = Walks::new(sites, &mut room, run)?;
        let size = sites.size();
        let exact = DecideOptions { tolerance: 1e-13 * size, epsilon: 1e-15 * size };
        // What is seen under so small an angle is nearer or farther by rounding.
        let search = Search { blur: 1e-7, ..sites.search(exact)? };
        let envelope = Envelope { search, walks: &walks, rim, run };
        let found = envelope.arc_sides(1e-9 * size, &mut room)?;
        let maker = Maker { envelope, options, pairs, spacing, nodes: &found.nodes, sites };
        let chosen = maker.on_side((0..).zip(&found.sides).collect(), run)?;
        let torn = chosen.iter().filter(|(_, side)| !side.agrees).count();
        // An arc has two sides; a loop that is its own opposite is a point.
        let is_first = |&(i, side): &(u32, &ArcSide)| !side.agrees || i <= side.partner;
        let chosen: Vec<&ArcSide> =
            chosen.into_iter().filter(is_first).map(|(_, side)| side).collect();
        let lines = run.in_steps(chosen.chunks(16).collect(), [0.5, 1.0], |sides| {
            run.poll()?;
            let mut room = Room::new(run);
            let lines: Result<Vec<_>> =
                sides.iter().map(|side| maker.lines(side, &mut room)).collect();
            lines.map(|lines| (lines, room))
        })?;
        // What the lines take stays counted until they are joined.
        let (lines, _rooms): (Vec<_>, Vec<_>) = lines.into_iter().unzip();
        let lines = lines.into_iter().flatten().flatten();
        let mut graph = maker.join(lines, torn, &mut room, run)?;
        graph.points.iter_mut().for_each(|point| *point = frame.outward(*point));
        Ok(MedialGraph { sites: given.clone(), ..graph })
    }

    /// What the boundary was.
    pub fn sites(&self) -> &Arc<Sites> {
        &self.sites
    }

    /// The number of nodes.
    pub fn node_count(&self) -> usize {
        self.node_count
    }

    /// The nodes, then the other points of arcs.
    pub fn points(&self) -> &[MedialPoint] {
        &self.points
    }

    /// The points of each arc.
    pub fn arcs(&self) -> &[Vec<u32>] {
        &self.arcs
    }

    /// How many sides of arcs have no other side that agrees with them: 0 but for figures with parts that are apart by less than a millionth of their size, or with vertices that are nearly straight.
    pub fn torn(&self) -> usize {
        self.torn
    }

    /// The arcs as loose edges, with z 0. Vertices carry what those of [`FieldAxis::complex`](crate::distance::FieldAxis::complex) do, but for the bound, and `is_node`; edges `arc`.
    pub fn complex(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let mut room = Room::new(run);
            let count = self.arcs.iter().map(|arc| arc.len() - 1).sum();
            let (mut edges, mut arc_of) = (room.vec(count)?, room.vec(count)?);
            for (number, arc) in (0..).zip(&self.arcs) {
                run.poll()?;
                edges.extend(arc.windows(2).map(|ends| [ends[0], ends[1]]));
                arc_of.resize(edges.len(), number);
            }
            let mut attributes = self.sites.attributes_of(Element::Vertex, &self.points, run)?;
            let is_node = (0..self.points.len()).map(|i| u32::from(i < self.node_count));
            let is_node = Values::U32(room.collect(is_node)?);
            attributes.push(Attribute::new("is_node", Element::Vertex, 1, is_node)?);
            attributes.push(Attribute::new("arc", Element::Edge, 1, Values::U32(arc_of))?);
            let parts = ComplexParts {
                dimension: 2,
                vertices: room.collect(self.points.iter().map(|point| point.center))?,
                edges,
                attributes,
                ..ComplexParts::default()
            };
            Complex::new_in(parts, run)
        })
    }
}

impl GraphOptions {
    /// The spacing, and the box.
    fn resolved(&self, sites: &Sites) -> Result<(f64, Bounds)> {
        let wrong = |message: String| Err(Error::new(Status::InvalidArgument, message));
        if sites.dimension() != 2 {
            return wrong("a graph of arcs is that of a boundary in the plane".into());
        }
        for (name, value) in [("spacing", self.spacing), ("least distance", self.min_distance)] {
            if !(0.0..=COORDINATE_MAX).contains(&value) {
                return wrong(format!("a {name} of {value} is no length"));
            }
        }
        if !(0.0..=PI).contains(&self.angle) {
            return wrong(format!("an object angle of {} is not between 0 and pi", self.angle));
        }
        let rim = self.rim(sites)?;
        let spacing = if self.spacing > 0.0 { self.spacing } else { 0.01 * sites.size() };
        if rim.extent().into_iter().fold(0.0, f64::max) * FINEST > spacing {
            let message = "the spacing is less than 2^-20 of the box";
            return Err(Error::new(Status::LimitExceeded, message));
        }
        Ok((spacing, rim))
    }

    /// The box of what is looked at.
    fn rim(&self, sites: &Sites) -> Result<Bounds> {
        let wrong = |message: &str| Err(Error::new(Status::InvalidArgument, message));
        if let Some([min, max]) = self.clip {
            let is_box = (0..2).all(|k| min[k] < max[k]);
            if !is_box || !min.iter().chain(&max).all(|x| x.abs() <= COORDINATE_MAX) {
                return wrong("the corners of the box to clip to are no box");
            }
            return Ok(Bounds { min, max });
        }
        let Some(Bounds { min, max }) = sites.bounds() else {
            return wrong("without a box to clip to, what is unbounded has no end");
        };
        // All of the inside is in the box of the boundary; rounding must not put it out.
        let share = if self.side == Side::Inner { 1e-6 } else { 0.5 };
        let margin = share * sites.size();
        Ok(Bounds { min: min.map(|x| x - margin), max: max.map(|x| x + margin) })
    }
}

/// A part of an arc that passes the thresholds: the nodes at its ends, if it comes to them, and what lies between.
struct Line {
    ends: [Option<u32>; 2],
    points: Vec<MedialPoint>,
}

struct Maker<'a> {
    envelope: Envelope<'a>,
    options: GraphOptions,
    pairs: SitePairs,
    spacing: f64,
    nodes: &'a [Node],
    sites: &'a Arc<Sites>,
}

impl Maker<'_> {
    /// The sides of arcs that are on the side that was asked for.
    fn on_side<'b>(
        &self,
        sides: Vec<(u32, &'b ArcSide)>,
        run: &Run<'_>,
    ) -> Result<Vec<(u32, &'b ArcSide)>> {
        if self.options.side == Side::Both {
            return Ok(sides);
        }
        let middle = |(_, side): &(u32, &ArcSide)| {
            let [begin, end] = side.span;
            let touch = self.envelope.touch_of(self.envelope.walk_of(side), 0.5 * (begin + end));
            touch.map_or([f64::MAX; 3], |touch| touch.point.center)
        };
        let middles: Vec<_> = sides.iter().map(middle).collect();
        let is_inside = self.sites.is_inside_in(&middles, run)?;
        let wanted = self.options.side == Side::Inner;
        let here = sides.into_iter().zip(is_inside).filter(|&(_, is_inside)| is_inside == wanted);
        Ok(here.map(|(side, _)| side).collect())
    }

    fn passes(&self, point: &MedialPoint) -> bool {
        point.radius >= self.options.min_distance
            && point.object_angle >= self.options.angle
            && self.pairs.holds(self.sites, point)
    }

    /// The parts of an arc that pass the thresholds.
    fn lines(&self, side: &ArcSide, room: &mut Room<'_>) -> Result<Vec<Line>> {
        let walk = self.envelope.walk_of(side);
        let at =
            |position: Position| Some((position, self.envelope.touch_of(walk, position)?.point));
        let [begin, end] = side.span;
        let mut own = Room::new(self.envelope.run);
        let mut places: Vec<(Position, MedialPoint)> = Vec::new();
        // Ends of features are where an arc bends, and what comes back to where it began is seen from between; the nodes themselves are added later.
        let bends = (begin.floor() as i64 + 1..end.ceil() as i64).map(|i| i as f64);
        let between = [1e-9, 0.25, 0.5, 0.75, 1.0 - 1e-9].map(|t| begin + t * (end - begin));
        let mut stops: Vec<Position> = bends.chain(between).collect();
        stops.sort_by(f64::total_cmp);
        stops.dedup();
        for stop in stops.into_iter().filter_map(at) {
            if let Some(&last) = places.last() {
                self.divide(walk, [last, stop], 0, &mut places, &mut own)?;
            }
            own.push(&mut places, stop)?;
        }
        let mut lines: Vec<Line> = Vec::new();
        let mut last: Option<(Position, MedialPoint, bool)> = None;
        for (position, point) in places {
            let passes = self.passes(&point);
            let crossing = |from: Position, to: Position| self.threshold(walk, from, to);
            match (last, passes) {
                (None, true) => {
                    let node = side.nodes[0];
                    let ends = [(node != NONE).then_some(node), None];
                    lines.push(Line { ends, points: vec![point] });
                }
                (Some((_, _, true)), true) => {
                    if let Some(line) = lines.last_mut() {
                        room.push(&mut line.points, point)?;
                    }
                }
                (Some((from, _, false)), true) => {
                    let first = crossing(position, from);
                    let points = first.into_iter().chain([point]).collect();
                    lines.push(Line { ends: [None; 2], points });
                }
                (Some((from, _, true)), false) => {
                    let last = crossing(from, position);
                    if let (Some(line), Some(last)) = (lines.last_mut(), last) {
                        room.push(&mut line.points, last)?;
                    }
                }
                (_, false) => {}
            }
            last = Some((position, point, passes));
        }
        if let (Some((_, _, true)), Some(line)) = (last, lines.last_mut()) {
            let node = side.nodes[1];
            line.ends[1] = (node != NONE).then_some(node);
        }
        Ok(lines)
    }

    /// The last point that passes the thresholds on the way from a position where they are passed to one where they are not.
    fn threshold(&self, walk: usize, from: Position, to: Position) -> Option<MedialPoint> {
        let (mut passing, mut failing, mut found) = (from, to, None);
        for _ in 0..HALVED {
            let middle = 0.5 * (passing + failing);
            match self.envelope.touch_of(walk, middle).filter(|touch| self.passes(&touch.point)) {
                Some(touch) => {
                    passing = middle;
                    found = Some(touch.point);
                }
                None => failing = middle,
            }
        }
        found
    }

    /// Adds points between two of an arc until edges are short, and the arc bulges little.
    fn divide(
        &self,
        walk: usize,
        [from, to]: [(Position, MedialPoint); 2],
        depth: usize,
        places: &mut Vec<(Position, MedialPoint)>,
        room: &mut Room<'_>,
    ) -> Result<()> {
        self.envelope.run.poll()?;
        let chord = sub(to.1.center, from.1.center);
        let size = length(chord);
        if depth >= DEPTH || size <= 1e-3 * self.spacing {
            return Ok(());
        }
        let position = 0.5 * (from.0 + to.0);
        let Some(touch) = self.envelope.touch_of(walk, position) else { return Ok(()) };
        let way = sub(touch.point.center, from.1.center);
        let bulge = cross(chord, way)[2].abs() / size;
        if size <= self.spacing && bulge <= BULGE * self.spacing {
            return Ok(());
        }
        let middle = (position, touch.point);
        self.divide(walk, [from, middle], depth + 1, places, room)?;
        room.push(places, middle)?;
        self.divide(walk, [middle, to], depth + 1, places, room)
    }

    /// Numbers the nodes that are still of use, and joins the lines to them.
    fn join(
        &self,
        lines: impl Iterator<Item = Line>,
        torn: usize,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<MedialGraph> {
        // The axis of a disc is a point, which its whole rim sees.
        let (dots, lines): (Vec<Line>, Vec<Line>) = lines.partition(|line| self.is_dot(line));
        let mut number = room.filled(self.nodes.len(), NONE)?;
        let mut points: Vec<MedialPoint> = Vec::new();
        for line in run.watch(&lines) {
            let line = line?;
            // The balls of a node are those of the arcs that meet there: that with the largest angle stands for it.
            let ends = [line.points.first(), line.points.last()];
            for (end, near) in line.ends.into_iter().zip(ends) {
                let (Some(node), Some(&near)) = (end, near) else { continue };
                let Node { center, radius } = self.nodes[node as usize];
                let point = MedialPoint { center, radius, ..near };
                match number[node as usize] {
                    NONE => {
                        number[node as usize] = points.len() as u32;
                        room.push(&mut points, point)?;
                    }
                    known => {
                        let known = &mut points[known as usize];
                        if point.object_angle > known.object_angle {
                            *known = point;
                        }
                    }
                }
            }
        }
        let widest = |p: &&MedialPoint, q: &&MedialPoint| p.object_angle.total_cmp(&q.object_angle);
        for dot in dots.iter().filter_map(|line| line.points.iter().max_by(widest)) {
            room.push(&mut points, *dot)?;
        }
        let node_count = points.len();
        let mut arcs = Vec::new();
        for line in run.watch(lines) {
            let line = line?;
            let mut arc: Vec<u32> = Vec::new();
            let node = |end: Option<u32>| end.map(|node| number[node as usize]);
            arc.extend(node(line.ends[0]));
            // The points beside nodes are as good as there.
            let inner = match line.ends.map(|end| end.is_some()) {
                [true, true] if line.points.len() >= 2 => &line.points[1..line.points.len() - 1],
                [true, false] if !line.points.is_empty() => &line.points[1..],
                [false, true] if !line.points.is_empty() => &line.points[..line.points.len() - 1],
                _ => &line.points[..],
            };
            for &point in inner {
                room.push(&mut arc, points.len() as u32)?;
                room.push(&mut points, point)?;
            }
            match node(line.ends[1]) {
                Some(node) => arc.push(node),
                // A loop without nodes ends where it began.
                None if line.ends[0].is_none() && self.is_closed(&line) => {
                    arc.extend(arc.first().copied())
                }
                None => {}
            }
            arc.dedup();
            if arc.len() >= 2 {
                room.push(&mut arcs, arc)?;
            }
        }
        Ok(MedialGraph { sites: self.sites.clone(), node_count, points, arcs, torn })
    }

    /// Whether a line without nodes is a point but for rounding.
    fn is_dot(&self, line: &Line) -> bool {
        let near = 1e-9 * self.sites.size();
        let is_near = |p: &MedialPoint, q: &MedialPoint| length(sub(p.center, q.center)) <= near;
        line.ends == [None; 2] && line.points.iter().all(|point| is_near(point, &line.points[0]))
    }

    fn is_closed(&self, line: &Line) -> bool {
        match (line.points.first(), line.points.last()) {
            (Some(first), Some(last)) => {
                let middle = scale(add(first.center, last.center), 0.5);
                line.points.len() > 3 && length(sub(first.center, middle)) <= 1e-6 * self.spacing
            }
            _ => false,
        }
    }
}
