//! Places of the inner vertices at which no element is folded.
//!
//! The Voronoi vertex of an inner cell may lie where an element that has it is turned inside out (Shaham, Shamir, Cohen-Or, figure 2). Where that can be mended by moving one vertex, it is moved: where it may be
//! is bounded by a plane for each tetrahedron that it is a corner of. What is left is moved step by step towards the centre of the sphere *in* its cell.
//!
//! There every element is right, whatever the solid: the vertex is inside its cell, so before all triangles of the surface that the cell has; it lies in the plane that halves each dihedral angle of the
//! cell, so that from one cell to the next round an edge it turns by half the sum of their angles, less than half a turn. So do the pyramids over a facet, once that is divided into triangles round a
//! point of its edge. Hence the mending ends, and always succeeds.

use super::parts::Parts;
use crate::dual::Dual;
use crate::error::Result;
use crate::job::{Room, Run, parts};
use crate::points::COORDINATE_MIN;
use crate::predicates::orient3d;
use crate::vector::{Vec3, add, cross, dot, length, scale, sub};

/// The steps to the place where everything is right.
const STEPS: u8 = 16;
/// How often the parts that are folded are gone through before any vertex goes a step.
const PASSES: usize = 3;
/// How often a vertex is moved alone.
const TRIES: u8 = 12;
/// How far from its Voronoi vertex a vertex stays that goes back there as far as may be.
const BACK: [f64; 8] = [0.0, 0.03125, 0.0625, 0.125, 0.25, 0.5, 0.75, 0.875];
/// How often a vertex is moved to the other side of a plane.
const MOVES: usize = 200;
/// How far beyond a plane it is moved, as a share of how far it was on the wrong side: so it comes to where it may be in finitely many moves (Motzkin, Schoenberg 1954, *The relaxation method for
/// linear inequalities*).
const BEYOND: f64 = 0.5;

