//! Umbrellas: samples round which the surface is a disk, and the two sides of it there.

use super::sheet::Sheet;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, parts_of};
use crate::triangulation::{Incidence, Triangulation};

/// The vertices whose stars a thread looks at in one go.
const STARS: usize = 1 << 11;

/// The sides of the umbrella of each sample that has one.
///
/// A sample is *well sampled* if its triangles are one closed fan: an umbrella, that divides the cells round it in two (Dey, Goswami 2003, section 3). Its
/// first side, 1, is the one in front of its first triangle; 2 is the other; 0 stands for no umbrella.
pub(super) struct Umbrellas {
    /// For each cell the side on which it is of the umbrella of each of its vertices.
    pub(super) sides: Vec<[u8; 4]>,
    /// For each sample the side on which what is beyond the hull is; 0 also for samples that are not on the hull.
    pub(super) beyond: Vec<u8>,
    /// Whether each sample has an umbrella.
    pub(super) is_good: Vec<bool>,
}

impl Umbrellas {
    pub(super) fn new(
        t: &Triangulation,
        sheet: &Sheet<'_>,
        walls: &[u8],
        incidence: &Incidence,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let samples = t.coords().len();
        let found = run.in_steps(parts_of(STARS, samples), [0.0, 0.3], |range| {
            let mut room = Room::new(run);
            let mut star = Star::default();
            let offsets = incidence.offsets();
            let cells = offsets[range.end] - offsets[range.start];
            let (mut sides, mut beyond) = (room.vec(cells as usize)?, room.vec(range.len())?);
            for v in range {
                let cells = incidence.cells_of(v as u32);
                if v % 64 == 0 || cells.len() > 1024 {
                    run.poll()?;
                }
                let is_good = has_umbrella(sheet, v as u32, &mut star.pairs);
                if is_good {
                    star.divide(t, sheet, walls, v as u32, cells);
                    sides.extend_from_slice(&star.sides);
                } else {
                    sides.resize(sides.len() + cells.len(), 0);
                }
                beyond.push((is_good, if is_good { star.beyond } else { 0 }));
            }
            Ok((sides, beyond, room))
        })?;
        let mut sides = room.filled(t.cells().len(), [0u8; 4])?;
        let (mut beyond, mut is_good) = (room.vec(samples)?, room.vec(samples)?);
        let mut place = 0;
        for (of_cells, of_samples, _) in found {
            run.poll()?;
            let first = beyond.len();
            is_good.extend(of_samples.iter().map(|(is_good, _)| *is_good));
            beyond.extend(of_samples.iter().map(|(_, beyond)| *beyond));
            for v in first as u32..beyond.len() as u32 {
                for &cell in incidence.cells_of(v) {
                    let slot = t.cells()[cell as usize].iter().position(|&corner| corner == v);
                    sides[cell as usize][slot.unwrap_or(0)] = of_cells[place];
                    place += 1;
                }
            }
            place = 0;
        }
        Ok(Umbrellas { sides, beyond, is_good })
    }

    /// The side on which a cell is, or what is beyond the hull, of the umbrella of one of its vertices.
    pub(super) fn side(&self, t: &Triangulation, cell: u32, vertex: u32) -> u8 {
        match cell {
            NONE => self.beyond[vertex as usize],
            cell => {
                let slot = t.cells()[cell as usize].iter().position(|&v| v == vertex);
                self.sides[cell as usize][slot.unwrap_or(0)]
            }
        }
    }
}

/// Whether the triangles of a vertex are one closed fan: the edges opposite it are one ring.
fn has_umbrella(sheet: &Sheet<'_>, vertex: u32, pairs: &mut Vec<(u32, u32)>) -> bool {
    pairs.clear();
    for &corner in sheet.star(vertex) {
        let corners = sheet.corners[corner as usize / 4];
        let [q, r] = [1, 2].map(|k| corners[(corner as usize % 4 + k) % 3]);
        pairs.extend([(q, r), (r, q)]);
    }
    pairs.sort_unstable();
    let count = pairs.len() / 2;
    // Every vertex of the ring has two others next to it.
    let is_ring = |pair: &[(u32, u32)]| pair.len() == 2 && pair[0].1 != pair[1].1;
    if count < 3 || !pairs.chunk_by(|a, b| a.0 == b.0).all(is_ring) {
        return false;
    }
    let (first, mut at) = (pairs[0].0, pairs[0].1);
    let (mut before, mut length) = (first, 1);
    while at != first {
        let i = pairs.partition_point(|pair| pair.0 < at);
        let next = if pairs[i].1 == before { pairs[i + 1].1 } else { pairs[i].1 };
        (before, at) = (at, next);
        length += 1;
    }
    length == count
}

/// The cells round a vertex.
#[derive(Default)]
struct Star {
    sides: Vec<u8>,
    beyond: u8,
    stack: Vec<u32>,
    pairs: Vec<(u32, u32)>,
}

impl Star {
    /// Divides the cells of a vertex with an umbrella.
    fn divide(
        &mut self,
        t: &Triangulation,
        sheet: &Sheet<'_>,
        walls: &[u8],
        vertex: u32,
        cells: &[u32],
    ) {
        self.sides.clear();
        self.sides.resize(cells.len(), 2);
        self.beyond = 2;
        self.stack.clear();
        let [_, start] = sheet.cells(t, sheet.star(vertex)[0] / 4);
        self.reach(start, cells);
        let is_on_hull = |cell: u32| {
            let corners = t.cells()[cell as usize];
            (0..4).any(|i| corners[i] != vertex && t.is_hull(cell, i))
        };
        let mut is_beyond_done = false;
        loop {
            while let Some(cell) = self.stack.pop() {
                let corners = t.cells()[cell as usize];
                for i in (0..4).filter(|&i| corners[i] != vertex) {
                    if walls[cell as usize] >> i & 1 == 0 {
                        self.reach(t.neighbors()[cell as usize][i], cells);
                    }
                }
            }
            if self.beyond != 1 || is_beyond_done {
                break;
            }
            // From beyond the hull through all of its facets at the vertex.
            is_beyond_done = true;
            for &cell in cells {
                let corners = t.cells()[cell as usize];
                let open = |i: usize| {
                    corners[i] != vertex && t.is_hull(cell, i) && walls[cell as usize] >> i & 1 == 0
                };
                if (0..4).any(open) {
                    self.reach(cell, cells);
                }
            }
        }
        if !cells.iter().any(|&cell| is_on_hull(cell)) {
            self.beyond = 0;
        }
    }

    fn reach(&mut self, cell: u32, cells: &[u32]) {
        if cell == NONE {
            self.beyond = 1;
        } else if let Ok(place) = cells.binary_search(&cell)
            && self.sides[place] != 1
        {
            self.sides[place] = 1;
            self.stack.push(cell);
        }
    }
}
