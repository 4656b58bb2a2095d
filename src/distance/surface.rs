//! The medial axis in space as polygons: the dual of a lattice's cells that it passes (dual contouring; Ju, Losasso, Schaefer, Warren 2002, *Dual contouring of Hermite data*).

use super::field::FieldAxis;
use super::locate::{MedialPoint, Search};
use super::sites::Sites;
use super::space::Lattice;
use crate::complex::{Attribute, Complex, ComplexParts, DisjointSets, Element, Rows};
use crate::error::{Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::vector::{Vec3, add, length, scale, sub};
use std::collections::HashMap;

/// The edges or squares that one thread looks at in one go.
const BATCH: usize = 16;

/// A cube, by its place in the lattice; a vertex of the lattice, by the cube above it.
type Cube = [u32; 3];

/// An edge of the lattice, by its lower vertex and its axis; or a square, by the cube above it and the axis across it.
type Cell = (Cube, usize);

impl FieldAxis {
    /// The medial axis as a surface of polygons, in space.
    ///
    /// A vertex stands for each cube with sides as long as the density in which a point was found. Each edge of such a cube that crosses the axis, with an object angle and a distance
    /// that pass the thresholds, makes a quadrilateral of the vertices of the four cubes round it; cubes among them that have no point get one, and have their own edges looked at.
    /// Where only the square between two cubes meets the axis, as a curve does that is the middle of a tube, a loose edge joins their vertices. Where two parts of the axis pass one
    /// cube, they meet in its vertex.
    ///
    /// Every vertex is a medial point, and carries what those of [`FieldAxis::complex`] do, but for `missed_angle`; it lies in its cube. A cube without a point of its own gets that which is found behind the mean of
    /// the crossings round it, seen from the boundary; where there is none, the crossing nearest to that mean. Faces and loose edges carry `radius`, `object_angle`, `feet`, `pieces`
    /// and `sites` of the point where the lattice crosses the axis. A face between two sites is oriented from the lesser to the larger; others along the axes of the lattice.
    ///
    /// Nothing bounds what is missed. Errors: [`Status::InvalidArgument`] in the plane, where [`MedialGraph`](super::MedialGraph) has the arcs; those of the job. Cost: some queries for
    /// each edge and square of the cubes that the axis passes.
    pub fn surface(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| self.surface_in(run))
    }

    /// [`FieldAxis::surface`] as a stage of a larger build.
    pub(crate) fn surface_in(&self, run: &Run<'_>) -> Result<Complex> {
        run.enter(Stage::Extract)?;
        if self.sites.dimension() != 3 {
            let message = "a surface is that of an axis in space; in the plane there is a graph";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        let lattice = Lattice::finest(&self.options)?;
        let search = self.sites.search(self.options.decide)?;
        let mut surface = Surface {
            axis: self,
            search,
            lattice,
            room: Room::new(run),
            run,
            number: HashMap::new(),
            points: Vec::new(),
            crossed: HashMap::new(),
            faces: Vec::new(),
            face_points: Vec::new(),
            edges: Vec::new(),
            edge_points: Vec::new(),
        };
        surface.grow()?;
        surface.complex()
    }
}

struct Surface<'a> {
    axis: &'a FieldAxis,
    search: Search<'a>,
    lattice: Lattice,
    room: Room<'a>,
    run: &'a Run<'a>,
    /// The vertex of each cube that has one.
    number: HashMap<Cube, u32>,
    points: Vec<MedialPoint>,
    /// Where the edges of the lattice cross the axis.
    crossed: HashMap<Cell, MedialPoint>,
    /// The cubes round each edge that has four.
    faces: Vec<[Cube; 4]>,
    face_points: Vec<MedialPoint>,
    edges: Vec<[Cube; 2]>,
    edge_points: Vec<MedialPoint>,
}

