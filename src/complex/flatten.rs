//! Flat tetrahedra, collapsed to their triangles.

use super::skeleton::Skeleton;
use super::{Attribute, Complex, ComplexParts, Element, Point, Rows, Values};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::vector::{Vec3, cross, dot, sub};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The flatness up to which tetrahedra are flat, by default.
const FLATNESS: f64 = 0.1;

/// Which tetrahedra [`Complex::flatten`] collapses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlattenOptions {
    /// Those whose least altitude is at most this share of their longest edge, 0.1 by default: of a regular tetrahedron it is 0.816.
    /// Infinity stands for all.
    pub flatness: f64,
}

impl Default for FlattenOptions {
    fn default() -> Self {
        FlattenOptions { flatness: FLATNESS }
    }
}

/// A complex without its flat tetrahedra.
#[derive(Clone, Debug)]
pub struct Flattened {
    /// What is left.
    pub complex: Complex,
    /// The tetrahedra that went, in order: each one's number among the cells, and the corner opposite the triangle that went with it.
    pub collapses: Vec<[u32; 2]>,
    /// The number of flat tetrahedra that could not go: each of their triangles bounds another cell, so that they lie between others, or
    /// round a void.
    pub left: usize,
}

impl Complex {
    /// The complex with flat tetrahedra collapsed to their triangles, of the same homotopy type.
    ///
    /// A tetrahedron goes together with a triangle that bounds no other cell, which is an elementary collapse (Whitehead 1939); its other three
    /// triangles stay, and become faces where they are none and bound no other cell. No edge and no vertex goes. That is done as long as there
    /// is a flat tetrahedron with such a triangle. At each step no point that goes is farther from what stays than the altitude of the
    /// tetrahedron over that triangle: the least altitude goes first, of equal ones the one of the least cell. Which tetrahedra
    /// go does not depend on the order, only which triangles.
    ///
    /// Faces, cells and their attributes keep their order; what becomes a face comes last, with NaN or [`NONE`] for attributes. Cells
    /// listed twice go together.
    ///
    /// Errors: [`Status::InvalidArgument`] for a flatness that is negative or not a number, [`Status::LimitExceeded`] past
    /// 2^31 - 1 sides of faces and facets, and those of the job. Cost: O(n log n).
    pub fn flatten(&self, options: FlattenOptions, job: &Job) -> Result<Flattened> {
        job.run(&[(Stage::Extract, 1.0)], |run| self.flatten_in(options, run))
    }

    /// [`Complex::flatten`] as a stage of a larger operation.
    pub(crate) fn flatten_in(&self, options: FlattenOptions, run: &Run<'_>) -> Result<Flattened> {
        run.enter(Stage::Extract)?;
        if options.flatness.is_nan() || options.flatness < 0.0 {
            let message = "the flatness must be a number and not negative";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        let _charge = run.charge(self.skeleton_bytes())?;
        let skeleton = Skeleton::new(self, run)?;
        let mut room = Room::new(run);
        let mut work = Work::new(self, &skeleton, options.flatness, &mut room, run)?;
        work.collapse(&mut room, run)?;
        let left = run.watch(&work.altitudes).try_fold(0, |left, altitudes| {
            let &(cell, _) = altitudes?;
            Ok::<_, Error>(left + usize::from(work.alive[cell as usize]))
        })?;
        let complex = work.assembled(&mut room, run)?;
        Ok(Flattened { complex, collapses: work.collapses, left })
    }
}

/// How flat a tetrahedron is: its least altitude relative to its longest edge. 0 where its corners lie in a plane, 0.816 if it is
/// regular, which is the most.
pub(crate) fn flatness(corners: [Point; 4]) -> f64 {
    Form::new(corners).flatness()
}

/// The measures of a tetrahedron that is scaled to be of order 1, so that products of them neither overflow nor vanish.
struct Form {
    /// Six times the volume.
    volume: f64,
    /// The square of twice the area of the facet opposite each corner.
    areas: [f64; 4],
    /// The square of the longest edge.
    longest: f64,
    /// A power of two, by which lengths are scaled.
    scale: f64,
}

impl Form {
    fn new(corners: [Point; 4]) -> Self {
        // Halves, as the difference may leave the range of an f64.
        let [a, b, c, d] = corners.map(|p| p.map(|x| 0.5 * x));
        let edges = [sub(b, a), sub(c, a), sub(d, a), sub(c, b), sub(d, b), sub(d, c)];
        let largest = edges.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let exponent = ((largest.to_bits() >> 52) as i64 - 1023).clamp(-1021, 1021);
        let scale = f64::from_bits(((1023 - exponent) as u64) << 52);
        let [ab, ac, ad, bc, bd, cd] = edges.map(|edge| edge.map(|x| scale * x));
        let square = |v: Vec3| dot(v, v);
        let base = cross(ac, ad);
        let normals = [cross(bc, bd), base, cross(ab, ad), cross(ab, ac)];
        Form {
            volume: dot(ab, base).abs(),
            areas: normals.map(square),
            longest: [ab, ac, ad, bc, bd, cd].map(square).into_iter().fold(0.0, f64::max),
            scale: 0.5 * scale,
        }
    }

