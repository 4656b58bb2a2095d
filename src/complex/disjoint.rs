//! Disjoint sets.

use crate::error::Result;
use crate::job::Run;

/// A partition of `0..len` that only ever grows coarser.
///
/// The root of a set is its least element, so that roots do not depend on the order of unions.
pub(crate) struct DisjointSets {
    parent: Vec<u32>,
}

impl DisjointSets {
    /// Every element on its own.
    pub(crate) fn new(len: usize, run: &Run<'_>) -> Result<Self> {
        let mut parent = run.try_vec(len)?;
        parent.extend(0..len as u32);
        Ok(DisjointSets { parent })
    }

    /// The root of the element's set.
    pub(crate) fn root(&mut self, mut i: u32) -> u32 {
        while self.parent[i as usize] != i {
            let above = self.parent[self.parent[i as usize] as usize];
            self.parent[i as usize] = above;
            i = above;
        }
        i
    }

    /// Joins the sets of two elements; returns whether they were apart.
    pub(crate) fn join(&mut self, i: u32, j: u32) -> bool {
        let (i, j) = (self.root(i), self.root(j));
        let (least, other) = (i.min(j), i.max(j));
        self.parent[other as usize] = least;
        least != other
    }
}