/// The inner vertices: those of the inner cells, and one in the middle of each facet that has a vertex which was moved.
pub(super) struct Mended<'a> {
    dual: &'a Dual,
    parts: &'a Parts,
    /// Where they are, those of the cells first; whether they were moved; how often that was tried for them alone, and the steps that they have gone.
    places: Vec<Vec3>,
    is_moved: Vec<bool>,
    tries: Vec<u8>,
    steps: Vec<u8>,
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
            steps: room.filled(cells + facets, 0)?,
        };
        its.begin(run)?;
        let folded = its.folded_at_first(run)?;
        let touched = its.unfold(folded, room, run)?;
        its.go_back(&touched, run)?;
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
        let bounds = self.dual.triangulation().points().bounds();
        for cell in run.watch(0..self.parts.cells.len()) {
            let cell = cell?;
            let center = self.dual.centers()[self.parts.cells[cell] as usize];
            let mut place = center;
            if !self.is_in_box(center) {
                // On the way inward, just where it comes into the box.
                let target = self.target(cell as u32);
                let enters = (0..3).map(|k| {
                    let end = center[k].clamp(bounds.min[k], bounds.max[k]);
                    if end == center[k] { 1.0 } else { (end - target[k]) / (center[k] - target[k]) }
                });
                let share = enters.fold(1.0, f64::min).max(0.0);
                place = between(target, center, share);
                self.is_moved[cell] = true;
            }
            self.places.push(place);
        }
        for facet in run.watch(0..self.parts.facets.len()) {
            let ring = self.parts.rings.row(facet?);
            let sum = ring.iter().fold([0.0; 3], |sum, &cell| add(sum, self.place(cell)));
            self.places.push(tidy(scale(sum, 1.0 / ring.len() as f64)));
        }
        Ok(())
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

    /// Moves vertices of what is folded until nothing is: one, where that mends a part; else all that are turned, a step towards their targets. Returns those that were moved.
    ///
    /// It ends, since each vertex is tried alone so often at most, and then goes so many steps.
    fn unfold(
        &mut self,
        mut folded: Vec<Part>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<u32>> {
        let mut all = Vec::new();
        for pass in 0.. {
            if folded.is_empty() {
                break;
            }
            let mut touched = Vec::new();
            for part in folded {
                run.poll()?;
                let mut vertices = self.turned_vertices(part);
                if vertices.is_empty() {
                    continue;
                }
                // First what is folded most.
                vertices.sort_by_cached_key(|&v| (usize::MAX - self.folded_at(&[v]).len(), v));
                if let Some(&vertex) = vertices.iter().find(|&&vertex| self.move_one(vertex)) {
                    room.push(&mut touched, vertex)?;
                } else if pass < PASSES {
                    room.grow(&mut touched, vertices.len())?;
                    touched.extend(vertices);
                } else {
                    // What cannot go on is as right as rounding lets it be.
                    vertices.retain(|&v| self.steps[v as usize] < STEPS);
                    // The middle of a facet goes first.
                    let is_cell = |&v: &u32| (v as usize) < self.parts.cells.len();
                    if !vertices.iter().all(is_cell) {
                        vertices.retain(|v| !is_cell(v));
                    }
                    vertices.iter().for_each(|&vertex| self.step(vertex));
                    room.grow(&mut touched, vertices.len())?;
                    touched.extend(vertices);
                }
            }
            folded = self.folded_at(&touched);
            room.grow(&mut all, touched.len())?;
            all.extend(touched);
        }
        all.sort_unstable();
        all.dedup();
        Ok(all)
    }

    /// Moves a vertex to where nothing that has it is folded, or leaves it where it is. Whether it was moved.
    fn move_one(&mut self, vertex: u32) -> bool {
        let v = vertex as usize;
        if self.tries[v] >= TRIES || self.steps[v] >= STEPS {
            return false;
        }
        self.tries[v] += 1;
        let (place, was_moved) = (self.places[v], self.is_moved[v]);
        self.is_moved[v] = true;
        let at = self.parts_at(vertex);
        let mut planes: Vec<(Vec3, f64)> = Vec::new();
        for &part in &at {
            self.tetrahedra(part, &mut |corners| planes.extend(self.plane(corners, vertex)));
        }
        let found = relaxed(place, &planes).map(tidy);
        self.places[v] = found.unwrap_or(place);
        let is_right = found.is_some() && !at.iter().any(|&part| self.is_folded(part));
        if !is_right {
            (self.places[v], self.is_moved[v]) = (place, was_moved);
        }
        is_right
    }

    /// The plane that a corner of a tetrahedron must lie behind: its normal out of it, of length 1, and how far it is from the origin along that.
    fn plane(&self, corners: [Corner; 4], vertex: u32) -> Option<(Vec3, f64)> {
        let own = corners.iter().position(|&corner| corner == Corner::Inner(vertex))?;
        // The others, so that they turn counterclockwise seen from the side where the corner is not.
        let [p, q, r] =
            [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]][own].map(|i| self.at(corners[i]));
        let normal = cross(sub(q, p), sub(r, p));
        let size = length(normal);
        (size > 0.0).then(|| {
            let normal = scale(normal, 1.0 / size);
            (normal, dot(normal, p))
        })
    }

    /// Moves a vertex towards its target, which it reaches with the last step.
    fn step(&mut self, vertex: u32) {
        let v = vertex as usize;
        let share = 1.0 / f64::from(STEPS - self.steps[v]);
        (self.steps[v], self.is_moved[v]) = (self.steps[v] + 1, true);
        self.places[v] = tidy(between(self.places[v], self.target(vertex), share));
    }

    /// Lets each of some vertices of cells go back to its Voronoi vertex as far as nothing folds.
    fn go_back(&mut self, vertices: &[u32], run: &Run<'_>) -> Result<()> {
        let cells = vertices.partition_point(|&v| (v as usize) < self.parts.cells.len());
        for &vertex in &vertices[..cells] {
            run.poll()?;
            let v = vertex as usize;
            let place = self.places[v];
            let home = self.dual.centers()[self.parts.cells[v] as usize];
            let folded_before = self.folded_at(&[vertex]).len();
            for share in BACK {
                self.places[v] = tidy(between(home, place, share));
                self.is_moved[v] = share > 0.0;
                if self.is_in_box(self.places[v])
                    && self.folded_at(&[vertex]).len() <= folded_before
                {
                    break;
                }
                (self.places[v], self.is_moved[v]) = (place, true);
            }
        }
        Ok(())
    }
}

/// A point behind all planes, near to a given one, if it is found soon.
fn relaxed(mut p: Vec3, planes: &[(Vec3, f64)]) -> Option<Vec3> {
    for _ in 0..MOVES {
        let before = |&(normal, distance): &(Vec3, f64)| dot(normal, p) - distance;
        let worst = planes.iter().max_by(|a, b| before(a).total_cmp(&before(b)))?;
        let beyond = before(worst);
        if beyond < 0.0 {
            return Some(p);
        }
        // Not on the plane, whatever rounding does.
        let size = p.iter().fold(worst.1.abs(), |size, x| size.max(x.abs()));
        let by = beyond * (1.0 + BEYOND) + 1e-14 * size;
        p = sub(p, scale(worst.0, by));
    }
    None
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
