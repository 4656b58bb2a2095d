use super::*;
use crate::points::Points;
use std::sync::Arc;

/// Points of a lattice on a sphere and some others: shared spheres, shared poles, poles that touch the far
/// box and such that do not.
fn poles() -> [Poles; 2] {
    let job = Job::default();
    let range = || (-3i32..=3).map(f64::from);
    let grid = range().flat_map(|x| range().flat_map(move |y| range().map(move |z| [x, y, z])));
    let rows: Vec<[f64; 3]> =
        grid.filter(|[x, y, z]| [9.0, 6.0].contains(&(x * x + y * y + z * z))).collect();
    let points = Arc::new(Points::new(&rows, Default::default(), &job).unwrap());
    let t = crate::Triangulation::delaunay(&points, &job).unwrap();
    let dual = Dual::new(&Arc::new(t), DualOptions::default(), &job).unwrap();
    [
        Poles::new(&dual, Default::default(), &job).unwrap(),
        Poles::with_far_box(&points, Default::default(), &job).unwrap(),
    ]
}

fn is_valid(poles: &Poles) -> bool {
    poles.validate(&Job::default()).unwrap().is_valid()
}

#[test]
fn a_wrong_ball_is_noticed() {
    for poles in poles() {
        assert!(is_valid(&poles) && poles.len() > 1);
        for pole in 0..poles.len() {
            for change in 0..9 {
                let mut poles = poles.clone();
                match change {
                    0 => poles.balls[pole][0] = poles.balls[pole][0].next_up(),
                    1 => poles.balls[pole][3] = poles.balls[pole][3].next_up(),
                    2 => poles.radii_squared[pole] = poles.radii_squared[pole].next_down(),
                    3 => poles.touches_far_box[pole] = !poles.touches_far_box[pole],
                    4 => poles.cell_of_pole[pole] += 1,
                    5 => poles.cell_of_pole[pole] = NONE,
                    6 => poles.object_angles[pole] += 0.1,
                    7 => poles.object_angles[pole] = f64::NAN,
                    _ => {
                        let other = (pole + 1) % poles.len();
                        poles.balls[pole] = poles.balls[other];
                        poles.radii_squared[pole] = poles.radii_squared[other];
                        poles.cell_of_pole[pole] = poles.cell_of_pole[other];
                        poles.touches_far_box[pole] = poles.touches_far_box[other];
                    }
                }
                assert!(!is_valid(&poles), "pole {pole}, change {change}");
            }
        }
    }
}

#[test]
fn a_wrong_pole_or_normal_of_a_sample_is_noticed() {
    for poles in poles() {
        for sample in 0..poles.sample_count() {
            for slot in 0..2 {
                for wrong in [NONE, 0, 1, poles.len() as u32] {
                    let mut poles = poles.clone();
                    let pole = &mut poles.pole_of_sample[sample][slot];
                    if std::mem::replace(pole, wrong) != wrong {
                        assert!(!is_valid(&poles), "sample {sample}, slot {slot}: {wrong}");
                    }
                }
            }
            for change in 0..3 {
                let mut poles = poles.clone();
                let normal = &mut poles.normals[sample];
                match change {
                    0 => *normal = normal.map(|x| -x),
                    1 => *normal = normal.map(|x| 1.1 * x),
                    _ => *normal = [f64::NAN; 3],
                }
                assert!(!is_valid(&poles), "sample {sample}, change {change}");
            }
        }
    }
}

#[test]
fn poles_out_of_order_are_noticed() {
    for poles in poles() {
        let mut swapped = poles.clone();
        swapped.balls.swap(0, 1);
        swapped.radii_squared.swap(0, 1);
        swapped.cell_of_pole.swap(0, 1);
        swapped.touches_far_box.swap(0, 1);
        for pole in swapped.pole_of_sample.as_flattened_mut() {
            *pole = match *pole {
                0 => 1,
                1 => 0,
                other => other,
            };
        }
        assert!(!is_valid(&swapped));
        let mut fewer = poles.clone();
        fewer.normals.pop();
        assert!(!is_valid(&fewer));
    }
}
