//! Writing: faces as polygons, chains of loose edges as lines, isolated vertices as points, attributes as properties.

use super::super::sink::Sink;
use crate::complex::{Attribute, Complex, Element, Values};
use crate::error::{Error, Result, Status};
use crate::figure::ring_direction;
use crate::index::NONE;
use crate::job::Room;

/// The steps between two polls.
const BATCH: usize = 1 << 12;

/// Errors where the format holds nothing of a complex.
pub(in crate::io) fn check(complex: &Complex) -> Result<()> {
    match complex.dimension() {
        2 => Ok(()),
        _ => Err(Error::new(
            Status::Unsupported,
            "GeoJSON holds plane complexes, and this one is in space; write PLY",
        )),
    }
}

pub(in crate::io) fn write(complex: &Complex, out: &mut Sink<'_>) -> Result<()> {
    let mut room = Room::new(out.run());
    let mut writer = Writer { complex, tables: Tables::new(complex, out)?, is_first: true };
    out.text(format_args!("{{\"type\":\"FeatureCollection\",\"features\":["))?;
    let mut used = room.filled(complex.vertices().len(), false)?;
    for (i, face) in complex.faces().iter().enumerate() {
        face.iter().for_each(|&v| used[v as usize] = true);
        writer.face(i, face, out)?;
    }
    complex.cells().indices().iter().for_each(|&v| used[v as usize] = true);
    complex.edges().as_flattened().iter().for_each(|&v| used[v as usize] = true);
    writer.lines(&mut room, out)?;
    for (vertex, used) in (0..).zip(used) {
        if !used {
            writer.begin(Element::Vertex, &[vertex], &[], out)?;
            out.text(format_args!("\"Point\",\"coordinates\":"))?;
            writer.position(vertex, out)?;
            writer.end(out)?;
        }
    }
    out.text(format_args!("\n]}}\n"))
}

