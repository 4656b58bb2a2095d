//! Real figures, with the counts that `MANIFEST.md` beside them gives.

use crate::drawing::{ACCEPT, chain, check};
use medax::figure::{ChainKind, FigureOptions, Normalised};
use medax::io::{FeatureChoice, ReadFigureOptions, read_figure};
use medax::{ElementKind, Figure, Job, Status};
use std::path::PathBuf;

/// The folder of the figures, or nothing, said plainly.
fn data() -> Option<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: {} is not there", folder.display());
    None
}

/// File, feature, parts, holes, vertices, least and greatest corner, and the area that the file itself gives.
type Model = (&'static str, &'static str, usize, usize, usize, [f64; 4], f64);

const MODELS: [Model; 12] = [
    ("letters", "B", 1, 2, 137, [201.0, 0.0, 1260.0, 1493.0], 853_618.539_1),
    ("letters", "g", 1, 1, 197, [113.0, -426.0, 1114.0, 1147.0], 731_926.632_8),
    ("letters", "i", 2, 0, 8, [193.0, 0.0, 377.0, 1556.0], 248_952.0),
    ("letters", "S", 1, 0, 196, [135.0, -29.0, 1186.0, 1520.0], 647_262.343_8),
    ("letters", "O", 1, 1, 128, [115.0, -29.0, 1497.0, 1520.0], 784_454.710_9),
    ("letters", "&", 1, 1, 231, [129.0, -29.0, 1534.0, 1520.0], 780_019.773_4),
    ("letters", "8", 1, 2, 256, [139.0, -29.0, 1163.0, 1520.0], 769_456.398_4),
    ("letters", "Y", 1, 0, 9, [-4.0, 0.0, 1255.0, 1493.0], 462_700.0),
    ("countries", "Norway", 32, 0, 1953, [-969.308, 6451.68, 665.319, 8948.78], 367_747.997_8),
    (
        "countries",
        "South Africa",
        2,
        1,
        439,
        [-861.847, -5222.1, 1226.54, -2462.48],
        1_225_037.193_7,
    ),
    ("countries", "Italy", 8, 2, 604, [-422.467, 4079.48, 554.336, 5235.37], 303_561.651_4),
    ("countries", "Croatia", 13, 0, 361, [-223.139, 4718.42, 242.561, 5174.37], 54_839.904_3),
];

/// Rings in the plane run counterclockwise, holes clockwise: the sum of what they enclose is the area.
fn area(figure: &Figure) -> f64 {
    let ring = |i: usize| {
        let ring = chain(figure, i);
        let next = |k: usize| ring[(k + 1) % ring.len()];
        ring.iter().enumerate().map(|(k, a)| a[0] * next(k)[1] - a[1] * next(k)[0]).sum::<f64>()
    };
    0.5 * (0..figure.chains().len()).map(ring).sum::<f64>()
}

#[test]
fn letters_and_countries_are_what_the_manifest_says() {
    let Some(folder) = data() else { return };
    for (file, name, parts, holes, vertices, corners, expected) in MODELS {
        let path = folder.join(file).with_extension("geojson");
        let feature = FeatureChoice::Named(name.to_string());
        let options = ReadFigureOptions { feature, ..ReadFigureOptions::default() };
        let figure = read_figure(&path, &options, &Job::default()).unwrap();
        check(&figure);
        assert_eq!(figure.part_count(), parts, "{name}");
        assert_eq!(figure.chain_count(ChainKind::Outer), parts, "{name}");
        assert_eq!(figure.chain_count(ChainKind::Hole), holes, "{name}");
        assert_eq!(figure.vertices().len(), vertices, "{name}");
        let counts = *figure.normalised();
        let rings = (parts + holes) as u64;
        assert_eq!(counts.closing_vertices, rings, "{name}");
        assert!(counts.turned_rings <= rings, "{name}");
        let zero = Normalised { closing_vertices: 0, turned_rings: 0, ..counts };
        assert_eq!(zero, Normalised::default(), "{name}");
        let bounds = figure.bounds();
        let found = [bounds.min[0], bounds.min[1], bounds.max[0], bounds.max[1]];
        for (found, corner) in found.iter().zip(corners) {
            // The manifest has six digits.
            assert!((found - corner).abs() <= 1e-5 * corner.abs(), "{name}: {found} {corner}");
        }
        let found = area(&figure);
        assert!((found - expected).abs() < 1e-3, "{name}: {found} {expected}");
    }
}

#[test]
fn features_that_overlap_are_refused_together_unless_accepted() {
    let Some(folder) = data() else { return };
    for (file, parts) in [("letters", 9), ("countries", 55)] {
        let path = folder.join(file).with_extension("geojson");
        let job = Job::default();
        let error = read_figure(&path, &ReadFigureOptions::default(), &job).unwrap_err();
        assert_eq!(error.status(), Status::InvalidArgument, "{error}");
        assert!(matches!(error.element(), Some((ElementKind::Ring, _))), "{error}");
        assert!(error.message().contains("crosses or touches"), "{error}");
        let options = ReadFigureOptions { figure: ACCEPT, ..ReadFigureOptions::default() };
        let figure = read_figure(&path, &options, &job).unwrap();
        check(&figure);
        assert_eq!(figure.part_count(), parts, "{file}");
        assert!(figure.normalised().crossings > 0, "{file}");
    }
}

#[test]
fn a_number_chooses_what_a_name_does() {
    let Some(folder) = data() else { return };
    let read = |file: &str, feature| {
        let options = ReadFigureOptions { feature, figure: FigureOptions::default() };
        read_figure(folder.join(file), &options, &Job::default())
    };
    let named = |name: &str| FeatureChoice::Named(name.to_string());
    let by_name = read("letters.geojson", named("i")).unwrap();
    assert_eq!(read("letters.geojson", FeatureChoice::Numbered(2)).unwrap(), by_name);
    let error = read("letters.geojson", FeatureChoice::Numbered(8)).unwrap_err();
    assert_eq!(error.status(), Status::InvalidArgument);
    let error = read("letters.geojson", named("b")).unwrap_err();
    assert!(
        error.message().contains("it has 8, counted from 0: B, g, i, S, O, &, 8, Y"),
        "{error}"
    );
}
