//! Moving inner vertices until nothing is folded.

use super::moves::Way;
use super::{Mended, Part, between, tidy};
use crate::error::Result;
use crate::job::{Room, Run};
use std::collections::BTreeSet;

/// How often a vertex is moved while nothing but that is done.
const TRIES: u8 = 20;
/// How vertices are moved at first.
const FIRST: Way = Way { leave: 0.5, beyond: 0.8 };
/// What is tried about a part that is stuck: how far round it vertices begin anew, and how they are moved then. No one way helps everywhere.
const ANEW: [(usize, Way); 8] = [
    (0, FIRST),
    (0, Way { leave: 0.1, beyond: 0.5 }),
    (1, FIRST),
    (1, Way { leave: 0.1, beyond: 0.5 }),
    (1, Way { leave: 0.8, beyond: 0.2 }),
    (2, Way { leave: 0.5, beyond: 0.5 }),
    (2, Way { leave: 0.8, beyond: 0.8 }),
    (2, Way { leave: 0.01, beyond: 0.2 }),
];
/// Where so many parts are folded an attempt is given up, and how much farther round vertices begin anew: first few, since most attempts that help do so with few.
const TOO_MANY: [(usize, usize); 2] = [(100, 0), (1000, 2)];
/// The steps to the place where everything is right.
const STEPS: u8 = 16;
/// How far from its Voronoi vertex a vertex stays that goes back there as far as may be.
const BACK: [f64; 8] = [0.0, 0.03125, 0.0625, 0.125, 0.25, 0.5, 0.75, 0.875];

