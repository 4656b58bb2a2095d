//! Places of the inner vertices at which no element is folded.
//!
//! The Voronoi vertex of an inner cell may lie where an element that has it is turned inside out (Shaham, Shamir, Cohen-Or, figure 2), or outside the box of the samples; those outside begin at the centre of
//! the sphere *in* their cell. Then vertices of what is turned are moved one at a time ([`moves`]), each to where nothing that has it is turned, or less is: where it may be is bounded by a plane for each
//! tetrahedron that it is a corner of. What is stuck begins anew with the vertices round it, and an attempt that helps nothing is
//! taken back ([`unfold`]). If all else fails, vertices go step by step to the centres of the spheres in their cells. In the end each goes back as far as may be.
//!
//! At these every element is right, whatever the solid: the vertex is inside its cell, so before all triangles of the surface that the cell has; it lies in the plane that halves each dihedral angle of the
//! cell, so that from one cell to the next round an edge it turns by half the sum of their angles, less than half a turn. So do the pyramids over a facet, once that is divided into triangles round a
//! point of its edge. Hence the mending ends, and always succeeds.

mod moves;
mod unfold;

use super::parts::Parts;
use crate::dual::Dual;
use crate::error::Result;
use crate::job::{Room, Run, parts};
use crate::points::COORDINATE_MIN;
use crate::predicates::orient3d;
use crate::vector::{Vec3, add, cross, length, scale, sub};

/// The planes that are looked at, at most, besides so many a cell.
const PLANES: usize = 1_000_000;
const PLANES_A_CELL: usize = 100;

/// The inner vertices: those of the inner cells, and one in the middle of each facet that has a vertex which was moved.
pub(super) struct Mended<'a> {
    dual: &'a Dual,
    parts: &'a Parts,
    /// Where they are, those of the cells first; whether they were moved; how often that was tried, while it is.
    places: Vec<Vec3>,
    is_moved: Vec<bool>,
    tries: Vec<u8>,
    /// What was before each move: which vertex, where it was, whether it had been moved.
    was: Vec<(u32, Vec3, bool)>,
    /// How many planes may still be looked at in search of places: without a bound, what is stuck would be tried in all ways, each of which goes on as far as it helps.
    planes_left: usize,
}

/// What consists of elements.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    Triangle(u32),
    Fan(u32),
    Facet(u32),
}

/// A corner of a tetrahedron: a sample, or an inner vertex.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Corner {
    Sample(u32),
    Inner(u32),
}

impl<'a> Mended<'a> {
    pub fn new(
        dual: &'a Dual,
        parts_of: &'a Parts,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let (cells, facets) = (parts_of.cells.len(), parts_of.facets.len());
        let mut its = Mended {
            dual,
            parts: parts_of,
            places: room.vec(cells + facets)?,
            is_moved: room.filled(cells + facets, false)?,
            tries: room.filled(cells + facets, 0)?,
            was: Vec::new(),
            planes_left: PLANES + PLANES_A_CELL * cells,
        };
        its.begin(run)?;
        let folded = its.folded_at_first(run)?;
        its.unfold(folded, room, run)?;
        Ok(its)
    }

    /// Whether an inner cell's vertex is not its Voronoi vertex.
    pub fn is_moved(&self, cell: u32) -> bool {
        self.is_moved[cell as usize]
    }

    /// Whether the vertices of two inner cells next to each other are one and the same.
    pub fn are_one(&self, a: u32, b: u32) -> bool {
        let sphere = &self.parts.sphere;
        !self.is_moved(a) && !self.is_moved(b) && sphere[a as usize] == sphere[b as usize]
    }

    /// Where the vertex of an inner cell is.
    pub fn place(&self, cell: u32) -> Vec3 {
        self.places[cell as usize]
    }

    /// Whether a facet has a vertex in its middle.
    pub fn has_middle(&self, facet: u32) -> bool {
        self.parts.rings.row(facet as usize).iter().any(|&cell| self.is_moved(cell))
    }

    /// Where that is.
    pub fn middle(&self, facet: u32) -> Vec3 {
        self.places[self.middle_of(facet) as usize]
    }

    fn middle_of(&self, facet: u32) -> u32 {
        self.parts.cells.len() as u32 + facet
    }

    fn sample(&self, v: u32) -> Vec3 {
        self.dual.triangulation().coords()[v as usize]
    }

    fn at(&self, corner: Corner) -> Vec3 {
        match corner {
            Corner::Sample(v) => self.sample(v),
            Corner::Inner(v) => self.places[v as usize],
        }
    }

