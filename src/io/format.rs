//! The file formats, and which of them hold what.

use crate::error::{Error, Result, Status};
use std::path::Path;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Polygon File Format, as text or binary of either byte order.
    Ply,
    /// Geomview's Object File Format, as text.
    Off,
    /// Wavefront's object format, as text.
    Obj,
    /// Stereolithography, as text or binary.
    Stl,
    /// A table of points: a row a line, columns parted by white space or commas.
    Xyz,
    /// The same, written with commas and a line of names.
    Csv,
    /// Points with normals: a count, the points, the normals.
    Pwn,
    /// A medial mesh, the format of Q-MAT and MATFP.
    Ma,
    /// ParaView's unstructured grid.
    Vtu,
    /// Plane figures, and plane complexes in writing.
    GeoJson,
}

/// Every known ending, in the order in which messages list them.
const ENDINGS: [(&str, Format); 12] = [
    ("ply", Format::Ply),
    ("off", Format::Off),
    ("obj", Format::Obj),
    ("stl", Format::Stl),
    ("xyz", Format::Xyz),
    ("pts", Format::Xyz),
    ("txt", Format::Xyz),
    ("csv", Format::Csv),
    ("pwn", Format::Pwn),
    ("ma", Format::Ma),
    ("vtu", Format::Vtu),
    ("geojson", Format::GeoJson),
];

impl Format {
    /// The format that a path's ending names, in either case.
    ///
    /// Errors: [`Status::Unsupported`] for any other ending, with the list of the known ones.
    pub fn of_path(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let found = ENDINGS.iter().find(|(known, _)| ending.as_deref() == Some(*known));
        found.map(|(_, format)| *format).ok_or_else(|| {
            let known: Vec<String> = ENDINGS.iter().map(|(known, _)| format!(".{known}")).collect();
            let what = match ending {
                Some(ending) => format!("the ending '.{}' is not known", ending.escape_debug()),
                None => "the name has no ending".to_string(),
            };
            Error::new(
                Status::Unsupported,
                format!("{what}; the known ones are {}", known.join(" ")),
            )
        })
    }

    /// The name for messages, such as `PLY`.
    pub fn name(self) -> &'static str {
        match self {
            Format::Ply => "PLY",
            Format::Off => "OFF",
            Format::Obj => "OBJ",
            Format::Stl => "STL",
            Format::Xyz => "XYZ",
            Format::Csv => "CSV",
            Format::Pwn => "PWN",
            Format::Ma => "MA",
            Format::Vtu => "VTU",
            Format::GeoJson => "GeoJSON",
        }
    }

    /// Whether medax reads this format.
    pub fn is_read(self) -> bool {
        self != Format::Vtu
    }

    /// Whether medax writes this format.
    pub fn is_written(self) -> bool {
        self != Format::Pwn
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn endings_are_known_in_either_case() {
        for (path, format) in [
            ("a.ply", Format::Ply),
            ("A.OFF", Format::Off),
            ("dir.v2/a.b.Obj", Format::Obj),
            ("a.stl", Format::Stl),
            ("a.pts", Format::Xyz),
            ("a.csv", Format::Csv),
            ("a.pwn", Format::Pwn),
            ("a.ma", Format::Ma),
            ("a.vtu", Format::Vtu),
            ("a.GeoJSON", Format::GeoJson),
        ] {
            assert_eq!(Format::of_path(path).unwrap(), format, "{path}");
        }
    }

    #[test]
    fn an_unknown_ending_is_answered_with_the_known_ones() {
        for path in ["a.step", "ply", "a.", "a.ply/b"] {
            let error = Format::of_path(path).unwrap_err();
            assert_eq!(error.status(), Status::Unsupported, "{path}");
            for (ending, _) in ENDINGS {
                assert!(error.message().contains(&format!(".{ending}")), "{error}");
            }
        }
    }
}
