//! Power crusts of real models with noise added to their vertices (Amenta, Choi, Kolluri 2001, Figures 10 and 16).

use medax::crust::{LabelRule, PowerCrustOptions, SimplifyOptions};
use medax::io::read_points;
use medax::points::PointsOptions;
use medax::poles::{Omit, PolesOptions};
use medax::{Job, Points, PowerCrust, Triangulation};
use std::path::Path;
use std::sync::Arc;

/// The distinct vertices of a model, and the median distance to the nearest other one; `None`, and a word about it, where
/// there is no such file.
fn model(name: &str) -> Option<(Vec<[f64; 3]>, f64)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data").join(name);
    if !path.exists() {
        println!("skipped: there is no {}", path.display());
        return None;
    }
    let job = Job::default();
    let points = Arc::new(read_points(path, PointsOptions::default(), &job).unwrap());
    let rows = points.coords().to_vec();
    // The nearest point is a neighbour in the Delaunay triangulation.
    let triangulation = Triangulation::delaunay(&points, &job).unwrap();
    let mut nearest = vec![f64::MAX; rows.len()];
    for cell in triangulation.cells() {
        for &i in cell {
            for &j in cell.iter().filter(|&&j| j != i) {
                let d = [0, 1, 2].map(|k| rows[i as usize][k] - rows[j as usize][k]);
                let d = d.iter().map(|x| x * x).sum::<f64>().sqrt();
                nearest[i as usize] = nearest[i as usize].min(d);
            }
        }
    }
    nearest.sort_by(f64::total_cmp);
    Some((rows, nearest[nearest.len() / 2]))
}

/// Each coordinate moved by a Gaussian amount (Box, Muller 1958).
fn noisy(rows: &[[f64; 3]], deviation: f64, seed: u64) -> Vec<[f64; 3]> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64 ^ seed;
    let mut unit = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut gauss = || (-2.0 * (1.0 - unit()).ln()).sqrt() * (std::f64::consts::TAU * unit()).cos();
    rows.iter().map(|row| row.map(|x| x + deviation * gauss())).collect()
}

fn crust(rows: &[[f64; 3]], omit: Omit) -> PowerCrust {
    let job = Job::default();
    let points = Points::new(rows, PointsOptions::default(), &job).unwrap();
    let poles = PolesOptions { omit, lambda: 0.0 };
    let options = PowerCrustOptions { poles, ..Default::default() };
    PowerCrust::build(&Arc::new(points), options, &job).unwrap()
}

/// Components and genus of the surface, which must be closed.
fn form(crust: &PowerCrust) -> (u64, Option<u64>) {
    let topology = crust.surface().topology(&Job::default()).unwrap();
    assert!(topology.closed);
    (topology.components, topology.genus)
}

#[test]
fn noise_of_half_the_spacing_changes_no_genus() {
    for (name, genus) in [("mannequin.off", 0), ("foot.off", 0), ("rocker-arm.obj", 1)] {
        let Some((rows, spacing)) = model(name) else { continue };
        for (level, seed) in [(0.25, 0), (0.25, 1), (0.5, 0), (0.5, 1), (0.5, 2)] {
            let rows = noisy(&rows, level * spacing, seed);
            assert_eq!(
                form(&crust(&rows, Omit::Side)),
                (1, Some(genus)),
                "{name}, {level}, {seed}"
            );
        }
        let rows = noisy(&rows, 0.5 * spacing, 0);
        let options = PowerCrustOptions { label_rule: LabelRule::Spread, ..Default::default() };
        let points = Arc::new(Points::new(&rows, Default::default(), &Job::default()).unwrap());
        let bare = PowerCrust::build(&points, options, &Job::default()).unwrap();
        assert!(form(&bare) != (1, Some(genus)), "{name}: no harm done");
        // More noise than that promises no genus, but the surface is closed.
        form(&crust(&noisy(&rows, spacing, 0), Omit::Side));
    }
}

#[test]
fn simplified_shapes_of_a_clean_and_a_noisy_foot_have_as_many_faces() {
    let Some((rows, spacing)) = model("foot.off") else { return };
    let options = SimplifyOptions { epsilon: Some(8.0 * spacing), delta: Some(2.0 * spacing) };
    let faces = |level: f64| {
        let crust = crust(&noisy(&rows, level * spacing, 0), Omit::Side);
        let simplified = crust.simplify(options, &Job::default()).unwrap().crust;
        assert_eq!(form(&simplified), (1, Some(0)), "{level}");
        let [before, after] =
            [&crust, &simplified].map(|crust| crust.inner_shape().faces().len() as f64);
        println!("noise {level}: {before} faces of the inner shape, {after} when simplified");
        assert!(after < before / 20.0);
        after
    };
    let clean = faces(0.0);
    for level in [0.25, 0.5, 1.0] {
        let ratio = faces(level) / clean;
        assert!((0.8..1.25).contains(&ratio), "{level}: {ratio}");
    }
}