    fn is_in_box(&self, p: Vec3) -> bool {
        let bounds = self.dual.triangulation().points().bounds();
        (0..3).all(|k| bounds.min[k] <= p[k] && p[k] <= bounds.max[k])
    }

    /// Voronoi vertices, but for those outside the box of the samples, where there is no solid, nor are there bounds for coordinates.
    fn begin(&mut self, run: &Run<'_>) -> Result<()> {
        for cell in run.watch(0..self.parts.cells.len()) {
            let cell = cell?;
            let center = self.dual.centers()[self.parts.cells[cell] as usize];
            self.is_moved[cell] = !self.is_in_box(center);
            let place = if self.is_moved[cell] { self.target(cell as u32) } else { center };
            self.places.push(place);
        }
        for facet in run.watch(0..self.parts.facets.len()) {
            let ring = self.parts.rings.row(facet?);
            let sum = ring.iter().fold([0.0; 3], |sum, &cell| add(sum, self.place(cell)));
            self.places.push(tidy(scale(sum, 1.0 / ring.len() as f64)));
        }
        Ok(())
    }

    /// Where the vertex of an inner cell should be: its Voronoi vertex, or, where that is outside the box, the last place in it on the way there from its target.
    fn home(&self, cell: u32) -> Vec3 {
        let center = self.dual.centers()[self.parts.cells[cell as usize] as usize];
        if self.is_in_box(center) {
            return center;
        }
        let bounds = self.dual.triangulation().points().bounds();
        let target = self.target(cell);
        let leaves = (0..3).map(|k| {
            let end = center[k].clamp(bounds.min[k], bounds.max[k]);
            if end == center[k] { 1.0 } else { (end - target[k]) / (center[k] - target[k]) }
        });
        let share = leaves.fold(1.0, f64::min).max(0.0);
        let place = tidy(between(target, center, share));
        [0, 1, 2].map(|k| place[k].clamp(bounds.min[k], bounds.max[k]))
    }

    /// Where a vertex makes everything right, together with the others there: the centre of the sphere in its cell, the middle of its facet's edge.
    fn target(&self, vertex: u32) -> Vec3 {
        match self.parts.cells.get(vertex as usize) {
            Some(&cell) => {
                let corners = self.dual.triangulation().cells()[cell as usize];
                tidy(incenter(corners.map(|v| self.sample(v))))
            }
            None => {
                let facet = vertex as usize - self.parts.cells.len();
                let [a, b] = self.parts.facets[facet].map(|v| self.sample(v));
                tidy(scale(add(a, b), 0.5))
            }
        }
    }

    /// What is folded where nothing has been mended.
    fn folded_at_first(&self, run: &Run<'_>) -> Result<Vec<Part>> {
        type Of = fn(u32) -> Part;
        let counts = [
            (self.parts.triangles.len(), Part::Triangle as Of),
            (self.parts.edges.len(), Part::Fan as Of),
            (self.parts.facets.len(), Part::Facet as Of),
        ];
        let all = counts
            .into_iter()
            .flat_map(|(count, of)| parts(count).into_iter().map(move |range| (range, of)));
        let found = run.in_steps(all.collect(), [0.1, 0.4], |(range, of)| {
            run.poll()?;
            let all = range.map(|i| of(i as u32));
            Ok(all.filter(|&part| self.is_folded(part)).collect::<Vec<_>>())
        })?;
        Ok(found.concat())
    }

    /// Moves a vertex.
    fn put(&mut self, vertex: u32, place: Vec3) {
        let v = vertex as usize;
        self.was.push((vertex, self.places[v], self.is_moved[v]));
        (self.places[v], self.is_moved[v]) = (place, true);
    }

    /// Moves a vertex to where it was before anything was mended; that in the middle of a facet stays.
    fn put_back(&mut self, cell: u32) {
        if cell as usize >= self.parts.cells.len() {
            return;
        }
        let center = self.dual.centers()[self.parts.cells[cell as usize] as usize];
        let is_inside = self.is_in_box(center);
        self.put(cell, if is_inside { center } else { self.target(cell) });
        self.is_moved[cell as usize] = !is_inside;
    }

