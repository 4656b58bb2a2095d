//! Which ring each ring and circle lies in, of curves that have no point in common.
//!
//! A line sweeps over the plane from left to right and keeps the edges that it meets in their order from below (Bentley and
//! Ottmann 1979; without crossings, as Shamos and Hoey 1976). Below the least vertex of a ring, or the centre of a disc, the next edge
//! tells where that is: in the edge's ring, if the ring is above its edge, else where the ring is.

use super::crossings::Curves;
use super::meeting::side_of_circle;
use super::{Figure, Point};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::predicates::{Sign, orient2d};
use crate::sort::{float_key, sort_by_key};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// The vertex of a ring that is least by x, then y; the first of several at one place.
pub(super) fn least_vertex(ring: &[Point]) -> usize {
    let less = |a: &Point, b: &Point| a[0] < b[0] || a[0] == b[0] && a[1] < b[1];
    (1..ring.len()).fold(0, |least, i| if less(&ring[i], &ring[least]) { i } else { least })
}

/// Where a ring turns at its least vertex: positive for a ring without crossings that runs counterclockwise. Of several vertices at that
/// place, as crossing rings may have, most decide, so that a ring that is turned has the other direction.
pub(crate) fn direction(ring: &[Point]) -> Sign {
    let (count, least) = (ring.len(), ring[least_vertex(ring)]);
    let at_least = (0..count).filter(|&i| ring[i] == least);
    let turns =
        at_least.map(|i| orient2d(&ring[(i + count - 1) % count], &least, &ring[(i + 1) % count]));
    Sign::of(turns.map(|turn| f64::from(turn as i8)).sum())
}

/// An edge that is not vertical, or a point, which is one without length.
#[derive(Clone, Copy, Debug)]
struct Strand {
    left: Point,
    right: Point,
    curve: u32,
}

impl Strand {
    fn point(at: Point) -> Self {
        Strand { left: at, right: at, curve: NONE }
    }
}

/// From below, where the sweeping line meets both.
impl Ord for Strand {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.curve == other.curve {
            return Ordering::Equal;
        }
        if self.left[0] < other.left[0] {
            return other.cmp(self).reverse();
        }
        // The left end of this one is where the other is, or they begin together and part.
        let sides = [self.left, self.right].map(|p| orient2d(&other.left, &other.right, &p));
        match sides {
            [Sign::Positive, _] | [Sign::Zero, Sign::Positive] => Ordering::Greater,
            [Sign::Negative, _] | [Sign::Zero, Sign::Negative] => Ordering::Less,
            [Sign::Zero, Sign::Zero] => self.curve.cmp(&other.curve),
        }
    }
}