impl Mended<'_> {
    /// Moves vertices until nothing is folded, and back as far as may be.
    pub(super) fn unfold(
        &mut self,
        folded: Vec<Part>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let mut stuck = self.relax(folded, FIRST, usize::MAX, room, run)?;
        for (most, more) in TOO_MANY {
            stuck = self.begin_anew(stuck, [most, more], room, run)?;
        }
        self.step_all(stuck, usize::MAX, room, run)?;
        self.go_back(run)?;
        Ok(())
    }

    /// Moves vertices one at a time, as long as there is less and less of what is turned. Returns what stays folded.
    ///
    /// It ends, since a vertex is tried so often at most.
    fn relax(
        &mut self,
        mut folded: Vec<Part>,
        way: Way,
        most: usize,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<Part>> {
        let mut tried = Vec::new();
        folded.retain(|&part| self.is_folded(part));
        while !folded.is_empty() && folded.len() <= most {
            let mut touched = Vec::new();
            for &part in &folded {
                run.poll()?;
                for vertex in self.turned_vertices(part) {
                    if self.tries[vertex as usize] < TRIES && self.is_any_folded(vertex) {
                        self.tries[vertex as usize] += 1;
                        room.push(&mut tried, vertex)?;
                        if self.improve(vertex, way) {
                            room.push(&mut touched, vertex)?;
                        }
                    }
                }
            }
            if touched.is_empty() {
                break;
            }
            folded.retain(|&part| self.is_folded(part));
            folded.extend(self.folded_at(&touched));
            folded.sort_unstable();
            folded.dedup();
        }
        tried.iter().for_each(|&v| self.tries[v as usize] = 0);
        Ok(folded)
    }

    /// Lets the vertices round each part that is stuck begin anew, at their targets or where they came from, and goes on where less is folded then. Returns what stays folded.
    fn begin_anew(
        &mut self,
        stuck: Vec<Part>,
        [most, more]: [usize; 2],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<Part>> {
        let mut left = Vec::new();
        let mut waiting: BTreeSet<Part> = stuck.into_iter().collect();
        while let Some(part) = waiting.pop_first() {
            if !self.is_folded(part) {
                continue;
            }
            let mut is_done = false;
            if self.planes_left == 0 {
                left.push(part);
                continue;
            }
            for how in 0..=2 * ANEW.len() {
                self.was.clear();
                if let Some(&(rings, way)) = ANEW.get(how / 2) {
                    let vertices = self.round(part, rings + more);
                    for &vertex in &vertices {
                        if how % 2 == 0 {
                            self.put(vertex, self.target(vertex));
                        } else {
                            self.put_back(vertex);
                        }
                    }
                    let mut folded = self.folded_at(&vertices);
                    folded.push(part);
                    self.relax(folded, way, most, room, run)?;
                } else {
                    self.step_all(vec![part], most, room, run)?;
                }
                // What else was folded there before.
                let mut touched: Vec<u32> = self.was.iter().map(|was| was.0).collect();
                touched.sort_unstable();
                touched.dedup();
                let folded_there = self.folded_at(&touched);
                let mut there: Vec<Part> = touched.iter().flat_map(|&v| self.parts_at(v)).collect();
                there.sort_unstable();
                there.dedup();
                let before = 1 + there.iter().filter(|part| waiting.contains(part)).count();
                if folded_there.len() < before && !folded_there.contains(&part) {
                    waiting.extend(folded_there);
                    is_done = true;
                    break;
                }
                self.take_back();
            }
            if !is_done {
                left.push(part);
            }
        }
        self.was = Vec::new();
        left.retain(|&part| self.is_folded(part));
        Ok(left)
    }

    /// The turned vertices of a part, and those so many parts away.
    fn round(&self, part: Part, rings: usize) -> Vec<u32> {
        let mut vertices = self.turned_vertices(part);
        let mut begin = 0;
        for _ in 0..rings {
            let end = vertices.len();
            let mut next: Vec<u32> = Vec::new();
            for &vertex in &vertices[begin..end] {
                for part in self.parts_at(vertex) {
                    next.extend(self.cells_of(part));
                    if let Part::Facet(facet) = part {
                        next.push(self.middle_of(facet));
                    }
                }
            }
            next.sort_unstable();
            next.dedup();
            next.retain(|v| !vertices.contains(v));
            begin = end;
            vertices.extend(next);
        }
        vertices
    }

    /// Lets what is turned go to its targets step by step.
    ///
    /// It ends, since each vertex goes so many steps at most, and succeeds, since then everything is right.
    fn step_all(
        &mut self,
        mut folded: Vec<Part>,
        most: usize,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        if folded.is_empty() {
            return Ok(());
        }
        let mut steps = room.filled(self.places.len(), 0u8)?;
        while !folded.is_empty() && folded.len() <= most {
            let mut touched = Vec::new();
            for &part in &folded {
                run.poll()?;
                let mut vertices = self.turned_vertices(part);
                // What cannot go on is as right as rounding lets it be.
                vertices.retain(|&v| steps[v as usize] < STEPS);
                for &vertex in &vertices {
                    let share = 1.0 / f64::from(STEPS - steps[vertex as usize]);
                    steps[vertex as usize] += 1;
                    self.put(
                        vertex,
                        tidy(between(self.places[vertex as usize], self.target(vertex), share)),
                    );
                }
                room.grow(&mut touched, vertices.len())?;
                touched.extend(vertices);
            }
            for &vertex in &touched {
                run.poll()?;
                if steps[vertex as usize] < STEPS {
                    self.improve(vertex, FIRST);
                }
            }
            if most == usize::MAX {
                self.was.clear();
            }
            folded = self.folded_at(&touched);
        }
        Ok(())
    }

    /// Undoes all moves that are remembered.
    fn take_back(&mut self) {
        while let Some((v, place, is_moved)) = self.was.pop() {
            (self.places[v as usize], self.is_moved[v as usize]) = (place, is_moved);
        }
    }

    fn is_any_folded(&self, vertex: u32) -> bool {
        self.parts_at(vertex).iter().any(|&part| self.is_folded(part))
    }

    /// Lets each vertex of a cell that was moved go back to where it came from as far as nothing folds.
    fn go_back(&mut self, run: &Run<'_>) -> Result<()> {
        for v in run.watch(0..self.parts.cells.len()) {
            let v = v?;
            if !self.is_moved[v] {
                continue;
            }
            run.poll()?;
            let vertex = v as u32;
            let (place, home) = (self.places[v], self.home(vertex));
            let is_voronoi = home == self.dual.centers()[self.parts.cells[v] as usize];
            let folded_before = self.folded_at(&[vertex]).len();
            for share in BACK {
                self.places[v] = tidy(between(home, place, share));
                self.is_moved[v] = share > 0.0 || !is_voronoi;
                if self.folded_at(&[vertex]).len() <= folded_before {
                    break;
                }
                (self.places[v], self.is_moved[v]) = (place, true);
            }
        }
        Ok(())
    }
}