    fn flatness(&self) -> f64 {
        let largest = self.areas.into_iter().fold(0.0, f64::max);
        if largest > 0.0 { self.volume / (largest * self.longest).sqrt() } else { 0.0 }
    }

    /// How far a corner is from the plane of the facet opposite, infinitely where that has no area.
    fn altitude(&self, corner: usize) -> f64 {
        let area = self.areas[corner].sqrt();
        if area > 0.0 { self.volume / area / self.scale } else { f64::INFINITY }
    }
}

/// A collapse that can be made: the bits of the altitude, which order as it does; the cell; and the facet's place among those of the cell.
type Candidate = Reverse<(u64, u32, u32)>;

/// What changes while tetrahedra go. Cells and faces are numbered as the skeleton does.
struct Work<'a> {
    complex: &'a Complex,
    skeleton: &'a Skeleton,
    /// The flat tetrahedra, ascending, with their altitudes over the facets, in input units.
    altitudes: Vec<(u32, [f64; 4])>,
    /// The first row of each cell.
    row_of_cell: Vec<u32>,
    alive: Vec<bool>,
    /// For each face the number of cells that it bounds, and [`NONE`] for one that went.
    cells_at: Vec<u32>,
    queue: BinaryHeap<Candidate>,
    collapses: Vec<[u32; 2]>,
}

impl<'a> Work<'a> {
    fn new(
        complex: &'a Complex,
        skeleton: &'a Skeleton,
        limit: f64,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut row_of_cell = room.filled(skeleton.cell_count(), NONE)?;
        for (row, &cell) in skeleton.cell_of_row.iter().enumerate().rev() {
            row_of_cell[cell as usize] = row as u32;
        }
        let mut work = Work {
            complex,
            skeleton,
            altitudes: Vec::new(),
            alive: room.filled(skeleton.cell_count(), true)?,
            cells_at: room.collect(
                (0..skeleton.face_count()).map(|face| skeleton.cells_of_face(face).len() as u32),
            )?,
            row_of_cell,
            queue: BinaryHeap::new(),
            collapses: Vec::new(),
        };
        for cell in run.watch(0..skeleton.cell_count()) {
            let cell = cell?;
            let &[a, b, c, d] = work.corners(cell) else { continue };
            let at = |v: u32| complex.vertices[v as usize];
            let form = Form::new([a, b, c, d].map(at));
            if form.flatness() <= limit {
                let over = std::array::from_fn(|k| form.altitude(work.opposite(cell, k)));
                room.push(&mut work.altitudes, (cell as u32, over))?;
            }
        }
        // Each facet comes once, when it becomes free.
        let bytes = 4 * work.altitudes.len() * size_of::<Candidate>();
        room.keep(bytes)?;
        work.queue.try_reserve_exact(4 * work.altitudes.len()).map_err(|_| {
            Error::new(Status::OutOfMemory, format!("{bytes} bytes are not to be had"))
        })?;
        work.collapses = room.vec(work.altitudes.len())?;
        Ok(work)
    }

