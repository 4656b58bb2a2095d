//! What is bare of each sphere, away from creases: octahedra, whose triangles are divided until they are covered or small.

use super::exposed::Exposed;
use super::thin::{Kind, Sample, Scale};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::vector::{Vec3, add, dot, length, scale, sub, unit};

/// Samples of all that is bare: of each small triangle whose middle is so.
pub(super) fn samples(
    exposed: &Exposed,
    sizes: Scale,
    samples: &mut Vec<Sample>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<()> {
    let found = run.in_steps(exposed.parts(), [0.3, 0.8], |range| {
        let mut room = Room::new(run);
        let mut found = Vec::new();
        for vertex in range.start as u32..range.end as u32 {
            run.poll()?;
            if let Some(ball) = exposed.number(vertex) {
                let patch = Patch::new(exposed, vertex, ball, sizes);
                let caps: Vec<u32> = (0..patch.caps.len() as u32).collect();
                for signs in 0..8 {
                    let sign = |k: usize| if signs >> k & 1 == 0 { 1.0 } else { -1.0 };
                    let octant = [[sign(0), 0.0, 0.0], [0.0, sign(1), 0.0], [0.0, 0.0, sign(2)]];
                    patch.sample(octant, &caps, &mut found, &mut room, run)?;
                }
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

/// What another ball covers of a sphere: the directions with more than this cosine to an axis.
struct Cap {
    axis: Vec3,
    cosine: f64,
    sine: f64,
}

/// A ball next to a sphere that is sampled finer, and its spacing.
struct Finer {
    center: Vec3,
    radius: f64,
    spacing: f64,
}

/// A sphere with the caps that others cover.
struct Patch {
    center: Vec3,
    radius: f64,
    ball: u32,
    sizes: Scale,
    spacing: f64,
    caps: Vec<Cap>,
    finer: Vec<Finer>,
}

impl Patch {
    fn new(exposed: &Exposed, vertex: u32, ball: u32, sizes: Scale) -> Self {
        let (center, radius) = exposed.ball(vertex);
        let spacing = sizes.spacing(sizes.level(radius));
        let (mut caps, mut finer) = (Vec::new(), Vec::new());
        for &other in exposed.others(vertex) {
            let (c, r) = exposed.ball(other);
            let way = sub(c, center);
            let distance = length(way);
            let height = 0.5 * (distance + (radius - r) * (radius + r) / distance);
            let cosine = (height / radius).clamp(-1.0, 1.0);
            let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
            caps.push(Cap { axis: scale(way, 1.0 / distance), cosine, sine });
            let its = sizes.spacing(sizes.level(r));
            if its < spacing {
                finer.push(Finer { center: c, radius: r, spacing: its });
            }
        }
        Patch { center, radius, ball, sizes, spacing, caps, finer }
    }

    /// The spacing at a point: next to finer balls it grows from theirs by half the distance.
    fn spacing_at(&self, p: Vec3) -> f64 {
        let near = |ball: &Finer| {
            let distance = length(sub(p, ball.center)) - ball.radius;
            ball.spacing + 0.5 * distance.max(0.0)
        };
        self.finer.iter().map(near).fold(self.spacing, f64::min)
    }

    /// Samples what no cap covers of a triangle on the unit sphere, given the caps that may meet it.
    fn sample(
        &self,
        [a, b, c]: [Vec3; 3],
        caps: &[u32],
        found: &mut Vec<Sample>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        // All of the triangle is within this of its middle.
        let middle = unit(add(add(a, b), c));
        let reach = [a, b, c].iter().map(|&p| length(sub(p, middle))).fold(0.0, f64::max);
        let (cosine, sine) =
            (1.0 - 0.5 * reach * reach, reach * (1.0 - 0.25 * reach * reach).sqrt());
        let mut met = Vec::new();
        for &number in caps {
            let cap = &self.caps[number as usize];
            let height = dot(cap.axis, middle);
            let (even, odd) = (cap.cosine * cosine, cap.sine * sine);
            if cap.cosine <= cosine && height >= even + odd {
                return Ok(());
            }
            if cap.cosine <= -cosine || height > even - odd {
                met.push(number);
            }
        }
        let point = add(self.center, scale(middle, self.radius));
        let spacing = self.spacing_at(point);
        if 3.0 * reach * self.radius > spacing {
            run.poll()?;
            let [d, e, f] = [add(a, b), add(b, c), add(c, a)].map(unit);
            for quarter in [[a, d, f], [d, b, e], [f, e, c], [d, e, f]] {
                self.sample(quarter, &met, found, room, run)?;
            }
            return Ok(());
        }
        let is_bare = |&cap: &u32| {
            let cap = &self.caps[cap as usize];
            dot(cap.axis, middle) <= cap.cosine
        };
        if met.iter().all(is_bare) {
            let level = self.sizes.level(spacing);
            room.push(found, Sample { point, ball: self.ball, level, kind: Kind::Patch })?;
        }
        Ok(())
    }
}
