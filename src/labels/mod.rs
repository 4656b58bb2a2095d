//! Labelled triangulations: which cells lie in the solid.
//!
//! Inner axes, and whatever else asks on which side of the surface a part of the Voronoi diagram is, take these labels, wherever
//! they come from. See `docs/algorithms/labels.md`.

mod cocone;
mod crust;
mod mesh;

use crate::error::{ElementKind, Error, Result, Status};
use crate::triangulation::Triangulation;
use std::sync::Arc;

/// For each cell of a Delaunay triangulation of samples whether it lies in the solid.
///
/// Where a mesh or a power crust tells, a cell is inner if its Voronoi vertex, the centre of its circumscribed sphere, lies in the solid, and not its barycentre: a flat cell
/// that lies in the surface is nowhere, but its Voronoi vertex may be far away, and then it is outside. Tight Cocone, which
/// goes by the Voronoi edges that cross the surface, tells the same. Invariant: one label for each cell.
#[derive(Clone, Debug)]
pub struct Labels {
    triangulation: Arc<Triangulation>,
    is_inner: Vec<bool>,
}

impl Labels {
    /// Labels that the host has found: one for each cell.
    ///
    /// Errors: [`Status::Mismatch`] if they are more or fewer, with their number.
    pub fn new(triangulation: &Arc<Triangulation>, is_inner: Vec<bool>) -> Result<Self> {
        let cells = triangulation.cells().len();
        if is_inner.len() != cells {
            let message = format!("{} labels for {cells} cells", is_inner.len());
            return Err(
                Error::new(Status::Mismatch, message).at(ElementKind::Cell, is_inner.len() as u64)
            );
        }
        Ok(Labels { triangulation: triangulation.clone(), is_inner })
    }

    /// The triangulation whose cells have the labels.
    pub fn triangulation(&self) -> &Arc<Triangulation> {
        &self.triangulation
    }

    /// Whether each cell is inner.
    pub fn is_inner(&self) -> &[bool] {
        &self.is_inner
    }

    /// The number of inner cells.
    pub fn inner_count(&self) -> usize {
        self.is_inner.iter().filter(|&&inner| inner).count()
    }

    /// In how many cells other labels differ.
    ///
    /// Errors: [`Status::Mismatch`] for labels of another triangulation.
    pub fn disagreement(&self, other: &Labels) -> Result<usize> {
        self.check_triangulation(&other.triangulation)?;
        Ok(self.is_inner.iter().zip(&other.is_inner).filter(|(a, b)| a != b).count())
    }

    /// Whether these are labels of the given triangulation, or of an equal one. Errors: [`Status::Mismatch`] if not.
    pub(crate) fn check_triangulation(&self, other: &Arc<Triangulation>) -> Result<()> {
        let same = Arc::ptr_eq(&self.triangulation, other)
            || (self.triangulation.cells() == other.cells()
                && self.triangulation.coords() == other.coords());
        match same {
            true => Ok(()),
            false => {
                Err(Error::new(Status::Mismatch, "the labels are those of another triangulation"))
            }
        }
    }
}
