//! Where Voronoi vertices lie as seen from the samples: the cocones, and the Voronoi edges that meet them.

use crate::dual::{Dual, offsets, unit};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run, parts};
use crate::poles::{Selection, TangentPlane, seen_from};
use crate::vector::{Vec3, dot, sub};

/// Where a point lies, seen from a sample p with pole vector v: towards v or away from it, within the double cone
/// about v or outside of it, in the *cocone*.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Place {
    /// In the cone about v.
    Up,
    /// In the cocone, not below the plane through p that v is normal to.
    High,
    /// In the cocone, below that plane.
    Low,
    /// In the cone about -v.
    Down,
}

impl Place {
    /// Whether the point lies in the half space below the tangent plane.
    pub(super) fn is_below(self) -> bool {
        matches!(self, Place::Low | Place::Down)
    }
}

/// Whether the segment between two points meets the cocone.
///
/// Each cone is convex, being narrower than a half space, and so holds the whole of a segment with both ends in it. Any other segment has an end in the
/// cocone or goes from one cone to the other, which meet at the sample only. So the ends tell everything, also of a ray, whose
/// other end is its direction.
pub(super) fn meets(ends: [Place; 2]) -> bool {
    !matches!(ends, [Place::Up, Place::Up] | [Place::Down, Place::Down])
}

/// The places of all Voronoi vertices, seen from the samples whose cells they are corners of.
pub(super) struct Cones<'a> {
    pub(super) dual: &'a Dual,
    pub(super) poles: &'a Selection,
    /// The sine of the cocone's angle: what lies in it has a cosine to v of at most this.
    sine: f64,
    /// For each cell the place of its centre, seen from each of its vertices.
    places: Vec<[Place; 4]>,
}

impl<'a> Cones<'a> {
    /// Given the sine of the angle. Cost: O(m).
    pub(super) fn new(
        dual: &'a Dual,
        poles: &'a Selection,
        sine: f64,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let t = dual.triangulation();
        let mut places = room.filled(t.cells().len(), [Place::High; 4])?;
        let chunks = places.chunks_mut(PART).zip(parts(t.cells().len())).collect();
        run.in_steps(chunks, [0.7, 0.8], |(places, range)| {
            for (places, cell) in places.iter_mut().zip(range) {
                if cell % 1024 == 0 {
                    run.poll()?;
                }
                for (place, sample) in places.iter_mut().zip(t.cells()[cell]) {
                    let cosine = match offset(dual, sample, cell as u32) {
                        [0.0, 0.0, 0.0] => 0.0,
                        offset => dot(unit(offset), poles.normals[sample as usize]),
                    };
                    *place = if cosine > sine {
                        Place::Up
                    } else if cosine < -sine {
                        Place::Down
                    } else if is_below(dual, poles, sample as usize, cell as u32, cosine) {
                        Place::Low
                    } else {
                        Place::High
                    };
                }
            }
            Ok(())
        })?;
        Ok(Cones { dual, poles, sine, places })
    }

    /// The places of the two ends of the Voronoi edge dual to a facet, seen from one of the facet's vertices.
    pub(super) fn ends(&self, cell: u32, facet: usize, sample: u32) -> [Place; 2] {
        let t = self.dual.triangulation();
        let place = |cell: u32| {
            let slot = t.cells()[cell as usize].iter().position(|&v| v == sample);
            self.places[cell as usize][slot.unwrap_or(0)]
        };
        let other = match t.neighbors()[cell as usize][facet] {
            NONE => self.place_of_ray(cell, facet, sample),
            neighbor => place(neighbor),
        };
        [place(cell), other]
    }

    /// Whether the Voronoi edge dual to a facet meets the cocone of one of the facet's vertices.
    pub(super) fn meets(&self, cell: u32, facet: usize, sample: u32) -> bool {
        meets(self.ends(cell, facet, sample))
    }

