//! Where two spheres meet: the arcs of their circle that no third ball covers, and their ends, where three spheres meet.

use super::exposed::Exposed;
use super::thin::{Kind, Sample, Scale};
use crate::error::Result;
use crate::job::{Room, Run, parts_of};
use crate::vector::{Vec3, add, cross, dot, scale, sub, unit};
use std::f64::consts::TAU;

/// The edges between two reports.
const EDGES: usize = 256;

/// Samples of all arcs, at most a quarter of the spacing apart, and their ends.
pub(super) fn samples(
    exposed: &Exposed,
    sizes: Scale,
    samples: &mut Vec<Sample>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<()> {
    let parts = parts_of(EDGES, exposed.edges.ends.len());
    let found = run.in_steps(parts, [0.0, 0.3], |range| {
        run.poll()?;
        let mut room = Room::new(run);
        let (mut found, mut ring, mut link, mut covered) = (vec![], vec![], vec![], vec![]);
        for edge in range {
            let ends = exposed.edges.ends[edge];
            let [Some(a), Some(b)] = ends.map(|v| exposed.number(v)) else { continue };
            let t = &exposed.triangulation;
            t.ring(exposed.edges.cells[edge], ends[0], ends[1], &mut ring);
            link.clear();
            link.extend(ring.iter().flat_map(|&cell| t.cells()[cell as usize]));
            link.retain(|v| !ends.contains(v));
            link.sort_unstable();
            link.dedup();
            let circle = Circle::new(ends.map(|v| exposed.ball(v)));
            circle.cover(exposed, &link, &mut covered);
            let ball = a.min(b);
            let level = ends.map(|v| sizes.level(exposed.ball(v).1));
            let level = level[0].max(level[1]);
            let mut push = |kind, angle: f64, level| {
                let point = circle.at(angle);
                room.push(&mut found, Sample { point, ball, level, kind })
            };
            let step = 0.25 * sizes.spacing(level) / circle.radius;
            let mut arc = |begin: f64, end: f64, is_open: bool| -> Result<()> {
                let least = if is_open { 1.0 } else { 3.0 };
                let steps = ((end - begin) / step).ceil().max(least);
                for i in u64::from(is_open)..steps as u64 {
                    push(Kind::Crease, begin + (end - begin) * i as f64 / steps, level)?;
                }
                Ok(())
            };
            if covered.is_empty() {
                arc(0.0, TAU, false)?;
            }
            let mut triple = Vec::new();
            for (i, last) in covered.iter().enumerate() {
                let next = covered.get(i + 1).unwrap_or(&covered[0]);
                let turn = if i + 1 < covered.len() { 0.0 } else { TAU };
                let (begin, end) = (last.end, next.begin + turn);
                if begin < end {
                    arc(begin, end, true)?;
                    triple.extend([(begin, last.balls[1]), (end, next.balls[0])]);
                }
            }
            for (angle, third) in triple {
                push(Kind::Corner, angle, level.max(sizes.level(exposed.ball(third).1)))?;
            }
        }
        Ok((found, room))
    })?;
    for (found, _room) in found {
        run.poll()?;
        room.grow(samples, found.len())?;
        samples.extend(found);
    }
    Ok(())
}

/// The circle in which two spheres meet.
struct Circle {
    center: Vec3,
    radius: f64,
    axes: [Vec3; 2],
}

impl Circle {
    /// That of two spheres that cut each other.
    fn new([(c, r), (d, s)]: [(Vec3, f64); 2]) -> Self {
        let way = sub(d, c);
        let distance_squared = dot(way, way);
        // The share of the way at which both powers are the same.
        let share = 0.5 + 0.5 * (r - s) * (r + s) / distance_squared;
        let height = share * distance_squared.sqrt();
        let radius = ((r - height) * (r + height)).max(0.0).sqrt();
        let least = (0..3).min_by(|&i, &j| way[i].abs().total_cmp(&way[j].abs())).unwrap_or(0);
        let mut other = [0.0; 3];
        other[least] = 1.0;
        let first = unit(cross(way, other));
        let second = unit(cross(way, first));
        Circle { center: add(c, scale(way, share)), radius, axes: [first, second] }
    }

    fn at(&self, angle: f64) -> Vec3 {
        let [x, y] = [libm::cos(angle), libm::sin(angle)].map(|x| self.radius * x);
        add(self.center, add(scale(self.axes[0], x), scale(self.axes[1], y)))
    }

    /// What the balls of some vertices cover: disjoint arcs, ascending. Of what is covered whole there is one of more than a turn.
    fn cover(&self, exposed: &Exposed, link: &[u32], covered: &mut Vec<Arc>) {
        covered.clear();
        for &vertex in link {
            let (center, radius) = exposed.ball(vertex);
            let way = sub(center, self.center);
            let [x, y] = self.axes.map(|axis| dot(axis, way));
            let distance = dot(way, way).sqrt();
            // Inside is where the cosine of the angle from the nearest point of the circle is more than power / reach.
            let power = (distance - radius) * (distance + radius) + self.radius * self.radius;
            let reach = 2.0 * self.radius * (x * x + y * y).sqrt();
            let mut push = |begin, end| covered.push(Arc { begin, end, balls: [vertex; 2] });
            if power >= reach {
                continue;
            }
            if power <= -reach {
                push(0.0, 2.0 * TAU);
                continue;
            }
            let (half, middle) = (libm::acos(power / reach), libm::atan2(y, x));
            let begin = (middle - half).rem_euclid(TAU);
            let end = begin + 2.0 * half;
            push(begin, end.min(TAU));
            if end > TAU {
                push(0.0, end - TAU);
            }
        }
        covered.sort_by(|a, b| a.begin.total_cmp(&b.begin));
        // Arcs that overlap become one, which begins as the first does and ends as the farthest.
        let mut count = 0;
        for i in 0..covered.len() {
            let next = covered[i];
            match covered[..count].last_mut() {
                Some(last) if next.begin <= last.end => {
                    if next.end > last.end {
                        (last.end, last.balls[1]) = (next.end, next.balls[1]);
                    }
                }
                _ => {
                    covered[count] = next;
                    count += 1;
                }
            }
        }
        covered.truncate(count);
    }
}

/// A covered arc, and the vertices whose balls end it at either end.
#[derive(Clone, Copy, Debug)]
struct Arc {
    begin: f64,
    end: f64,
    balls: [u32; 2],
}