    /// The cells that a part has.
    fn cells_of(&self, part: Part) -> impl Iterator<Item = u32> + use<'_> {
        let row = match part {
            Part::Triangle(i) => &self.parts.behind[i as usize..=i as usize],
            Part::Fan(i) => self.parts.fans.row(i as usize),
            Part::Facet(i) => self.parts.rings.row(i as usize),
        };
        row.iter().copied()
    }

    /// All that has a vertex.
    fn parts_at(&self, vertex: u32) -> Vec<Part> {
        let (cells, facets) = (self.parts.cells.len() as u32, self.parts.facets.len() as u32);
        if vertex >= cells {
            return vec![Part::Facet(vertex - cells)];
        }
        let rows = self.parts.of_cell.row(vertex as usize).iter();
        let rows = rows.map(move |&row| match row < facets {
            true => Part::Facet(row),
            false => Part::Fan(row - facets),
        });
        // Triangles ascend with the cells behind them.
        let behind = &self.parts.behind;
        let first = behind.partition_point(|&other| other < vertex);
        let triangles = (first..behind.len()).take_while(move |&i| behind[i] == vertex);
        rows.chain(triangles.map(|i| Part::Triangle(i as u32))).collect()
    }

    fn folded_at(&self, vertices: &[u32]) -> Vec<Part> {
        let mut all: Vec<Part> = vertices.iter().flat_map(|&v| self.parts_at(v)).collect();
        all.sort_unstable();
        all.dedup();
        all.retain(|&part| self.is_folded(part));
        all
    }

    /// The tetrahedra of a part, positively oriented where nothing is folded. Of a facet without a middle there are none: its samples are inside their Voronoi cells.
    fn tetrahedra(&self, part: Part, visit: &mut impl FnMut([Corner; 4])) {
        use Corner::{Inner, Sample};
        match part {
            Part::Triangle(i) => {
                let [p, q, r] = self.parts.triangles[i as usize].map(Sample);
                visit([Inner(self.parts.behind[i as usize]), p, q, r]);
            }
            Part::Fan(i) => {
                let [a, b] = self.parts.edges[i as usize].map(Sample);
                for pair in self.parts.fans.row(i as usize).windows(2) {
                    if !self.are_one(pair[0], pair[1]) {
                        visit([a, b, Inner(pair[0]), Inner(pair[1])]);
                    }
                }
            }
            Part::Facet(i) if self.has_middle(i) => {
                let [a, b] = self.parts.facets[i as usize].map(Sample);
                let ring = self.parts.rings.row(i as usize);
                let middle = Inner(self.middle_of(i));
                let sides = ring.iter().zip(ring.iter().cycle().skip(1));
                let sides = sides.filter(|&(&c, &d)| !self.are_one(c, d));
                if sides.clone().count() >= 3 {
                    for (&c, &d) in sides {
                        visit([a, middle, Inner(c), Inner(d)]);
                        visit([b, middle, Inner(d), Inner(c)]);
                    }
                }
            }
            Part::Facet(_) => {}
        }
    }

    fn is_turned(&self, corners: [Corner; 4]) -> bool {
        let [a, b, c, d] = corners.map(|corner| self.at(corner));
        orient3d(&a, &b, &c, &d).is_negative()
    }

    fn is_folded(&self, part: Part) -> bool {
        let mut is_folded = false;
        self.tetrahedra(part, &mut |corners| is_folded = is_folded || self.is_turned(corners));
        is_folded
    }

    /// The inner vertices of the tetrahedra of a part that are turned.
    fn turned_vertices(&self, part: Part) -> Vec<u32> {
        let mut vertices = Vec::new();
        self.tetrahedra(part, &mut |corners| {
            if self.is_turned(corners) {
                vertices.extend(corners.iter().filter_map(|corner| match corner {
                    Corner::Inner(v) => Some(*v),
                    Corner::Sample(_) => None,
                }));
            }
        });
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }
}

/// A point at a share of the way from one to another.
fn between(from: Vec3, to: Vec3, share: f64) -> Vec3 {
    match share {
        0.0 => from,
        1.0 => to,
        share => [0, 1, 2].map(|k| from[k] * (1.0 - share) + to[k] * share),
    }
}

/// The same without what is too small for predicates.
fn tidy(p: Vec3) -> Vec3 {
    p.map(|x| if x.abs() < COORDINATE_MIN { 0.0 } else { x })
}

/// The centre of the sphere in a tetrahedron: the mean of its corners, each as heavy as the facet opposite is large.
fn incenter([p, q, r, s]: [Vec3; 4]) -> Vec3 {
    let area = |a: Vec3, b: Vec3, c: Vec3| length(cross(sub(b, a), sub(c, a)));
    let heavy = [(q, r, s), (p, r, s), (p, q, s), (p, q, r)].map(|(a, b, c)| area(a, b, c));
    let sum: f64 = heavy.iter().sum();
    // From a corner, so that little is lost far from the origin.
    let away = [q, r, s]
        .into_iter()
        .zip(&heavy[1..])
        .fold([0.0; 3], |away, (corner, heavy)| add(away, scale(sub(corner, p), heavy / sum)));
    add(p, away)
}
