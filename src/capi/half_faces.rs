//! Half-faces
//!
//! Every face of every element of a pair-mesh, seen from inside that element, with its edges: for walks through the solid, round edges at which any number of
//! elements meet, and over the inner structure and what wraps it. (Shaham, Shamir, Cohen-Or 2004, section 3.1.)
//!
//! An element's half-faces follow one another, a half-face's half-edges too, counterclockwise seen from outside the element. Those of a pyramid are its base, then its
//! sides; of an element over a triangle the triangle, then its sides; of one between two edges its four sides: sides in the order of the element's ring.

use super::boundary;
use super::handle::{self, medax_half_faces, medax_job, medax_pair};
use super::status::medax_status;
use super::view::{Out, medax_view_u32};
use crate::pair::HalfFaces;
use std::ptr;

/// Makes the half-faces of a pair-mesh.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_half_faces Receives the half-faces, which the caller frees with #medax_half_faces_free.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 2 half-edges; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_build(
    pair: *const medax_pair,
    job: *const medax_job,
    out_half_faces: *mut *const medax_half_faces,
) -> medax_status {
    boundary::status(|| {
        let pair = &handle::get(pair, "pair")?.pair;
        let out = Out::new(out_half_faces, "out_half_faces")?;
        let mut own = None;
        let half_faces = pair.half_faces(handle::job(job, &mut own))?;
        out.put(handle::new(medax_half_faces { half_faces }));
        Ok(())
    })
}

/// Where the half-faces of each element begin.
///
/// \param half_faces The half-faces, or NULL.
/// \return One more entry than elements. Borrowed from `half_faces`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_of_element(
    half_faces: *const medax_half_faces,
) -> medax_view_u32 {
    indices(half_faces, |its| &its.of_element)
}

/// Where the half-edges of each half-face begin.
///
/// \param half_faces The half-faces, or NULL.
/// \return One more entry than half-faces. Borrowed from `half_faces`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_offsets(
    half_faces: *const medax_half_faces,
) -> medax_view_u32 {
    indices(half_faces, |its| &its.offsets)
}

/// The half-face on the other side of each, with the same corners the other way round.
///
/// \param half_faces The half-faces, or NULL.
/// \return One entry a half-face; `MEDAX_NONE` on the boundary. Borrowed from `half_faces`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_duals(
    half_faces: *const medax_half_faces,
) -> medax_view_u32 {
    indices(half_faces, |its| &its.dual)
}

/// The vertex at which each half-edge begins: those of the boundary count first, then the inner ones. It ends where the next one of its half-face begins.
///
/// \param half_faces The half-faces, or NULL.
/// \return One entry a half-edge. Borrowed from `half_faces`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_origins(
    half_faces: *const medax_half_faces,
) -> medax_view_u32 {
    indices(half_faces, |its| &its.origin)
}

/// The half-edge on the other side of each edge within the element. By turns with #medax_half_faces_partners it leads round an edge, from element to element.
///
/// \param half_faces The half-faces, or NULL.
/// \return One entry a half-edge. Borrowed from `half_faces`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_opposites(
    half_faces: *const medax_half_faces,
) -> medax_view_u32 {
    indices(half_faces, |its| &its.opposite)
}

/// The half-edge of the same edge, the other way round, in the dual half-face.
///
/// \param half_faces The half-faces, or NULL.
/// \return One entry a half-edge; `MEDAX_NONE` where there is no dual. Borrowed from `half_faces`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_partners(
    half_faces: *const medax_half_faces,
) -> medax_view_u32 {
    indices(half_faces, |its| &its.partner)
}

/// One more reference to half-faces.
///
/// \param half_faces The half-faces, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_clone(
    half_faces: *const medax_half_faces,
) -> *const medax_half_faces {
    boundary::value(ptr::null(), || handle::clone(half_faces))
}

/// Gives one reference to half-faces back; the last one frees them.
///
/// \param half_faces The half-faces; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_half_faces_free(half_faces: *const medax_half_faces) {
    boundary::value((), || handle::free(half_faces));
}

unsafe fn indices(
    half_faces: *const medax_half_faces,
    read: fn(&HalfFaces) -> &[u32],
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        medax_view_u32::new(handle::maybe(half_faces).map_or(&[][..], |h| read(&h.half_faces)), 1)
    })
}
