//! Betti numbers over Z/2.
//!
//! Free faces are collapsed first, which keeps the homotopy type. What is left of a chain group
//! is then joined into classes of cells that a cycle can only use together, and the few classes that
//! meet along seams are solved by elimination over Z/2.

use super::disjoint::DisjointSets;
use super::skeleton::{Skeleton, filled};
use crate::error::Result;
use crate::index::NONE;
use crate::job::Run;
use std::collections::VecDeque;

/// The number of steps between two ticks.
const BATCH: usize = 1 << 12;

/// The second and third Betti numbers over Z/2.
pub(super) fn upper_betti(skeleton: &Skeleton, run: &Run<'_>) -> Result<[u64; 2]> {
    let mut core = Core::new(skeleton, run)?;
    core.collapse_cells(run)?;
    // Cells that are left close up on themselves, which nothing in space does. Each cycle gives one
    // cell away, and counts; the rest have independent boundaries.
    let free = core.free_cells(run)?;
    for &cell in &free {
        core.remove_cell(cell);
    }
    core.collapse_cells(run)?;
    core.collapse_faces(run)?;
    let cycles = core.face_cycles(run)?;
    let boundaries = core.cell_alive.iter().filter(|&&alive| alive).count() as u64;
    Ok([cycles - boundaries, free.len() as u64])
}

/// What collapses have left of a complex.
struct Core<'a> {
    skeleton: &'a Skeleton,
    cell_alive: Vec<bool>,
    face_alive: Vec<bool>,
    /// For each face the number of cells alive that it bounds.
    cells_at: Vec<u32>,
    /// For each edge the number of sides of faces alive that lie on it.
    sides_at: Vec<u32>,
    /// Faces, then edges, that had one coface when they were put here. First in, first out: what
    /// is eaten away in waves from outside leaves next to nothing, in any other order a thicket.
    queue: VecDeque<u32>,
}

impl<'a> Core<'a> {
    fn new(skeleton: &'a Skeleton, run: &Run<'_>) -> Result<Self> {
        let faces = skeleton.face_count();
        let mut cells_at = run.try_vec(faces)?;
        cells_at.extend((0..faces).map(|f| skeleton.cells_of_face(f).len() as u32));
        let mut sides_at = run.try_vec(skeleton.edges.len())?;
        sides_at.extend((0..skeleton.edges.len()).map(|e| skeleton.sides_of_edge(e).len() as u32));
        let mut core = Core {
            skeleton,
            cell_alive: filled(skeleton.cell_count(), true, run)?,
            face_alive: filled(faces, true, run)?,
            cells_at,
            sides_at,
            queue: VecDeque::new(),
        };
        core.queue.extend((0..faces as u32).filter(|&f| core.cells_at[f as usize] == 1));
        Ok(core)
    }

    /// Takes away a cell; faces that become free queue up.
    fn remove_cell(&mut self, cell: u32) {
        self.cell_alive[cell as usize] = false;
        for &f in self.skeleton.facets(cell as usize) {
            self.cells_at[f as usize] -= 1;
            if self.cells_at[f as usize] == 1 {
                self.queue.push_back(f);
            }
        }
    }

    fn remove_face(&mut self, face: u32) {
        self.face_alive[face as usize] = false;
        for side in self.skeleton.sides(face as usize) {
            let e = self.skeleton.edge_of_side[side];
            self.sides_at[e as usize] -= 1;
            if self.sides_at[e as usize] == 1 {
                self.queue.push_back(e);
            }
        }
    }

    /// Collapses cells through faces that bound nothing else, as long as there are any.
    fn collapse_cells(&mut self, run: &Run<'_>) -> Result<()> {
        let mut steps = 0;
        let mut freed = Vec::new();
        while let Some(face) = self.queue.pop_front() {
            steps += 1;
            if steps % BATCH == 0 {
                run.poll()?;
            }
            let cells = self.skeleton.cells_of_face(face as usize);
            if self.cells_at[face as usize] == 1
                && let Some(&cell) = cells.iter().find(|&&c| self.cell_alive[c as usize])
            {
                self.remove_cell(cell);
                freed.push(face);
            }
        }
        // Faces go last, as they put edges into the same queue; it serves one kind at a time.
        for (i, &face) in freed.iter().enumerate() {
            if i % BATCH == 0 {
                run.poll()?;
            }
            self.remove_face(face);
        }
        self.queue.clear();
        Ok(())
    }

    /// Collapses faces through edges that lie on no other side, as long as there are any.
    fn collapse_faces(&mut self, run: &Run<'_>) -> Result<()> {
        self.queue.clear();
        let edges = 0..self.sides_at.len() as u32;
        self.queue.extend(edges.filter(|&e| self.sides_at[e as usize] == 1));
        let mut steps = 0;
        while let Some(edge) = self.queue.pop_front() {
            steps += 1;
            if steps % BATCH == 0 {
                run.poll()?;
            }
            if self.sides_at[edge as usize] != 1 {
                continue;
            }
            let face = self.faces_at(edge as usize).next();
            if let Some(face) = face.filter(|&f| self.cells_at[f as usize] == 0) {
                self.remove_face(face);
            }
        }
        Ok(())
    }

