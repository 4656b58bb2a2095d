//! Writing a complex or points, and saying what the format does not hold.

use super::sink::Sink;
use super::{Format, file, geojson, ma, obj, off, ply, stl, vtu, xyz};
use crate::complex::{Complex, ComplexParts, Element};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Stage};
use crate::points::Points;
use std::path::Path;

/// How to write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WriteOptions {
    /// Write PLY as text. Without it, PLY is binary, little endian.
    pub text: bool,
}

/// Writes a complex in the format that the path's ending names, and returns a sentence for each
/// thing that the file does not hold.
///
/// Errors: [`Status::Unsupported`] for an unknown ending, for a format that is not written, and
/// where the format can hold nothing of the complex, as GeoJSON of one in space; [`Status::CoordinateRange`] with the vertex where
/// STL's single precision is too small; [`Status::Io`]. After an error, a file that was there before
/// is as it was.
pub fn write_complex(
    path: impl AsRef<Path>,
    complex: &Complex,
    options: WriteOptions,
    job: &Job,
) -> Result<Vec<String>> {
    let (path, format) = (path.as_ref(), Format::of_path(&path)?);
    job.run(&[(Stage::Write, 1.0)], |run| {
        run.enter(Stage::Write)?;
        file::replace(path, |out| {
            let kinds = [Element::Vertex, Element::Edge, Element::Face, Element::Cell];
            let rows = kinds.iter().map(|kind| complex.element_count(*kind)).sum();
            let mut sink = Sink::new(out, rows, run);
            warn_losses(complex, format, &mut sink)?;
            match format {
                Format::Ply => ply::write(complex, options.text, &mut sink)?,
                Format::Off => off::write(complex, &mut sink)?,
                Format::Obj => obj::write(complex, &mut sink)?,
                Format::Stl => stl::write(complex, &mut sink)?,
                Format::Xyz => xyz::write(complex, ' ', &mut sink)?,
                Format::Csv => xyz::write(complex, ',', &mut sink)?,
                Format::Ma => ma::write(complex, &mut sink)?,
                Format::Vtu => vtu::write(complex, &mut sink)?,
                Format::GeoJson => geojson::write(complex, &mut sink)?,
                Format::Pwn => {}
            }
            sink.finish()
        })
    })
}

/// Writes the distinct points in the order of their vertices.
///
/// Errors: as [`write_complex`].
pub fn write_points(
    path: impl AsRef<Path>,
    points: &Points,
    options: WriteOptions,
    job: &Job,
) -> Result<Vec<String>> {
    let vertices = points.coords().to_vec();
    let complex = Complex::new(ComplexParts { vertices, ..ComplexParts::default() })?;
    write_complex(path, &complex, options, job)
}

/// Says what a format does not hold; an error where nothing would be left.
fn warn_losses(complex: &Complex, format: Format, out: &mut Sink<'_>) -> Result<()> {
    let name = format.name();
    let unsupported = |what: String| Err(Error::new(Status::Unsupported, what));
    if !format.is_written() {
        return unsupported(format!("medax reads {name} and does not write it"));
    }
    if format == Format::GeoJson {
        geojson::check(complex)?;
    }
    if format == Format::Stl && complex.faces().is_empty() {
        return unsupported("STL holds faces, and there is none; write PLY".to_string());
    }
    let is_table = matches!(format, Format::Xyz | Format::Csv);
    let holds = |element: Element| match element {
        Element::Vertex => format != Format::Stl,
        Element::Edge => !is_table && !matches!(format, Format::Off | Format::Stl),
        Element::Face => !is_table,
        Element::Cell => format == Format::Vtu,
    };
    let names =
        [(Element::Edge, "loose edges"), (Element::Face, "faces"), (Element::Cell, "volume cells")];
    for (element, what) in names {
        let count = complex.element_count(element);
        if count > 0 && !holds(element) {
            out.warn(format!("{name} holds no {what}: {count} were left out"));
        }
    }
    for attribute in complex.attributes() {
        let (element, what) = (attribute.element(), attribute.name());
        let held = match format {
            Format::Ply | Format::Vtu | Format::GeoJson => holds(element),
            Format::Ma => element == Element::Vertex && what == "radius",
            _ => false,
        };
        // With the elements their attributes go, which needs no saying.
        let is_told = element != Element::Vertex && !holds(element);
        if !held && !is_told {
            let of = format!("{element:?}").to_lowercase();
            out.warn(format!(
                "{name} has no place for the {of} attribute '{what}': it was left out"
            ));
        }
    }
    if matches!(format, Format::Stl | Format::Ma) {
        let count = complex.faces().iter().filter(|face| face.len() > 3).count();
        if count > 0 {
            out.warn(format!("{name} holds triangles only: {count} polygons were cut up"));
        }
    }
    if format == Format::Stl { warn_precision(complex, out) } else { Ok(()) }
}

/// Says what STL does to vertices: single precision, and no place for one without a face.
fn warn_precision(complex: &Complex, out: &mut Sink<'_>) -> Result<()> {
    let mut used = vec![false; complex.vertices().len()];
    complex.faces().indices().iter().for_each(|&v| used[v as usize] = true);
    let (mut unused, mut rounded) = (0, 0);
    for (v, (xyz, used)) in complex.vertices().iter().zip(used).enumerate() {
        let single = xyz.map(|x| f64::from(x as f32));
        if !used {
            unused += 1;
        } else if single.iter().any(|x| x.is_infinite()) {
            let message = "STL has single precision, and a coordinate is past its range; write PLY";
            return Err(
                Error::new(Status::CoordinateRange, message).at(ElementKind::Vertex, v as u64)
            );
        } else if single != *xyz {
            rounded += 1;
        }
    }
    if unused > 0 {
        out.warn(format!("STL holds faces only: {unused} vertices without one were left out"));
    }
    if rounded > 0 {
        out.warn(format!("STL has single precision: {rounded} vertices were rounded"));
    }
    Ok(())
}