impl PartialOrd for Strand {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Strand {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Strand {}

/// What happens where the line comes by.
#[derive(Clone, Copy, Debug)]
enum Event {
    /// An edge ends.
    End(u32),
    /// An edge begins.
    Begin(u32),
    /// The least vertex of a ring, this one.
    Ring(u32),
    /// The centre of a circle.
    Circle(u32),
}

impl Event {
    fn place(&self, curves: &Curves<'_>) -> Point {
        match *self {
            Event::End(curve) => strand(curves, curve).right,
            Event::Begin(curve) => strand(curves, curve).left,
            Event::Ring(vertex) => *curves.position(vertex),
            Event::Circle(circle) => centre(curves.figure, circle),
        }
    }
}

/// An edge from left to right.
fn strand(curves: &Curves<'_>, curve: u32) -> Strand {
    let [a, b] = curves.ends(curve).unwrap_or([curve; 2]).map(|v| *curves.position(v));
    let (left, right) = if a[0] <= b[0] { (a, b) } else { (b, a) };
    Strand { left, right, curve }
}

/// The ring in which each ring, then each circle, lies next, or [`NONE`]. Rings in a disc are passed over for its circle.
///
/// No two curves may have a point in common but the vertices between edges. Cost: O(n log n).
pub(super) fn containers(
    curves: &Curves<'_>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let figure = curves.figure;
    let rings = figure.ring_count();
    let events = events(curves, room, run)?;
    let mut directions = room.vec(rings)?;
    for ring in run.watch(0..rings) {
        directions.push(direction(ring_of(figure, ring?)));
    }
    let mut containers = room.filled(rings + figure.circles.len(), NONE)?;
    // The nodes of the set hold half as many strands again as are in use, or twice.
    room.keep(2 * size_of::<Strand>() * figure.vertices.len())?;
    let mut line: BTreeSet<Strand> = BTreeSet::new();
    for event in run.watch(&events) {
        let event = *event?;
        let (place, below) = match event {
            Event::Begin(curve) => {
                line.insert(strand(curves, curve));
                continue;
            }
            Event::End(curve) => {
                line.remove(&strand(curves, curve));
                continue;
            }
            Event::Ring(vertex) => {
                let ring = figure.chain_of(vertex);
                let lower = lower_edge(curves, ring, vertex);
                let probe = lower.unwrap_or(Strand::point(*curves.position(vertex)));
                (ring, line.range(..probe).next_back())
            }
            Event::Circle(circle) => {
                let at = centre(figure, circle);
                let shape = &figure.circles[circle as usize];
                let outside = |s: &&Strand| side_of_circle(&s.left, shape).is_positive();
                let below = line.range(..Strand::point(at)).rev().find(outside);
                (rings + circle as usize, below)
            }
        };
        if let Some(below) = below {
            let ring = figure.chain_of(below.curve);
            let is_forward = *curves.position(below.curve) == below.left;
            let is_above = directions[ring].is_positive() == is_forward;
            containers[place] = if is_above { ring as u32 } else { containers[ring] };
        }
    }
    Ok(containers)
}

/// All events from left to right: at one x the ends, then what begins, then what is asked, from below.
fn events(curves: &Curves<'_>, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<Event>> {
    let figure = curves.figure;
    let rings = figure.ring_count();
    let mut asked = room.vec(rings + figure.circles.len())?;
    for ring in run.watch(0..rings) {
        let ring = ring?;
        let least = least_vertex(ring_of(figure, ring)) as u32;
        asked.push(Event::Ring(figure.range(ring).start + least));
    }
    asked.extend((0..figure.circles.len()).map(|circle| Event::Circle(circle as u32)));
    sort_by_key(&mut asked, |event| float_key(event.place(curves)[1]), run)?;
    let mut events = Vec::new();
    for make in [Event::End as fn(u32) -> Event, Event::Begin] {
        for ring in 0..rings {
            for edge in run.watch(figure.edges(ring)) {
                let edge = edge?;
                let [a, b] = edge.map(|v| curves.position(v)[0]);
                if a != b {
                    room.push(&mut events, make(edge[0]))?;
                }
            }
        }
    }
    room.reserve(&mut events, asked.len())?;
    events.append(&mut asked);
    sort_by_key(&mut events, |event| float_key(event.place(curves)[0]), run)?;
    Ok(events)
}

/// The vertices of a ring.
fn ring_of(figure: &Figure, ring: usize) -> &[Point] {
    let range = figure.range(ring);
    &figure.vertices[range.start as usize..range.end as usize]
}

fn centre(figure: &Figure, circle: u32) -> Point {
    let [x, y, _] = figure.circles[circle as usize];
    [x, y]
}

/// The lower one of the edges that begin at the least vertex of a ring. One of them at least is not vertical.
fn lower_edge(curves: &Curves<'_>, ring: usize, least: u32) -> Option<Strand> {
    let range = curves.figure.range(ring);
    let before = if least == range.start { range.end - 1 } else { least - 1 };
    let edges = [before, least].map(|curve| strand(curves, curve));
    edges.into_iter().filter(|edge| edge.left[0] != edge.right[0]).min()
}
