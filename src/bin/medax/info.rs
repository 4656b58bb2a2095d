//! `medax info`: what a file holds.

use crate::figure::{FeatureOptions, is_figure};
use crate::report::{Counts, Input, Report, topology_json, topology_line};
use crate::session::{Failure, ReadOptions, Session};
use medax::complex::Element;
use medax::figure::Crossings;
use medax::io::Soup;
use medax::points::Bounds;
use serde_json::{Map, Value, json};
use std::path::PathBuf;

/// Say what a file of points, a mesh or a plane figure holds: counts, extent, topology, self-intersections
#[derive(clap::Args)]
pub struct Options {
    /// The file
    input: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    feature: FeatureOptions,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    if is_figure(&options.input) {
        return figure(options, session);
    }
    if let Some(name) = options.feature.given() {
        let message = format!("{name} is for plane figures, which GeoJSON files hold");
        return Err(Failure::usage(message));
    }
    let soup = session.read(&options.input)?;
    let mut report = Report { command: "info", ..Report::default() };
    options.read.describe(&mut report.parameters);
    // Without vertices it is no set of points, but it may be a complex: an axis that no facet passed.
    let is_empty = soup.vertices().is_empty();
    let mut bounds = Value::Null;
    if !is_empty {
        let (points, input) = session.points(&options.input, &soup, &options.read)?;
        report.input = input;
        bounds = extent(points.bounds(), &mut report);
    }
    report.more.insert("bounds".into(), bounds);
    report.more.insert("attributes".into(), attributes_json(&soup));
    let names: Vec<&str> = soup.attributes().iter().map(|attribute| attribute.name()).collect();
    report.lines.push(("attributes", names.join(", ")));
    if !soup.is_mesh() && !is_empty {
        let vertices = Some(soup.vertices().len() as u64);
        report.counts = Counts { vertices, ..Counts::default() };
        report.more.insert("topology".into(), Value::Null);
        report.more.insert("self_intersecting_pairs".into(), Value::Null);
        report.more.insert("measure".into(), Value::Null);
        return Ok(report);
    }
    let mesh = session.complex(&options.input, soup)?;
    if is_empty {
        report.input = Input::of_complex(&options.input, &mesh);
    }
    let topology = mesh.topology(&session.job)?;
    let measure = mesh.measure(&session.job)?;
    let intersections = mesh.self_intersections(&session.job)?.len();
    report.counts = Counts::from(&mesh);
    report.lines.push(("topology", topology_line(&topology)));
    report.lines.push(("self-intersections", triangle_pairs(intersections)));
    // Without a closed surface there is nothing inside.
    let volume = (topology.closed && topology.oriented).then_some(measure.volume);
    let volume_words = volume.map_or(String::new(), |volume| format!(", volume {volume}"));
    report.lines.push(("measure", format!("area {}{volume_words}", measure.area)));
    report.more.insert("topology".into(), topology_json(&topology));
    report.more.insert("self_intersecting_pairs".into(), json!(intersections));
    report.more.insert("measure".into(), json!({ "area": measure.area, "volume": volume }));
    Ok(report)
}

/// A plane figure: whatever crosses is counted.
fn figure(options: &Options, session: &Session) -> Result<Report, Failure> {
    let mut report = Report { command: "info", ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.feature.describe(&mut report);
    let figure = options.feature.read(&options.input, Crossings::Accept, &mut report, session)?;
    let vertices = Some(figure.vertices().len() as u64);
    report.counts = Counts { vertices, ..Counts::default() };
    let bounds = extent(figure.bounds(), &mut report);
    report.more.insert("bounds".into(), bounds);
    report.more.insert("attributes".into(), json!([]));
    for name in ["topology", "self_intersecting_pairs", "measure"] {
        report.more.insert(name.into(), Value::Null);
    }
    Ok(report)
}

/// The smallest box, for scripts and in lines.
fn extent(bounds: &Bounds, report: &mut Report) -> Value {
    let Bounds { min, max } = bounds;
    let diagonal = bounds.diagonal();
    report.lines.push(("from", format!("{min:?}")));
    report.lines.push(("to", format!("{max:?}")));
    report.lines.push(("diagonal", format!("{diagonal}")));
    json!({ "min": min, "max": max, "diagonal": diagonal })
}

fn triangle_pairs(count: usize) -> String {
    match count {
        0 => "none".into(),
        1 => "1 pair of triangles".into(),
        _ => format!("{count} pairs of triangles"),
    }
}

fn attributes_json(soup: &Soup) -> Value {
    let element = |element| match element {
        Element::Vertex => "vertex",
        Element::Edge => "edge",
        Element::Face => "face",
        Element::Cell => "cell",
    };
    let attribute = |a: &medax::complex::Attribute| {
        Value::Object(Map::from_iter([
            ("name".to_string(), json!(a.name())),
            ("element".to_string(), json!(element(a.element()))),
            ("width".to_string(), json!(a.width())),
        ]))
    };
    soup.attributes().iter().map(attribute).collect()
}