impl Surface<'_> {
    /// Looks at the edges and squares of the cubes that have points, then at those of the cubes that these call for, until no more are called for.
    fn grow(&mut self) -> Result<()> {
        let mut front: Vec<Cube> = Vec::new();
        for point in self.run.watch(&self.axis.points) {
            let point = point?;
            let place = self.lattice.place(point.center);
            // What lies on the far side of the box belongs to the last cube.
            let cube =
                [0, 1, 2].map(|k| place[k].clamp(0, i64::from(self.lattice.count[k]) - 1) as u32);
            if !self.number.contains_key(&cube) {
                self.room.insert(&mut self.number, cube, self.points.len() as u32)?;
                self.room.push(&mut self.points, *point)?;
                self.room.push(&mut front, cube)?;
            }
        }
        let mut begin = 0;
        while !front.is_empty() {
            let mut hints = self.cross_edges(&front, begin)?;
            hints.extend(self.cross_squares(&front, begin)?);
            begin = self.points.len() as u32;
            front = self.add_cubes(hints)?;
        }
        Ok(())
    }

    /// The cells of some cubes that no cube before them had, each once.
    fn cells_of(
        &mut self,
        front: &[Cube],
        begin: u32,
        of: fn(Cube) -> Vec<Cell>,
        cubes: fn(&Self, &Cell) -> Vec<Cube>,
    ) -> Result<Vec<Cell>> {
        let mut cells = Vec::new();
        for cube in self.run.watch(front) {
            let own = of(*cube?);
            self.room.grow(&mut cells, own.len())?;
            cells.extend(own);
        }
        cells.sort_unstable();
        cells.dedup();
        let is_known = |cube: &Cube| self.number.get(cube).is_some_and(|&number| number < begin);
        cells.retain(|cell| !cubes(self, cell).iter().any(is_known));
        Ok(cells)
    }

    /// Finds where edges cross the axis. Returns these points for each cube round the edges.
    fn cross_edges(&mut self, front: &[Cube], begin: u32) -> Result<Vec<(Cube, MedialPoint)>> {
        let edges = self.cells_of(front, begin, edges_of, Self::cubes_round)?;
        let parts = edges.chunks(BATCH).collect();
        let found = self.run.in_parallel(parts, |edges| {
            let mut found = Vec::new();
            for &(base, axis) in edges {
                self.run.poll()?;
                let ends = [base, stepped(base, axis)].map(|place| self.lattice.corner(place));
                self.search.crossings(ends, self.axis.options.angle, &mut |point| {
                    if self.is_asked_for(&point) {
                        found.push(((base, axis), point));
                    }
                });
            }
            Ok(found)
        })?;
        let mut hints = Vec::new();
        for (edge, point) in self.here(found.into_iter().flatten().collect())? {
            if self.crossed.contains_key(&edge) {
                continue;
            }
            self.room.insert(&mut self.crossed, edge, point)?;
            let mut cubes = self.cubes_round(&edge);
            hints.extend(cubes.iter().map(|&cube| (cube, point)));
            if let Some(ring) = cubes.first_chunk_mut::<4>() {
                let [from, to] = self.sites_of(&point);
                if from > to {
                    ring.reverse();
                }
                self.room.push(&mut self.faces, *ring)?;
                self.room.push(&mut self.face_points, point)?;
            }
        }
        Ok(hints)
    }

    /// Finds squares that meet the axis though they are no side of a face.
    fn cross_squares(&mut self, front: &[Cube], begin: u32) -> Result<Vec<(Cube, MedialPoint)>> {
        let squares = self.cells_of(front, begin, squares_of, Self::cubes_beside)?;
        let parts = squares.chunks(BATCH).collect();
        let found = self.run.in_parallel(parts, |squares| {
            let mut found = Vec::new();
            for square in squares {
                self.run.poll()?;
                found.extend(self.in_square(square).map(|point| (*square, point)));
            }
            Ok(found)
        })?;
        let mut hints = Vec::new();
        for (square, point) in self.here(found.into_iter().flatten().collect())? {
            let cubes = self.cubes_beside(&square);
            if let Some(&ends) = cubes.first_chunk::<2>() {
                self.room.push(&mut self.edges, ends)?;
                self.room.push(&mut self.edge_points, point)?;
                hints.extend(ends.map(|cube| (cube, point)));
            }
        }
        Ok(hints)
    }

    fn in_square(&self, square: &Cell) -> Option<MedialPoint> {
        if self.cubes_beside(square).len() < 2 {
            return None;
        }
        let &(base, axis) = square;
        let [i, j] = across(axis);
        let sides = [(base, i), (base, j), (stepped(base, j), i), (stepped(base, i), j)];
        let mut on_rim = None;
        for (side, &point) in sides.iter().filter_map(|side| Some((side, self.crossed.get(side)?)))
        {
            if self.cubes_round(side).len() == 4 {
                return None;
            }
            on_rim = Some(point);
        }
        let far = stepped(stepped(base, i), j);
        let corners = [base, stepped(base, i), far, stepped(base, j)];
        let corners = corners.map(|place| self.lattice.corner(place));
        let found = || self.search.in_square(corners, self.axis.options.angle);
        on_rim.or_else(found).filter(|point| self.is_asked_for(point))
    }

    /// Gives a point to each of the cubes that have none, and returns these.
    fn add_cubes(&mut self, mut hints: Vec<(Cube, MedialPoint)>) -> Result<Vec<Cube>> {
        hints.retain(|(cube, _)| !self.number.contains_key(cube));
        hints.sort_by_key(|&(cube, _)| cube);
        let parts: Vec<_> = hints.chunk_by(|a, b| a.0 == b.0).collect();
        let nearest = parts.iter().map(|hints| nearest_to_mean(hints)).collect::<Vec<_>>();
        let behind = self.run.in_parallel(parts.chunks(BATCH).collect(), |parts| {
            self.run.poll()?;
            Ok(parts.iter().map(|hints| self.behind_mean(hints)).collect::<Vec<_>>())
        })?;
        let behind = behind.into_iter().flatten().zip(&parts);
        let behind = behind.filter_map(|(point, hints)| Some((hints[0].0, point?))).collect();
        let mut behind = self.here(behind)?.into_iter().peekable();
        let mut front = self.room.vec(parts.len())?;
        for (hints, nearest) in parts.iter().zip(nearest) {
            let cube = hints[0].0;
            let point = behind.next_if(|&(of, _)| of == cube).map_or(nearest, |(_, point)| point);
            self.room.insert(&mut self.number, cube, self.points.len() as u32)?;
            self.room.push(&mut self.points, point)?;
            front.push(cube);
        }
        Ok(front)
    }

    /// The medial point in a cube that lies behind the mean of some crossings, seen from the point of the boundary that is nearest to it.
    fn behind_mean(&self, hints: &[(Cube, MedialPoint)]) -> Option<MedialPoint> {
        let mean = mean(hints);
        let foot = self.axis.sites.foot(mean);
        let distance = foot.distance_squared.sqrt();
        if distance == 0.0 {
            return None;
        }
        let way = scale(sub(mean, foot.point), 1.0 / distance);
        let far = distance + 2.0 * self.lattice.side;
        let point = self.search.along(&foot, way, [distance, far])?;
        let in_cube = self.lattice.place(point.center) == hints[0].0.map(i64::from);
        (in_cube && self.is_asked_for(&point)).then_some(point)
    }

    /// Those on the side that was asked for.
    fn here<T>(&self, found: Vec<(T, MedialPoint)>) -> Result<Vec<(T, MedialPoint)>> {
        let centers: Vec<Vec3> = found.iter().map(|(_, point)| point.center).collect();
        let is_here = self.axis.sites.are_on(self.axis.options.side, &centers, self.run)?;
        Ok(found
            .into_iter()
            .zip(is_here)
            .filter(|&(_, here)| here)
            .map(|(found, _)| found)
            .collect())
    }

    fn is_asked_for(&self, point: &MedialPoint) -> bool {
        let axis = self.axis;
        let [min, max] = axis.options.clip.unwrap_or_default();
        let in_box = (0..3).all(|k| min[k] <= point.center[k] && point.center[k] <= max[k]);
        in_box && axis.options.pass(point) && axis.pairs.holds(&axis.sites, point)
    }

    fn sites_of(&self, point: &MedialPoint) -> [u32; 2] {
        point.pieces.map(|piece| self.axis.sites.site_of_piece()[piece as usize])
    }

    /// The cubes round an edge, counterclockwise seen from its upper end; fewer than four on the rim of the lattice.
    fn cubes_round(&self, &(base, axis): &Cell) -> Vec<Cube> {
        let [i, j] = across(axis);
        let steps = [(1, 1), (0, 1), (0, 0), (1, 0)];
        let cube = |(by_i, by_j): (u32, u32)| {
            let mut cube = base;
            cube[i] = cube[i].checked_sub(by_i)?;
            cube[j] = cube[j].checked_sub(by_j)?;
            self.is_in_lattice(&cube).then_some(cube)
        };
        steps.into_iter().filter_map(cube).collect()
    }

    /// The cubes on both sides of a square; one on the rim of the lattice.
    fn cubes_beside(&self, &(base, axis): &Cell) -> Vec<Cube> {
        let mut below = base;
        let below = base[axis].checked_sub(1).map(|place| {
            below[axis] = place;
            below
        });
        below.into_iter().chain([base]).filter(|cube| self.is_in_lattice(cube)).collect()
    }

    fn is_in_lattice(&self, cube: &Cube) -> bool {
        (0..3).all(|k| cube[k] < self.lattice.count[k])
    }

    fn complex(mut self) -> Result<Complex> {
        let mut faces = self.room.vec(self.faces.len())?;
        for ring in self.run.watch(&self.faces) {
            faces.push(ring?.map(|cube| self.number[&cube]));
        }
        let (edges, edge_points) = self.loose_edges(&faces)?;
        let sites: &Sites = &self.axis.sites;
        let mut attributes: Vec<Attribute> = Vec::new();
        let of = [
            (Element::Vertex, &self.points),
            (Element::Face, &self.face_points),
            (Element::Edge, &edge_points),
        ];
        for (element, points) in of {
            attributes.extend(sites.attributes_of(element, points, self.run)?);
        }
        let parts = ComplexParts {
            dimension: 3,
            vertices: self.room.collect(self.points.iter().map(|point| point.center))?,
            faces: Rows::uniform_in(faces, &mut self.room)?,
            edges,
            attributes,
            ..ComplexParts::default()
        };
        Complex::new_in(parts, self.run)
    }

    /// The edges that are no side of a face: of several that join the same two sheets of faces, or a vertex and a sheet, the first, so that the rim of a sheet makes no loops.
    fn loose_edges(&mut self, faces: &[[u32; 4]]) -> Result<(Vec<[u32; 2]>, Vec<MedialPoint>)> {
        let mut sheets = DisjointSets::new(self.points.len(), self.run)?;
        for face in self.run.watch(faces) {
            let &[first, ref others @ ..] = face?;
            others.iter().for_each(|&other| {
                sheets.join(first, other);
            });
        }
        let (mut edges, mut points) = (Vec::new(), Vec::new());
        let mut joined = HashMap::new();
        for edge in self.run.watch(self.edges.iter().zip(&self.edge_points)) {
            let (cubes, &point) = edge?;
            let ends = cubes.map(|cube| self.number[&cube]);
            let [a, b] = ends.map(|end| sheets.root(end));
            if a != b && !joined.contains_key(&[a.min(b), a.max(b)]) {
                self.room.insert(&mut joined, [a.min(b), a.max(b)], ())?;
                self.room.push(&mut edges, ends)?;
                self.room.push(&mut points, point)?;
            }
        }
        Ok((edges, points))
    }
}