/// The attributes of each kind of feature, with their names in quotes.
struct Tables<'a> {
    of_vertex: Vec<(String, &'a Attribute)>,
    of_edge: Vec<(String, &'a Attribute)>,
    of_face: Vec<(String, &'a Attribute)>,
}

impl<'a> Tables<'a> {
    /// An attribute of edges or faces gives way to one of vertices that has its name.
    fn new(complex: &'a Complex, out: &mut Sink<'_>) -> Result<Self> {
        let mut table = |element: Element| -> Result<_> {
            let mut rows: Vec<(String, &Attribute)> = Vec::new();
            let of_element = complex.attributes().iter().filter(|a| a.element() == element);
            for attribute in of_element {
                let name = attribute.name();
                if element != Element::Vertex && complex.attribute(Element::Vertex, name).is_some()
                    || rows.iter().any(|(_, earlier)| earlier.name() == name)
                {
                    let of = format!("{element:?}").to_lowercase();
                    out.warn(format!(
                        "the {of} attribute '{name}' was left out: its name is taken"
                    ));
                    continue;
                }
                let quoted = serde_json::to_string(name)
                    .map_err(|error| Error::new(Status::Internal, error.to_string()))?;
                rows.push((quoted, attribute));
            }
            Ok(rows)
        };
        Ok(Tables {
            of_vertex: table(Element::Vertex)?,
            of_edge: table(Element::Edge)?,
            of_face: table(Element::Face)?,
        })
    }
}

struct Writer<'a> {
    complex: &'a Complex,
    tables: Tables<'a>,
    is_first: bool,
}

impl Writer<'_> {
    /// A polygon, counterclockwise as the format wants it.
    fn face(&mut self, number: usize, face: &[u32], out: &mut Sink<'_>) -> Result<()> {
        let mut ring = face.to_vec();
        let place = |&v: &u32| {
            let [x, y, _] = self.complex.vertices()[v as usize];
            [x, y]
        };
        if ring_direction(&ring.iter().map(place).collect::<Vec<_>>()).is_negative() {
            ring[1..].reverse();
        }
        self.begin(Element::Face, &ring, &[number as u32], out)?;
        out.text(format_args!("\"Polygon\",\"coordinates\":["))?;
        ring.push(ring[0]);
        self.positions(&ring, out)?;
        out.text(format_args!("]"))?;
        self.end(out)
    }

    /// The loose edges, joined where nothing else begins or ends.
    fn lines(&mut self, room: &mut Room<'_>, out: &mut Sink<'_>) -> Result<()> {
        let joints = Joints::new(self.complex, room)?;
        let mut done = room.filled(self.complex.edges().len(), false)?;
        let (mut line, mut edges) = (Vec::new(), Vec::new());
        for edge in 0..self.complex.edges().len() {
            if done[edge] {
                continue;
            }
            let (mut vertex, mut edge) = joints.beginning(edge as u32, out)?;
            line.clear();
            edges.clear();
            room.push(&mut line, vertex)?;
            loop {
                done[edge as usize] = true;
                vertex = joints.other_end(edge, vertex);
                room.push(&mut line, vertex)?;
                room.push(&mut edges, edge)?;
                out.row()?;
                match joints.next(edge, vertex) {
                    Some(next) if !done[next as usize] => edge = next,
                    _ => break,
                }
            }
            self.begin(Element::Edge, &line, &edges, out)?;
            out.text(format_args!("\"LineString\",\"coordinates\":"))?;
            self.positions(&line, out)?;
            self.end(out)?;
        }
        Ok(())
    }

    /// Writes a feature up to its geometry's type. `elements` are the edges along a line, or the face.
    fn begin(
        &mut self,
        kind: Element,
        vertices: &[u32],
        elements: &[u32],
        out: &mut Sink<'_>,
    ) -> Result<()> {
        let comma = if std::mem::take(&mut self.is_first) { "" } else { "," };
        out.text(format_args!("{comma}\n{{\"type\":\"Feature\",\"properties\":{{"))?;
        let mut comma = "";
        for (name, attribute) in &self.tables.of_vertex {
            out.text(format_args!("{comma}{name}:"))?;
            match kind {
                Element::Vertex => value(attribute, vertices[0], out)?,
                _ => values(attribute, vertices, out)?,
            }
            comma = ",";
        }
        let own = match kind {
            Element::Edge => &self.tables.of_edge[..],
            Element::Face => &self.tables.of_face[..],
            _ => &[],
        };
        for (name, attribute) in own {
            out.text(format_args!("{comma}{name}:"))?;
            // A line is within one arc.
            let is_one = kind == Element::Face || is_arc(attribute);
            match elements {
                [first, ..] if is_one => value(attribute, *first, out)?,
                _ => values(attribute, elements, out)?,
            }
            comma = ",";
        }
        out.text(format_args!("}},\"geometry\":{{\"type\":"))
    }

    fn end(&self, out: &mut Sink<'_>) -> Result<()> {
        out.text(format_args!("}}}}"))?;
        out.row()
    }

    fn positions(&self, vertices: &[u32], out: &mut Sink<'_>) -> Result<()> {
        list(vertices, out, |&vertex, out| self.position(vertex, out))
    }

    fn position(&self, vertex: u32, out: &mut Sink<'_>) -> Result<()> {
        let [x, y, _] = self.complex.vertices()[vertex as usize];
        out.text(format_args!("[{x:?},{y:?}]"))
    }
}

/// Writes an array.
fn list<T>(
    items: &[T],
    out: &mut Sink<'_>,
    put: impl Fn(&T, &mut Sink<'_>) -> Result<()>,
) -> Result<()> {
    out.text(format_args!("["))?;
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            out.text(format_args!(","))?;
        }
        if (i + 1).is_multiple_of(BATCH) {
            out.run().poll()?;
        }
        put(item, out)?;
    }
    out.text(format_args!("]"))
}