    /// The place of the far end of a ray.
    fn place_of_ray(&self, cell: u32, facet: usize, sample: u32) -> Place {
        let ray = self.dual.rays().of_facet(cell, facet as u32);
        let direction = self.dual.rays().directions().get(ray as usize);
        let cosine =
            direction.map_or(0.0, |&direction| dot(direction, self.poles.normals[sample as usize]));
        if cosine > self.sine {
            Place::Up
        } else if cosine < -self.sine {
            Place::Down
        } else if cosine < 0.0 {
            Place::Low
        } else {
            Place::High
        }
    }

    /// The squared distance to the farthest corner of the sample's tangent polygon, where the plane through the sample that its
    /// pole vector is normal to cuts its Voronoi cell; infinite where that is unbounded. Given the cells of the sample.
    pub(super) fn width_squared(&self, sample: u32, cells: &[u32]) -> f64 {
        let t = self.dual.triangulation();
        let normal = self.poles.normals[sample as usize];
        let mut width: f64 = 0.0;
        // Where some rays go up and others down, the polygon is unbounded between them.
        let mut far = [false; 2];
        for &cell in cells {
            let corners = t.cells()[cell as usize];
            for facet in (0..4).filter(|&i| corners[i] != sample) {
                let neighbor = t.neighbors()[cell as usize][facet];
                // Every bounded edge is met in both of its cells.
                if neighbor != NONE && neighbor < cell {
                    continue;
                }
                let [a, b] = self.ends(cell, facet, sample);
                if neighbor == NONE {
                    far[usize::from(b.is_below())] = true;
                    if far == [true; 2] {
                        return f64::INFINITY;
                    }
                }
                if a.is_below() == b.is_below() {
                    if neighbor == NONE && matches!(b, Place::High | Place::Low) {
                        // A ray nearly in the plane.
                        width = f64::INFINITY;
                    }
                    continue;
                }
                let near = offset(self.dual, sample, cell);
                let along = match neighbor {
                    NONE => {
                        let ray = self.dual.rays().of_facet(cell, facet as u32) as usize;
                        self.dual.rays().directions().get(ray).copied().unwrap_or([0.0; 3])
                    }
                    neighbor => sub(offset(self.dual, sample, neighbor), near),
                };
                let (height, slope) = (dot(near, normal), dot(along, normal));
                // The signs are exact, the heights are not.
                let step = if slope == 0.0 { 0.0 } else { (-height / slope).max(0.0) };
                let step = if neighbor == NONE { step } else { step.min(1.0) };
                let place = [0, 1, 2].map(|k| near[k] + step * along[k]);
                width = width.max(dot(place, place));
            }
        }
        width
    }

    /// Whether the pole vectors of two samples make at most the angle of this cosine, up to their signs.
    pub(super) fn is_parallel(&self, p: u32, q: u32, cosine: f64) -> bool {
        let normals = &self.poles.normals;
        dot(normals[p as usize], normals[q as usize]).abs() >= cosine
    }
}

/// The centre of a cell less a vertex of it.
pub(super) fn offset(dual: &Dual, sample: u32, cell: u32) -> Vec3 {
    let center = dual.centers()[cell as usize];
    let offset = sub(center, dual.triangulation().coords()[sample as usize]);
    let largest = |v: Vec3| v.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    // Of what is much nearer than it is far from the origin the rounded centre tells too little.
    if largest(center) < f64::MAX && largest(offset) > largest(center) * 1e-9 {
        return offset;
    }
    let [exact] = offsets(&[seen_from(dual.triangulation(), sample, cell)]);
    exact.unwrap_or(offset)
}

/// Whether the exact centre lies below the tangent plane: (c - p) . v < 0.
fn is_below(dual: &Dual, poles: &Selection, sample: usize, cell: u32, cosine: f64) -> bool {
    // A rounded cosine is off by less than this: the offset is right to some 1e-7.
    if cosine.abs() > 1e-5 {
        return cosine < 0.0;
    }
    let plane = TangentPlane::new(dual, sample, poles.first[sample], poles.normals[sample]);
    plane.is_below(dual, sample as u32, cell)
}
