//! The surface of some cells.

use super::Triangulation;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, parts};

impl Triangulation {
    /// The facets between inner cells and outer ones or the hull, as the inner cell and the facet's number, ascending.
    pub(crate) fn boundary_of(
        &self,
        is_inner: &[bool],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<[u32; 2]>> {
        let pieces = run.in_parallel(parts(is_inner.len()), |range| {
            run.poll()?;
            let mut room = Room::new(run);
            let mut facets: Vec<[u32; 2]> = Vec::new();
            for cell in range.filter(|&cell| is_inner[cell]) {
                for (i, &next) in self.neighbors()[cell].iter().enumerate() {
                    if next == NONE || !is_inner[next as usize] {
                        room.push(&mut facets, [cell as u32, i as u32])?;
                    }
                }
            }
            Ok((facets, room))
        })?;
        let mut facets = room.vec(pieces.iter().map(|(piece, _)| piece.len()).sum())?;
        for (piece, _) in pieces {
            facets.extend(piece);
        }
        Ok(facets)
    }
}