    /// The vertices of a cell.
    fn corners(&self, cell: usize) -> &'a [u32] {
        self.complex.cells.row(self.row_of_cell[cell] as usize)
    }

    /// The place of the corner opposite a facet of a tetrahedron, given the facet's place.
    fn opposite(&self, cell: usize, facet: usize) -> usize {
        let ring = self.skeleton.ring(self.skeleton.facets(cell)[facet] as usize);
        self.corners(cell).iter().position(|v| !ring.contains(v)).unwrap_or(0)
    }

    /// Puts the free facets of a flat tetrahedron into the queue: all, or the one that is asked for.
    fn offer(&mut self, flat: usize, asked: Option<u32>) {
        let (cell, altitudes) = self.altitudes[flat];
        for (k, &face) in self.skeleton.facets(cell as usize).iter().enumerate() {
            if self.cells_at[face as usize] == 1 && asked.is_none_or(|asked| asked == face) {
                self.queue.push(Reverse((altitudes[k].to_bits(), cell, k as u32)));
            }
        }
    }

    /// Collapses flat tetrahedra as long as one of them has a free facet.
    fn collapse(&mut self, room: &mut Room<'_>, run: &Run<'_>) -> Result<()> {
        for flat in run.watch(0..self.altitudes.len()) {
            self.offer(flat?, None);
        }
        let skeleton = self.skeleton;
        let mut freed = Vec::new();
        while let Some(Reverse((_, cell, k))) = self.queue.pop() {
            if self.collapses.len().is_multiple_of(1024) {
                run.tick(self.collapses.len(), self.altitudes.len())?;
            }
            if !std::mem::replace(&mut self.alive[cell as usize], false) {
                continue;
            }
            let facets = skeleton.facets(cell as usize);
            let gone = facets[k as usize];
            let corner = self.corners(cell as usize)[self.opposite(cell as usize, k as usize)];
            self.collapses.push([self.row_of_cell[cell as usize], corner]);
            freed.clear();
            for &face in facets {
                self.cells_at[face as usize] -= 1;
                if self.cells_at[face as usize] == 1 {
                    room.push(&mut freed, face)?;
                }
            }
            self.cells_at[gone as usize] = NONE;
            for &face in &freed {
                let other =
                    skeleton.cells_of_face(face as usize).iter().find(|&&c| self.alive[c as usize]);
                let flat = other.and_then(|other| {
                    self.altitudes.binary_search_by_key(other, |&(cell, _)| cell).ok()
                });
                if let Some(flat) = flat {
                    self.offer(flat, Some(face));
                }
            }
        }
        Ok(())
    }

    /// The complex that is left.
    fn assembled(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Complex> {
        let (complex, skeleton) = (self.complex, self.skeleton);
        let faces = run.watch(&skeleton.face_of_row);
        let mut faces_left = Vec::new();
        for (row, face) in faces.enumerate() {
            if self.cells_at[*face? as usize] != NONE {
                room.push(&mut faces_left, row as u32)?;
            }
        }
        let mut cells_left = Vec::new();
        for (row, cell) in run.watch(&skeleton.cell_of_row).enumerate() {
            if self.alive[*cell? as usize] {
                room.push(&mut cells_left, row as u32)?;
            }
        }
        // Facets of what went that are listed nowhere.
        let mut bare = Vec::new();
        for face in run.watch(skeleton.listed..skeleton.face_count()) {
            let face = face?;
            if self.cells_at[face] == 0 {
                room.push(&mut bare, face)?;
            }
        }
        let rings = faces_left.iter().map(|&row| complex.faces.row(row as usize));
        let rings = rings.chain(bare.iter().map(|&face| skeleton.ring(face)));
        let corners = cells_left.iter().map(|&row| complex.cells.row(row as usize));
        let mut attributes = Vec::new();
        for attribute in &complex.attributes {
            attributes.push(match attribute.element() {
                Element::Vertex | Element::Edge => attribute.clone(),
                Element::Face => of_rows(attribute, &faces_left, bare.len(), room, run)?,
                Element::Cell => of_rows(attribute, &cells_left, 0, room, run)?,
            });
        }
        let of_cell = cells_left.iter().map(|&row| complex.cell_types[row as usize]);
        let parts = ComplexParts {
            dimension: complex.dimension,
            vertices: room.collect(complex.vertices.iter().copied())?,
            faces: rows(rings, room, run)?,
            edges: room.collect(complex.edges.iter().copied())?,
            cells: rows(corners, room, run)?,
            cell_types: room.collect(of_cell)?,
            attributes,
        };
        Complex::sound_in(parts, run)
    }
}

/// Rows, one after the other.
fn rows<'a>(
    lists: impl Iterator<Item = &'a [u32]>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Rows> {
    let (mut offsets, mut indices) = (vec![0], Vec::new());
    for list in run.watch(lists) {
        let list = list?;
        room.grow(&mut indices, list.len())?;
        indices.extend_from_slice(list);
        room.push(&mut offsets, indices.len() as u32)?;
    }
    Rows::new(offsets, indices)
}

/// The attribute of some of the elements, and of so many more that have no value.
fn of_rows(
    attribute: &Attribute,
    rows: &[u32],
    more: usize,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Attribute> {
    let width = attribute.width();
    let values = match attribute.values() {
        Values::F64(values) => Values::F64(chosen(values, f64::NAN, width, rows, more, room, run)?),
        Values::U32(values) => Values::U32(chosen(values, NONE, width, rows, more, room, run)?),
    };
    Attribute::new(attribute.name(), attribute.element(), width, values)
}

/// Some of the rows of an array, and so many more that are filled with one value.
fn chosen<T: Copy>(
    values: &[T],
    none: T,
    width: usize,
    rows: &[u32],
    more: usize,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<T>> {
    let mut chosen = room.vec((rows.len() + more) * width)?;
    for row in run.watch(rows) {
        chosen.extend_from_slice(&values[*row? as usize * width..][..width]);
    }
    chosen.resize((rows.len() + more) * width, none);
    Ok(chosen)
}
