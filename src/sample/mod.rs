//! Points of built-in shapes and of meshes.
//!
//! Uniform random candidates of the surface (crossings with random lines, or a
//! parameterisation, or a mesh's triangles) are thinned to a Poisson-disk sample: a candidate is
//! kept if no kept one is nearer than the spacing. So no two samples are nearer than the spacing, and
//! every candidate has a sample within it. There are [`CANDIDATES`] candidates to a square of
//! that side, which leaves no point of the surface without a sample within about 1.3 spacings.
//!
//! Everything is a function of the shape and the options: the random numbers are the crate's
//! own.

mod axis;
mod lines;
mod random;
mod shape;
mod solids;
mod thin;
mod trefoil;
mod triangles;

pub use shape::Shape;

use crate::complex::{Attribute, Complex, ComplexParts, Element, Values};
use crate::error::{Error, Result, Status};
use crate::job::{Job, Run, Stage};
use crate::points::{Bounds, POINT_LIMIT};
use crate::vector::{Vec3, add, scale};
use lines::Lines;
use random::Random;
use thin::Thinning;
use trefoil::Tube;
use triangles::Triangles;

/// How many candidates are thrown for every square of the surface whose side is the spacing.
pub const CANDIDATES: f64 = 64.0;
/// How many samples such a square keeps: what random packing of discs reaches with
/// [`CANDIDATES`] candidates, a little less than its limit 0.547 * 4 / pi = 0.696 (Feder 1980).
const KEPT: f64 = 0.65;
/// How many diagonals of the bounding box the noise may have: far more than leaves anything of a shape, and
/// too few to overflow.
const NOISE_LIMIT: f64 = 1e6;
/// How many throws there are between two reports of progress.
const BATCH: usize = 256;

/// How densely to sample, and how much noise to add. All zeros are the defaults.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SampleOptions {
    /// No two samples are nearer than this, before noise; in input units. 0 means the default:
    /// [`Shape::spacing`] for a shape, a hundredth of the bounding box's diagonal for a mesh.
    pub spacing: f64,
    /// Instead of the spacing: about how many samples a unit of area shall get. 0 means that the
    /// spacing says it.
    pub density: f64,
    /// The standard deviation of Gaussian noise along the normal, in input units; at most a million times
    /// the diagonal of the surface's bounding box.
    pub noise: f64,
    /// Which of the many samples: the same seed gives the same points.
    pub seed: u64,
}

/// Points of a surface with the surface's outward unit normals.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    points: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    spacing: f64,
    area: f64,
}

impl Samples {
    /// The samples, noise included, in input units.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// For each sample the outward unit normal of the surface where it was taken. On an edge it
    /// is that of one of the sides.
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.normals
    }

    /// The least distance between two samples, before noise.
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// The area of the surface as the number of candidates tells it, to about a per cent.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The samples as vertices with the attribute `normal`, for writing to a file.
    pub fn to_complex(&self) -> Result<Complex> {
        let values = Values::F64(self.normals.as_flattened().to_vec());
        Complex::new(ComplexParts {
            vertices: self.points.clone(),
            attributes: vec![Attribute::new("normal", Element::Vertex, 3, values)?],
            ..ComplexParts::default()
        })
    }
}

/// Samples a built-in shape.
///
/// Errors: [`Status::InvalidArgument`] for an option that is negative or not finite, both
/// a spacing and a density, or more noise than is allowed; [`Status::LimitExceeded`] if there would be more than 2^27 samples.
/// Cost: about 100 evaluations of the implicit function for every candidate.
pub fn sample(shape: Shape, options: SampleOptions, job: &Job) -> Result<Samples> {
    job.run(&[(Stage::Sample, 1.0)], |run| sample_in(shape, options, run))
}

/// [`sample`] as a stage of a larger build.
pub(crate) fn sample_in(shape: Shape, options: SampleOptions, run: &Run<'_>) -> Result<Samples> {
    let bounds = shape.bounds();
    let spacing = options.spacing_or(shape.spacing(), bounds.diagonal())?;
    match shape {
        Shape::Trefoil => take(&Tube, spacing, bounds.min, options, run),
        _ => take(&Lines::new(shape), spacing, bounds.min, options, run),
    }
}

