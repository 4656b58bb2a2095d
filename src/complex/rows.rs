//! Rows of varying length.

use crate::error::{Error, Result, Status};
use crate::job::Room;

/// Rows of varying length in two flat arrays: row `i` is `indices[offsets[i]..offsets[i + 1]]`.
///
/// Invariant: `offsets` starts with 0, never falls, and ends with `indices.len()`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rows {
    offsets: Vec<u32>,
    indices: Vec<u32>,
}

impl Default for Rows {
    fn default() -> Self {
        Rows { offsets: vec![0], indices: Vec::new() }
    }
}

impl Rows {
    /// The given arrays, if they keep the invariant.
    pub fn new(offsets: Vec<u32>, indices: Vec<u32>) -> Result<Self> {
        let sound = offsets.first() == Some(&0)
            && offsets.windows(2).all(|pair| pair[0] <= pair[1])
            && offsets.last().map(|&last| last as usize) == Some(indices.len());
        if !sound {
            return Err(Error::new(
                Status::InvalidArgument,
                "row offsets must start at 0, never fall, and end at the number of indices",
            ));
        }
        Ok(Rows { offsets, indices })
    }

    /// Rows of equal length. Errors: [`Status::LimitExceeded`] past 2^32 - 1 indices, and those of the job.
    pub(crate) fn uniform_in<const N: usize>(
        rows: Vec<[u32; N]>,
        room: &mut Room<'_>,
    ) -> Result<Self> {
        if rows.len() > u32::MAX as usize / N {
            return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 1 indices"));
        }
        let offsets = room.collect((0..rows.len() + 1).map(|i| (N * i) as u32))?;
        Ok(Rows { offsets, indices: rows.into_flattened() })
    }

    /// Appends one row. Errors: [`Status::LimitExceeded`] past 2^32 - 1 indices.
    pub fn push(&mut self, row: &[u32]) -> Result<()> {
        let end = u32::try_from(self.indices.len() + row.len())
            .map_err(|_| Error::new(Status::LimitExceeded, "more than 2^32 - 1 indices"))?;
        self.indices.extend_from_slice(row);
        self.offsets.push(end);
        Ok(())
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Row `i`.
    pub fn row(&self, i: usize) -> &[u32] {
        &self.indices[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }

    /// Every row in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.len()).map(|i| self.row(i))
    }

    /// Where each row begins; one more entry than rows.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// All rows, one after the other.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }
}