    /// The face of each side alive that lies on the edge.
    fn faces_at(&self, edge: usize) -> impl Iterator<Item = u32> {
        let sides = self.skeleton.sides_of_edge(edge).iter();
        let faces = sides.map(|&s| self.skeleton.face_of_side[s as usize]);
        faces.filter(|&f| self.face_alive[f as usize])
    }

    /// Cells without which the cells alive hold no cycle, as few as there can be.
    fn free_cells(&self, run: &Run<'_>) -> Result<Vec<u32>> {
        if !self.cell_alive.contains(&true) {
            return Ok(Vec::new());
        }
        let coface = |f: usize| {
            let cells = self.skeleton.cells_of_face(f).iter().copied();
            cells.filter(|&c| self.cell_alive[c as usize])
        };
        free_classes(&self.cell_alive, self.face_alive.len(), coface, run)
    }

    /// The dimension of the space of cycles that the faces alive form.
    fn face_cycles(&self, run: &Run<'_>) -> Result<u64> {
        let coface = |e: usize| self.faces_at(e);
        let free = free_classes(&self.face_alive, self.sides_at.len(), coface, run)?;
        Ok(free.len() as u64)
    }
}

/// One element of each free class: a cycle may or may not use it, and the choice for all of
/// them decides the cycle. Their number is the dimension of the space of cycles.
///
/// `elements` says which ones there are; `cofaces(i)` lists those at facet `i`, one as often as it
/// lies there. A cycle uses an even number at each facet.
fn free_classes<I: Iterator<Item = u32>>(
    elements: &[bool],
    facets: usize,
    cofaces: impl Fn(usize) -> I,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    // A cycle uses both of two elements at a facet or neither.
    let mut classes = DisjointSets::new(elements.len(), run)?;
    for facet in 0..facets {
        if facet % BATCH == 0 {
            run.poll()?;
        }
        let mut at = cofaces(facet);
        if let (Some(a), Some(b), None) = (at.next(), at.next(), at.next()) {
            classes.join(a, b);
        }
    }
    // What is left to ask of the classes: an even number of each of these lists.
    let mut equations: Vec<Vec<u32>> = Vec::new();
    for facet in 0..facets {
        if facet % BATCH == 0 {
            run.poll()?;
        }
        let mut equation = Vec::new();
        for element in cofaces(facet) {
            toggle(&mut equation, classes.root(element));
        }
        if !equation.is_empty() {
            equations.push(equation);
        }
    }
    equations.sort_unstable_by(|a, b| a.len().cmp(&b.len()).then_with(|| a.cmp(b)));
    equations.dedup();
    let mut pivots = Pivots { row_of: filled(elements.len(), NONE, run)?, rows: Vec::new() };
    for (i, equation) in equations.into_iter().enumerate() {
        run.tick(i, facets)?;
        pivots.add(equation, run)?;
    }
    let free = (0..elements.len() as u32).filter(|&e| {
        elements[e as usize] && classes.root(e) == e && pivots.row_of[e as usize] == NONE
    });
    Ok(free.collect())
}

/// Adds an element to an ascending list, or takes it out if it is there.
fn toggle(list: &mut Vec<u32>, element: u32) {
    match list.binary_search(&element) {
        Ok(at) => {
            list.remove(at);
        }
        Err(at) => list.insert(at, element),
    }
}

/// Independent rows over Z/2, each an ascending list, found by its last entry.
struct Pivots {
    row_of: Vec<u32>,
    rows: Vec<Vec<u32>>,
}

impl Pivots {
    /// Keeps what the rows so far leave of a further one.
    fn add(&mut self, mut row: Vec<u32>, run: &Run<'_>) -> Result<()> {
        let mut sum = Vec::new();
        while let Some(&last) = row.last() {
            match self.row_of[last as usize] {
                NONE => {
                    self.row_of[last as usize] = self.rows.len() as u32;
                    self.rows.push(row);
                    return Ok(());
                }
                r => {
                    run.poll()?;
                    add_rows(&row, &self.rows[r as usize], &mut sum);
                    std::mem::swap(&mut row, &mut sum);
                }
            }
        }
        Ok(())
    }
}

/// The symmetric difference of two ascending lists.
fn add_rows(a: &[u32], b: &[u32], sum: &mut Vec<u32>) {
    sum.clear();
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        match a[i].cmp(&b[j]) {
            std::cmp::Ordering::Less => {
                sum.push(a[i]);
                i += 1;
            }
            std::cmp::Ordering::Greater => {
                sum.push(b[j]);
                j += 1;
            }
            std::cmp::Ordering::Equal => {
                i += 1;
                j += 1;
            }
        }
    }
    sum.extend_from_slice(&a[i..]);
    sum.extend_from_slice(&b[j..]);
}