/// The two axes across one, so that all three turn to the right.
fn across(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// The next place along an axis.
fn stepped(mut place: Cube, axis: usize) -> Cube {
    place[axis] += 1;
    place
}

/// The twelve edges of a cube.
fn edges_of(cube: Cube) -> Vec<Cell> {
    let of_axis = |axis: usize| {
        let [i, j] = across(axis);
        let far = stepped(stepped(cube, i), j);
        [cube, stepped(cube, i), stepped(cube, j), far].map(|base| (base, axis))
    };
    [0, 1, 2].map(of_axis).concat()
}

/// The six squares of a cube.
fn squares_of(cube: Cube) -> Vec<Cell> {
    [0, 1, 2].map(|axis| [(cube, axis), (stepped(cube, axis), axis)]).concat()
}

fn mean(hints: &[(Cube, MedialPoint)]) -> Vec3 {
    let sum = hints.iter().fold([0.0; 3], |sum, (_, point)| add(sum, point.center));
    scale(sum, 1.0 / hints.len() as f64)
}

/// That of some crossings which is nearest to their mean, of several the first.
fn nearest_to_mean(hints: &[(Cube, MedialPoint)]) -> MedialPoint {
    let mean = mean(hints);
    let away = |point: &MedialPoint| length(sub(point.center, mean));
    let nearest = hints.iter().map(|&(_, point)| point);
    nearest.min_by(|p, q| away(p).total_cmp(&away(q))).unwrap_or_default()
}
