//! Letters and countries.

use medax::Job;
use medax::distance::{FieldAxis, FieldOptions, GraphOptions, MedialGraph, Sites};
use medax::figure::ChainKind;
use medax::io::{FeatureChoice, ReadFigureOptions, read_figure};
use std::path::Path;
use std::sync::Arc;

const NAMES: [(&str, &[&str]); 2] = [
    ("letters.geojson", &["B", "g", "i", "S", "O", "&", "8", "Y"]),
    ("countries.geojson", &["Norway", "South Africa", "Italy", "Croatia"]),
];

/// All figures with their names, if the data are there.
pub fn figures() -> Vec<(String, Arc<Sites>, [u64; 2])> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if !folder.is_dir() {
        println!("skipped: {} is not there", folder.display());
        return Vec::new();
    }
    let mut figures = Vec::new();
    for (file, names) in NAMES {
        for &name in names {
            let options = ReadFigureOptions {
                feature: FeatureChoice::Named(name.into()),
                ..ReadFigureOptions::default()
            };
            let figure = read_figure(folder.join(file), &options, &Job::default()).unwrap();
            let betti =
                [ChainKind::Outer, ChainKind::Hole].map(|kind| figure.chain_count(kind) as u64);
            let sites = Sites::of_figure(&figure, &Job::default()).unwrap();
            figures.push((name.to_string(), Arc::new(sites), betti));
        }
    }
    figures
}

#[test]
fn graphs_of_letters_and_countries_have_their_betti_numbers() {
    for (name, sites, betti) in figures() {
        let job = Job::default();
        let graph = MedialGraph::new(&sites, GraphOptions::default(), &job).unwrap();
        let topology = graph.complex(&job).unwrap().topology(&job).unwrap();
        assert_eq!((&topology.betti[..2], graph.torn()), (&betti[..], 0), "{name}");
    }
}

/// The points that circles find lie on the arcs, and none beyond the bound is missed.
#[test]
fn circles_and_arcs_agree_on_letters_and_countries() {
    for (name, sites, _) in figures() {
        let job = Job::default();
        let density = 0.02 * sites.size();
        let options =
            FieldOptions { density, min_distance: 0.5 * density, ..FieldOptions::default() };
        let axis = FieldAxis::new(&sites, options, &job).unwrap();
        let options = GraphOptions { spacing: 0.2 * density, ..GraphOptions::default() };
        let graph = MedialGraph::new(&sites, options, &job).unwrap();
        crate::plane::check_complete(&name, &axis, &graph);
    }
}