fn values(attribute: &Attribute, elements: &[u32], out: &mut Sink<'_>) -> Result<()> {
    list(elements, out, |&element, out| value(attribute, element, out))
}

/// Writes the row of an element: a number, or an array of them.
fn value(attribute: &Attribute, element: u32, out: &mut Sink<'_>) -> Result<()> {
    let width = attribute.width();
    let row = element as usize * width..(element as usize + 1) * width;
    match (attribute.values(), width) {
        (Values::F64(values), 1) => real(&values[row.start], out),
        (Values::F64(values), _) => list(&values[row], out, real),
        (Values::U32(values), 1) => whole(&values[row.start], out),
        (Values::U32(values), _) => list(&values[row], out, whole),
    }
}

/// JSON has no word for NaN and infinities.
fn real(x: &f64, out: &mut Sink<'_>) -> Result<()> {
    match x.is_finite() {
        true => out.text(format_args!("{x:?}")),
        false => out.text(format_args!("null")),
    }
}

fn whole(x: &u32, out: &mut Sink<'_>) -> Result<()> {
    match *x {
        NONE => out.text(format_args!("null")),
        x => out.text(format_args!("{x}")),
    }
}

/// Whether an attribute says which arc an edge is part of.
fn is_arc(attribute: &Attribute) -> bool {
    let is_number = attribute.width() == 1 && matches!(attribute.values(), Values::U32(_));
    attribute.element() == Element::Edge && attribute.name() == "arc" && is_number
}

/// Where loose edges go on in each other: at vertices of two of them, which are of one arc.
struct Joints<'a> {
    complex: &'a Complex,
    /// The two edges of each joint; [`NONE`] twice for another vertex.
    edges: Vec<[u32; 2]>,
}

impl<'a> Joints<'a> {
    fn new(complex: &'a Complex, room: &mut Room<'_>) -> Result<Self> {
        let arcs = complex.attributes().iter().find(|a| is_arc(a)).map(Attribute::values);
        let mut degrees = room.filled(complex.vertices().len(), 0u32)?;
        let mut edges = room.filled(complex.vertices().len(), [NONE; 2])?;
        for (edge, ends) in (0..).zip(complex.edges()) {
            for &v in ends {
                let degree = &mut degrees[v as usize];
                if let Some(slot) = edges[v as usize].get_mut(*degree as usize) {
                    *slot = edge;
                }
                *degree += 1;
            }
        }
        for (pair, degree) in edges.iter_mut().zip(degrees) {
            let same = match arcs {
                Some(Values::U32(arcs)) if degree == 2 => {
                    arcs[pair[0] as usize] == arcs[pair[1] as usize]
                }
                _ => true,
            };
            if degree != 2 || !same {
                *pair = [NONE; 2];
            }
        }
        Ok(Joints { complex, edges })
    }

    fn other_end(&self, edge: u32, vertex: u32) -> u32 {
        let [a, b] = self.complex.edges()[edge as usize];
        if a == vertex { b } else { a }
    }

    /// The edge in which this one goes on at its end `vertex`.
    fn next(&self, edge: u32, vertex: u32) -> Option<u32> {
        let [a, b] = self.edges[vertex as usize];
        Some(if a == edge { b } else { a }).filter(|&next| next != NONE)
    }

    /// Where the line of an edge begins, and its first edge; of a closed line, this edge.
    fn beginning(&self, edge: u32, out: &mut Sink<'_>) -> Result<(u32, u32)> {
        let start = (self.complex.edges()[edge as usize][0], edge);
        let (mut vertex, mut at) = start;
        let mut steps = 0;
        while let Some(before) = self.next(at, vertex) {
            if before == edge {
                return Ok(start);
            }
            (vertex, at) = (self.other_end(before, vertex), before);
            steps += 1;
            if steps % BATCH == 0 {
                out.run().poll()?;
            }
        }
        Ok((vertex, at))
    }
}
