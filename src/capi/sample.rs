//! Samples
//!
//! Points of the surfaces of built-in shapes and of meshes, evenly spread: no two are nearer than
//! the spacing. The same options give the same points on every machine.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_job, medax_samples};
use super::options::{self, Report, SizedStruct, sized_struct};
use super::status::medax_status;
use super::view::{Out, medax_view_f64};
use crate::error::{Error, Result, Status};
use crate::sample::{SampleOptions, Samples, Shape, sample, sample_mesh};
use std::ffi::{CStr, c_char};
use std::ptr;
use std::sync::Arc;

/// A solid of known form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_shape {
    /// A torus about the z axis: core circle of radius 1, tube of radius 0.4.
    Torus = 0,
    /// A box of sides 2, 1.5 and 1 about the origin.
    Box = 1,
    /// All points within 0.5 of the segment from (-1, 0, 0) to (1, 0, 0).
    Capsule = 2,
    /// An ellipsoid with half axes 1.4, 1 and 0.7 along x, y and z.
    Ellipsoid = 3,
    /// A tube of radius 0.3 about the trefoil knot.
    Trefoil = 4,
    /// Three tori in a row, blended into one smooth surface.
    Genus3 = 5,
    /// A bracket: two plates at a right angle, two holes through one, one through the other.
    Bracket = 6,
    /// The unit ball.
    Sphere = 7,
}

/// Every shape with its number and name in C.
const SHAPES: [(Shape, medax_shape, &CStr); 8] = [
    (Shape::Torus, medax_shape::Torus, c"torus"),
    (Shape::Box, medax_shape::Box, c"box"),
    (Shape::Capsule, medax_shape::Capsule, c"capsule"),
    (Shape::Ellipsoid, medax_shape::Ellipsoid, c"ellipsoid"),
    (Shape::Trefoil, medax_shape::Trefoil, c"trefoil"),
    (Shape::Genus3, medax_shape::Genus3, c"genus3"),
    (Shape::Bracket, medax_shape::Bracket, c"bracket"),
    (Shape::Sphere, medax_shape::Sphere, c"sphere"),
];

fn shape(number: u32) -> Result<Shape> {
    let found = SHAPES.iter().find(|entry| entry.1 as u32 == number);
    found.map(|entry| entry.0).ok_or_else(|| {
        Error::new(Status::InvalidArgument, format!("{number} is not the number of a shape"))
    })
}

/// The name of a shape, such as `torus`.
///
/// \param shape A #medax_shape; shapes are numbered from 0 without a gap.
/// \return A static string; empty for a number that is no shape; never NULL.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub extern "C" fn medax_shape_name(shape: u32) -> *const c_char {
    let found = SHAPES.iter().find(|entry| entry.1 as u32 == shape);
    found.map_or(c"", |entry| entry.2).as_ptr()
}

/// What is known of a shape. The caller sets `struct_size`, the library the rest.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_shape_facts {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The least coordinates of a box that holds the shape.
    pub min: [f64; 3],
    /// The greatest coordinates of that box.
    pub max: [f64; 3],
    /// The spacing that samples have by default: a quarter of the least local feature size of a
    /// smooth shape, about a sixth of the thinnest part of a sharp one.
    pub spacing: f64,
    /// The genus of the surface.
    pub genus: u32,
    /// The number of pieces of the surface.
    pub components: u32,
    /// 1 if the surface has a tangent plane everywhere.
    pub smooth: u32,
    /// 0.
    pub reserved: u32,
}

sized_struct!(medax_shape_facts, first_size: size_of::<medax_shape_facts>(), reserved: none, {
    min: [f64; 3] = [0.0; 3],
    max: [f64; 3] = [0.0; 3],
    spacing: f64 = 0.0,
    genus: u32 = 0,
    components: u32 = 0,
    smooth: u32 = 0,
    reserved: u32 = 0,
});

/// What is known of a shape.
///
/// \param shape A #medax_shape.
/// \param out_facts Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a number that is no shape or
///         facts of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_shape_describe(
    shape: u32,
    out_facts: *mut medax_shape_facts,
) -> medax_status {
    boundary::status(|| {
        let shape = self::shape(shape)?;
        let report = Report::new(out_facts, "out_facts")?;
        report.fill(&medax_shape_facts {
            min: shape.bounds().min,
            max: shape.bounds().max,
            spacing: shape.spacing(),
            genus: shape.genus(),
            components: shape.components(),
            smooth: u32::from(shape.is_smooth()),
            ..medax_shape_facts::DEFAULT
        });
        Ok(())
    })
}

/// How densely to sample, and how much noise to add.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_sample_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// No two samples are nearer than this, before noise; in input units. 0, the default: that of the
    /// shape, or a hundredth of the diagonal of a mesh's bounding box.
    pub spacing: f64,
    /// Instead of the spacing: about how many samples a unit of area gets. 0, the default: the
    /// spacing says it.
    pub density: f64,
    /// The standard deviation of Gaussian noise along the normal, in input units; 0 by default, and at
    /// most a million times the diagonal of the surface's bounding box.
    pub noise: f64,
    /// Which of the many samples, 0 by default: the same seed gives the same points.
    pub seed: u64,
}