/// Samples the faces of a mesh, each point of a triangle with the triangle's normal.
///
/// Errors: as [`sample`]; [`Status::Degenerate`] if no triangle has an area,
/// [`Status::CoordinateRange`] if the area or the diagonal overflows. Cost: O(log triangles) for every candidate.
pub fn sample_mesh(mesh: &Complex, options: SampleOptions, job: &Job) -> Result<Samples> {
    job.run(&[(Stage::Sample, 1.0)], |run| sample_mesh_in(mesh, options, run))
}

/// [`sample_mesh`] as a stage of a larger build.
pub(crate) fn sample_mesh_in(
    mesh: &Complex,
    options: SampleOptions,
    run: &Run<'_>,
) -> Result<Samples> {
    let triangles = Triangles::new(mesh)?;
    let bounds = Bounds::of(mesh.vertices().iter().copied());
    let (origin, diagonal) = bounds.map_or(([0.0; 3], 0.0), |b| (b.min, b.diagonal()));
    if !diagonal.is_finite() {
        return Err(triangles::too_large());
    }
    let spacing = options.spacing_or(diagonal / 100.0, diagonal)?;
    take(&triangles, spacing, origin, options, run)
}

impl SampleOptions {
    /// Checks the options for a surface of this diagonal, and gives the spacing that they ask for.
    fn spacing_or(&self, default: f64, diagonal: f64) -> Result<f64> {
        let named = [("spacing", self.spacing), ("density", self.density), ("noise", self.noise)];
        for (name, value) in named {
            if !value.is_finite() || value < 0.0 {
                return Err(Error::new(
                    Status::InvalidArgument,
                    format!("the {name} must be 0 or a positive number, not {value:?}"),
                ));
            }
        }
        if self.noise > NOISE_LIMIT * diagonal {
            return Err(Error::new(
                Status::InvalidArgument,
                format!(
                    "the noise must be at most a million times the diagonal, {diagonal:?}, not {:?}",
                    self.noise
                ),
            ));
        }
        match (self.spacing > 0.0, self.density > 0.0) {
            (true, true) => {
                let message = "give either a spacing or a density, not both";
                Err(Error::new(Status::InvalidArgument, message))
            }
            (true, false) => Ok(self.spacing),
            (false, true) => Ok((KEPT / self.density).sqrt()),
            (false, false) => Ok(default),
        }
    }
}

/// A point of a surface and its unit normal.
#[derive(Clone, Copy)]
struct Sample {
    point: Vec3,
    normal: Vec3,
}

/// Something that throws uniform random points onto a surface.
trait Source {
    /// How many throws give the surface `density` candidates to a unit of area on average.
    fn throws(&self, density: f64) -> f64;

    /// One throw: no, one or several candidates.
    fn throw(&self, random: &mut Random, into: &mut Vec<Sample>);
}

/// Throws, thins and adds the noise.
fn take(
    source: &impl Source,
    spacing: f64,
    origin: Vec3,
    options: SampleOptions,
    run: &Run<'_>,
) -> Result<Samples> {
    run.enter(Stage::Sample)?;
    let density = CANDIDATES / (spacing * spacing);
    let throws = source.throws(density);
    if throws > CANDIDATES * POINT_LIMIT as f64 {
        return Err(Error::new(
            Status::LimitExceeded,
            format!("a spacing of {spacing} would give more samples than medax takes"),
        ));
    }
    // However large the spacing, some candidates hit.
    let throws = throws.ceil().max(1024.0) as usize;
    let mut random = Random::new(options.seed);
    let mut thinning = Thinning::new(spacing, origin, run);
    let mut candidates = Vec::new();
    let mut thrown = 0usize;
    for i in 0..throws {
        if i % BATCH == 0 {
            run.tick(i, throws)?;
        }
        source.throw(&mut random, &mut candidates);
        thrown += candidates.len();
        for candidate in candidates.drain(..) {
            thinning.offer(candidate)?;
        }
    }
    let mut kept = thinning.into_kept();
    if options.noise > 0.0 {
        for pair in kept.chunks_mut(2) {
            for (sample, shift) in pair.iter_mut().zip(random.normal_pair()) {
                sample.point = add(sample.point, scale(sample.normal, shift * options.noise));
            }
        }
    }
    let _charge = run.charge((kept.len() * size_of::<Sample>()) as u64)?;
    let (mut points, mut normals) = (run.try_vec(kept.len())?, run.try_vec(kept.len())?);
    points.extend(kept.iter().map(|sample| sample.point));
    normals.extend(kept.iter().map(|sample| sample.normal));
    let area = thrown as f64 / (throws as f64 / source.throws(1.0));
    Ok(Samples { points, normals, spacing, area })
}
