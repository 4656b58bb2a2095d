//! OBJ, Wavefront's object format: a statement a line; `v`, `f` and `l` are what medax keeps.
//!
//! Indices count from 1, or backwards from the last vertex where negative; a face may name
//! vertices that follow it. Texture and normal indices are checked to be numbers and dropped.
//! Other statements (names, groups, materials, normals, curves) are passed over, also those that a
//! program made up, as long as they begin with a name. A file without a vertex must name an object.

use super::sink::Sink;
use super::soup::{Builder, Soup};
use super::text::{Line, Lines, at_line, number, shown};
use crate::complex::Complex;
use crate::error::{ElementKind, Result};
use crate::job::Run;

pub(super) fn parse(bytes: &[u8], run: &Run<'_>) -> Result<Soup> {
    let mut lines = Lines::new(bytes, run);
    let mut builder = Builder::new(run);
    let mut greatest = Greatest::default();
    let mut words: Vec<&[u8]> = Vec::new();
    let mut is_named = false;
    while let Some(line) = lines.next_filled()? {
        let keyword = line.words().next().unwrap_or_default();
        match keyword {
            b"v" => {
                statement(line, &mut lines, &mut words)?;
                builder.vertex(vertex(&words, line.number)?)?;
            }
            b"f" => {
                statement(line, &mut lines, &mut words)?;
                for word in &words {
                    let vertex = index(word, builder.vertices.len(), line.number, &mut greatest)?;
                    builder.corner(vertex)?;
                }
                if builder.close_face()? < 3 {
                    return Err(too_few(line.number, "a face", "three", words.len()));
                }
            }
            b"l" => {
                statement(line, &mut lines, &mut words)?;
                let mut last = None;
                for word in &words {
                    let vertex = index(word, builder.vertices.len(), line.number, &mut greatest)?;
                    if let Some(last) = last.replace(vertex) {
                        builder.edge([last, vertex])?;
                    }
                }
                if words.len() < 2 {
                    return Err(too_few(line.number, "a line", "two", words.len()));
                }
            }
            b"o" => is_named = true,
            _ if is_name(keyword) => {}
            _ => {
                let message = format!("{} does not begin an OBJ statement", shown(keyword));
                return Err(at_line(line.number, message));
            }
        }
    }
    if builder.vertices.is_empty() && !is_named {
        return Err(at_line(lines.number(), "the file ends here, and holds no vertex"));
    }
    greatest.check(builder.vertices.len())?;
    builder.finish((ElementKind::Line, lines.number()))
}

/// Collects the words behind the keyword. A backslash at the end of a line continues it.
fn statement<'a>(first: Line<'a>, lines: &mut Lines<'a>, words: &mut Vec<&'a [u8]>) -> Result<()> {
    words.clear();
    words.extend(first.words().skip(1));
    while let Some(begin) = words.last().and_then(|word| word.strip_suffix(b"\\")) {
        words.pop();
        if !begin.is_empty() {
            words.push(begin);
        }
        match lines.next()? {
            Some(line) => words.extend(line.words()),
            None => return Err(lines.ended("the continued statement")),
        }
    }
    Ok(())
}

/// The coordinates, without the weight or the colour that may follow.
fn vertex(words: &[&[u8]], line: u64) -> Result<[f64; 3]> {
    if words.len() < 3 {
        return Err(too_few(line, "a vertex", "three coordinates", words.len()));
    }
    let mut xyz = [0.0; 3];
    for ((x, word), name) in xyz.iter_mut().zip(words).zip(["x", "y", "z"]) {
        *x = number::<f64>(line, word, name)?;
    }
    Ok(xyz)
}

/// The vertex that a corner such as `7`, `7/1`, `7//3`, `7/1/3` or `-1` names, from 0.
fn index(word: &[u8], vertex_count: usize, line: u64, greatest: &mut Greatest) -> Result<u32> {
    let mut parts = word.split(|&b| b == b'/');
    let integer = |part: &[u8]| -> Option<i64> { std::str::from_utf8(part).ok()?.parse().ok() };
    let bad = || at_line(line, format!("{} does not name a vertex", shown(word)));
    let vertex = parts.next().and_then(integer).ok_or_else(bad)?;
    let rest = [parts.next(), parts.next()];
    let sound = rest.iter().flatten().all(|part| part.is_empty() || integer(part).is_some());
    if !sound || parts.next().is_some() {
        return Err(bad());
    }
    let vertex = match vertex {
        0 => return Err(at_line(line, "vertices count from 1, and this names vertex 0")),
        1.. => vertex - 1,
        _ => vertex_count as i64 + vertex,
    };
    if vertex < 0 {
        let message = format!("{} counts back past the first vertex", shown(word));
        return Err(at_line(line, message));
    }
    greatest.see(vertex as u64, line);
    u32::try_from(vertex).map_err(|_| bad())
}

/// The greatest vertex named, and where: vertices may follow the faces that use them.
#[derive(Default)]
struct Greatest {
    found: Option<(u64, u64)>,
}

impl Greatest {
    fn see(&mut self, vertex: u64, line: u64) {
        if self.found.is_none_or(|(greatest, _)| vertex > greatest) {
            self.found = Some((vertex, line));
        }
    }

    fn check(&self, vertex_count: usize) -> Result<()> {
        match self.found {
            Some((vertex, line)) if vertex >= vertex_count as u64 => {
                let named = vertex + 1;
                let message = format!("vertex {named} is named, and there are {vertex_count}");
                Err(at_line(line, message))
            }
            _ => Ok(()),
        }
    }
}

fn too_few(line: u64, what: &str, needed: &str, found: usize) -> crate::error::Error {
    at_line(line, format!("{what} needs {needed} or more, and this one has {found}"))
}

fn is_name(word: &[u8]) -> bool {
    word.first().is_some_and(u8::is_ascii_alphabetic)
        && word.iter().all(|&b| b.is_ascii_alphanumeric() || b == b'_')
}

pub(super) fn write(complex: &Complex, out: &mut Sink<'_>) -> Result<()> {
    if complex.vertices().is_empty() {
        // An object of nothing: a file without a byte may be one that was cut off.
        out.text(format_args!("o empty\n"))?;
    }
    for [x, y, z] in complex.vertices() {
        out.text(format_args!("v {x:?} {y:?} {z:?}\n"))?;
        out.row()?;
    }
    for face in complex.faces().iter() {
        out.text(format_args!("f"))?;
        for &vertex in face {
            out.text(format_args!(" {}", u64::from(vertex) + 1))?;
        }
        out.text(format_args!("\n"))?;
        out.row()?;
    }
    for [a, b] in complex.edges() {
        out.text(format_args!("l {} {}\n", u64::from(*a) + 1, u64::from(*b) + 1))?;
        out.row()?;
    }
    Ok(())
}