sized_struct!(medax_sample_options, first_size: size_of::<medax_sample_options>(),
    reserved: none, {
    spacing: f64 = 0.0,
    density: f64 = 0.0,
    noise: f64 = 0.0,
    seed: u64 = 0,
});

impl medax_sample_options {
    fn translate(&self) -> SampleOptions {
        let &medax_sample_options { spacing, density, noise, seed, .. } = self;
        SampleOptions { spacing, density, noise, seed }
    }
}

/// Sets sample options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sample_options_init(
    options: *mut medax_sample_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Samples the surface of a built-in shape.
///
/// \param shape A #medax_shape.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_samples Receives the samples, which the caller frees with #medax_samples_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a number that is no shape, an option that is
///         negative or not finite, both a spacing and a density, or more noise than is allowed;
///         `LIMIT_EXCEEDED` past 2^27 samples; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// About 100 evaluations of the shape for each of 64 candidates a square of the spacing. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_build(
    shape: u32,
    options: *const medax_sample_options,
    job: *const medax_job,
    out_samples: *mut *const medax_samples,
) -> medax_status {
    boundary::status(|| {
        let shape = self::shape(shape)?;
        let options = options::read(options, "options")?.translate();
        let out = Out::new(out_samples, "out_samples")?;
        let mut own = None;
        let samples = sample(shape, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_samples { samples }));
        Ok(())
    })
}

/// Samples the faces of a mesh.
///
/// \param mesh The mesh.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_samples Receives the samples, which the caller frees with #medax_samples_free.
/// \return As #medax_samples_build; also `DEGENERATE` if no face has an area, `COORDINATE_RANGE` if
///         the area or the diagonal overflows.
///
/// O(log triangles) for each of 64 candidates a square of the spacing. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_build_from_mesh(
    mesh: *const medax_complex,
    options: *const medax_sample_options,
    job: *const medax_job,
    out_samples: *mut *const medax_samples,
) -> medax_status {
    boundary::status(|| {
        let mesh = &handle::get(mesh, "mesh")?.complex;
        let options = options::read(options, "options")?.translate();
        let out = Out::new(out_samples, "out_samples")?;
        let mut own = None;
        let samples = sample_mesh(mesh, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_samples { samples }));
        Ok(())
    })
}

/// The samples, noise included.
///
/// \param samples The samples, or NULL.
/// \return n x 3 coordinates, in input units. Borrowed from `samples`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_coords(samples: *const medax_samples) -> medax_view_f64 {
    floats(samples, Samples::points)
}

/// The outward unit normals of the surface where samples were taken; on an edge that of one of its
/// sides.
///
/// \param samples The samples, or NULL.
/// \return n x 3. Borrowed from `samples`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_normals(samples: *const medax_samples) -> medax_view_f64 {
    floats(samples, Samples::normals)
}

unsafe fn floats(
    samples: *const medax_samples,
    read: fn(&Samples) -> &[[f64; 3]],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], 3), || {
        let rows = handle::maybe(samples).map_or(&[][..], |s| read(&s.samples));
        medax_view_f64::new(rows.as_flattened(), 3)
    })
}

/// The least distance between two samples, before noise.
///
/// \param samples The samples; NULL has 0.
/// \return A length in input units.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_spacing(samples: *const medax_samples) -> f64 {
    boundary::value(0.0, || handle::maybe(samples).map_or(0.0, |s| s.samples.spacing()))
}

/// The area of the surface as the number of candidates tells it, to about a per cent.
///
/// \param samples The samples; NULL has 0.
/// \return An area in squared input units.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_area(samples: *const medax_samples) -> f64 {
    boundary::value(0.0, || handle::maybe(samples).map_or(0.0, |s| s.samples.area()))
}

/// The samples as vertices with the attribute `normal`, for writing to a file.
///
/// \param samples The samples.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_complex(
    samples: *const medax_samples,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let samples = &handle::get(samples, "samples")?.samples;
        let out = Out::new(out_complex, "out_complex")?;
        out.put(complex::give(Arc::new(samples.to_complex()?)));
        Ok(())
    })
}

/// One more reference to samples.
///
/// \param samples The samples, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_clone(
    samples: *const medax_samples,
) -> *const medax_samples {
    boundary::value(ptr::null(), || handle::clone(samples))
}

/// Gives one reference to samples back; the last one frees them.
///
/// \param samples The samples; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_samples_free(samples: *const medax_samples) {
    boundary::value((), || handle::free(samples));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_keeps_its_number_and_name() {
        assert_eq!(SHAPES.map(|entry| entry.0), Shape::ALL);
        for (shape, number, name) in SHAPES {
            assert_eq!(number as u32, shape as u32);
            assert_eq!(name.to_str().unwrap(), shape.name());
        }
    }
}
