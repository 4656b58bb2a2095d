//! `medax field`, and what `medax info` says of plane figures.

mod graph;
mod points;
mod refusals;
mod surface;

use crate::Place;
use medax::complex::{Complex, Element, Values};
use medax::figure::Figure;
use medax::{Job, io};
use serde_json::{Value, json};

/// A feature of this geometry.
fn feature(properties: &Value, kind: &str, coordinates: &Value) -> Value {
    let geometry = json!({ "type": kind, "coordinates": coordinates });
    json!({ "type": "Feature", "properties": properties, "geometry": geometry })
}

fn polygon(name: &str, rings: &Value) -> Value {
    feature(&json!({ "name": name }), "Polygon", rings)
}

impl Place {
    fn figure(&self, name: &str, features: &[Value]) {
        let collection = json!({ "type": "FeatureCollection", "features": features });
        self.write(name, collection.to_string());
    }

    /// The figure that a result in GeoJSON is when it is read back.
    fn read_figure(&self, name: &str) -> Figure {
        io::read_figure(self.path(name), &Default::default(), &Job::default()).unwrap()
    }
}

/// Corners of an axis-parallel square, counterclockwise.
fn square(x: f64, y: f64, side: f64) -> Value {
    rectangle(x, y, side, side)
}

fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Value {
    let (u, v) = (x + width, y + height);
    json!([[x, y], [u, y], [u, v], [x, v], [x, y]])
}

fn betti(report: &Value) -> &Value {
    &report["outputs"][0]["topology"]["betti"]
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn reals(complex: &Complex, name: &str) -> Vec<f64> {
    match complex.attribute(Element::Vertex, name).unwrap().values() {
        Values::F64(values) => values.clone(),
        Values::U32(_) => panic!("{name} has whole numbers"),
    }
}

/// A box of sides 2, 1.5 and 1 from the origin, without its last faces.
pub fn open_box(left_out: usize, more: &str) -> String {
    let faces = ["0 3 2 1", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7", "4 5 6 7"];
    let corners = [[0, 0], [1, 0], [1, 1], [0, 1]];
    let corner = |z: f64| {
        let at = |[x, y]: [i32; 2]| format!("{} {} {z}\n", 2.0 * f64::from(x), 1.5 * f64::from(y));
        corners.map(at).concat()
    };
    let faces: Vec<String> = faces[..6 - left_out].iter().map(|f| format!("4 {f}\n")).collect();
    let count = 8 + more.lines().count();
    format!(
        "OFF\n{count} {} 0\n{}{}{more}{}",
        faces.len(),
        corner(0.0),
        corner(1.0),
        faces.concat()
    )
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let place = Place::new();
    let holes: Vec<Value> = (0..6).map(|i| square(1.0 + 2.5 * f64::from(i), 1.0, 1.5)).collect();
    let rings: Vec<Value> = [rectangle(0.0, 0.0, 16.0, 4.0)].into_iter().chain(holes).collect();
    place.figure("comb.geojson", &[polygon("comb", &json!(rings))]);
    place.write("box.off", open_box(0, ""));
    for command in [
        "field comb.geojson --side both -o out.geojson",
        "field comb.geojson --points --density 0.5 -o out.ply",
        "field box.off --density 0.1 -o out.ply",
        "field box.off --points --density 0.1 -o out.ply",
    ] {
        let name = command.rsplit(' ').next().unwrap();
        let written = [1, 3, 8].map(|threads| {
            place.json(&format!("{command} --threads {threads}"));
            place.read(name)
        });
        assert!(
            written[0].len() > 1000 && written.iter().all(|bytes| *bytes == written[0]),
            "{command}"
        );
    }
}
