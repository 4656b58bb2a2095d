//! Which sites the nearest points of a medial point may lie on: what makes a medial axis a Voronoi diagram (Stolpner, Whitesides, section VII-A).

use super::locate::MedialPoint;
use super::sites::Sites;
use crate::error::{ElementKind, Error, Result, Status};

/// The pairs of sites that are asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct SitePairs {
    /// Two different ones.
    between_sites: bool,
    /// One of these: in each the lesser first, ascending.
    chosen: Option<Vec<[u32; 2]>>,
}

impl SitePairs {
    /// All pairs, or those of different sites.
    pub fn any(between_sites: bool) -> Self {
        SitePairs { between_sites, chosen: None }
    }

    /// Chosen pairs, either site first. Errors: [`Status::InvalidArgument`] with the row of a pair that names a site that is not there.
    pub fn of(sites: &Sites, between_sites: bool, pairs: &[[u32; 2]]) -> Result<Self> {
        let count = sites.site_count();
        if let Some(row) = pairs.iter().position(|pair| pair.iter().any(|&site| site >= count)) {
            let message = format!("a pair names a site that is not among the {count} of them");
            return Err(
                Error::new(Status::InvalidArgument, message).at(ElementKind::Row, row as u64)
            );
        }
        let mut chosen: Vec<_> = pairs.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        chosen.sort_unstable();
        chosen.dedup();
        Ok(SitePairs { between_sites, chosen: Some(chosen) })
    }

    /// Whether a point has its nearest points on such a pair.
    pub fn holds(&self, sites: &Sites, point: &MedialPoint) -> bool {
        let [a, b] = point.pieces.map(|piece| sites.site_of_piece()[piece as usize]);
        let is_chosen = |chosen: &Vec<_>| chosen.binary_search(&[a.min(b), a.max(b)]).is_ok();
        !(self.between_sites && a == b) && self.chosen.as_ref().is_none_or(is_chosen)
    }
}
