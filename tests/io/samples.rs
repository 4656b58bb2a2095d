//! Small valid files, one or more of every format that is read.

use medax::io::Format;

/// A valid file.
pub struct Sample {
    pub name: &'static str,
    pub format: Format,
    pub bytes: Vec<u8>,
    /// Vertices, faces, edges.
    pub counts: [usize; 3],
    /// Whether the file says how much it holds, so that a truncated one can be told.
    pub is_counted: bool,
}

/// The bytes of a PLY file of two triangles, an edge, and an element and lists to be stepped over.
pub fn ply(encoding: &str) -> Vec<u8> {
    let header = format!(
        "ply\nformat {encoding} 1.0\ncomment element face 99\nobj_info made by hand\n\
         element extra 2\nproperty list ushort double junk\nproperty char c\n\
         element vertex 4\nproperty uchar red\nproperty float x\nproperty int y\nproperty list uint8 int8 l\n\
         property double z\nproperty double radius\n\
         element face 2\nproperty list int32 uint16 vertex_index\nproperty float32 angle\n\
         element edge 1\nproperty short vertex1\nproperty uint vertex2\nend_header\n"
    );
    let mut bytes = header.into_bytes();
    if encoding == "ascii" {
        bytes.extend(
            b"2 0.5 -7 -128\n0 127\n1 0.5 -3 0 0.25 1\n\n2 1e10 4 1 -5 -0.5 2\r\n\
              3 -0.1 5 2 1 2 0.1 3\n255 nan 6 0 1 4\n3 0 1 2 0.75\n3 3 2 1 -1\n0 3",
        );
        return bytes;
    }
    let big = encoding.contains("big");
    let mut put = |little: &[u8]| match big {
        true => bytes.extend(little.iter().rev()),
        false => bytes.extend(little),
    };
    put(&2u16.to_le_bytes());
    put(&0.5f64.to_le_bytes());
    put(&(-7f64).to_le_bytes());
    put(&(-128i8).to_le_bytes());
    put(&0u16.to_le_bytes());
    put(&127i8.to_le_bytes());
    type Vertex = (u8, f32, i32, &'static [i8], f64, f64);
    let vertices: [Vertex; 4] = [
        (1, 0.5, -3, &[], 0.25, 1.0),
        (2, 1e10, 4, &[-5], -0.5, 2.0),
        (3, -0.1, 5, &[1, 2], 0.1, 3.0),
        (255, f32::NAN, 6, &[], 1.0, 4.0),
    ];
    for (red, x, y, list, z, radius) in vertices {
        put(&[red]);
        put(&x.to_le_bytes());
        put(&y.to_le_bytes());
        put(&[list.len() as u8]);
        for value in list {
            put(&value.to_le_bytes());
        }
        put(&z.to_le_bytes());
        put(&radius.to_le_bytes());
    }
    for (face, angle) in [([0u16, 1, 2], 0.75f32), ([3, 2, 1], -1.0)] {
        put(&3i32.to_le_bytes());
        for vertex in face {
            put(&vertex.to_le_bytes());
        }
        put(&angle.to_le_bytes());
    }
    put(&0i16.to_le_bytes());
    put(&3u32.to_le_bytes());
    bytes
}

/// A binary STL of these facets, whose header begins with the given text.
pub fn stl(header: &[u8], facets: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, 0);
    bytes.extend((facets.len() as u32).to_le_bytes());
    for facet in facets {
        for value in [0f32; 3].iter().chain(facet.as_flattened()) {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// Two triangles that share an edge.
pub const QUAD: [[[f32; 3]; 3]; 2] = [
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5]],
    [[-0.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.1]],
];

/// The same as a text.
pub const STL_TEXT: &[u8] = b"solid two words
  facet normal 0 0 1
    outer loop
      vertex 0 0 0
      vertex 1 0 0
      vertex 1 1 0.5
    endloop
  endfacet
endsolid
solid another
facet normal nan nan nan
OUTER LOOP
vertex -0 0 0
vertex 1.0e0 1 .5
vertex 0 1 0.1
endloop
endfacet
endsolid another
";

pub const OFF: &[u8] = b"# a comment
OFF # the counts follow
4 2

0 0 0   # the first
1.5 0 0 255 0 0
0 1 0 0.1 0.2 0.3 1
0 0 -1e-3
4 0 1 2 3
3 0 2 1 255 128 0
";

pub const OBJ: &[u8] = b"# made by hand
mtllib C:\\a\\
o thing
v 0 0 0
v 1 0 0 1.0
v 1 1 0 0.5 0.5 0.5
vt 0 0
vn 0 0 1
f 1 2 \\
  3
f -1//1 -2//1 -3//1
f 1/1 2/1 3/1 5/1
f 1/1/1 2/1/1 4/1/1
v 0 1 0
v 0 0 1
s off
l 4 5 1
";

pub const MA: &[u8] = b"4 2 1
v 0 0 0 0.5
v 1 0 0 0.25 1 1
v 0 1 0 1e-3
v 0 0 1 2
e 0 1
e 2 3 1
f 0 1 2 7
";

pub fn all() -> Vec<Sample> {
    let sample = |name, format, bytes: &[u8], counts, is_counted| Sample {
        name,
        format,
        bytes: bytes.to_vec(),
        counts,
        is_counted,
    };
    vec![
        sample("PLY text", Format::Ply, &ply("ascii"), [4, 2, 1], true),
        sample("PLY little endian", Format::Ply, &ply("binary_little_endian"), [4, 2, 1], true),
        sample("PLY big endian", Format::Ply, &ply("binary_big_endian"), [4, 2, 1], true),
        sample("OFF", Format::Off, OFF, [4, 2, 0], true),
        sample(
            "NCOFF",
            Format::Off,
            b"CNOFF 3 1 3\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 0 255 0\n0 1 0 0 0 1 0 0 255\n3 0 1 2\n",
            [3, 1, 0],
            true,
        ),
        sample("OBJ", Format::Obj, OBJ, [5, 4, 2], false),
        sample("STL binary", Format::Stl, &stl(b"solid in name only", &QUAD), [4, 2, 0], true),
        // Two solids: a truncated file can hold the first one whole.
        sample("STL text", Format::Stl, STL_TEXT, [4, 2, 0], false),
        sample(
            "STL text in capitals",
            Format::Stl,
            &STL_TEXT.to_ascii_uppercase(),
            [4, 2, 0],
            false,
        ),
        sample("XYZ", Format::Xyz, b"0 0 0\n1 2 3\n\n# 4\n4\t5\t6 7\n", [3, 0, 0], false),
        sample("PTS", Format::Xyz, b"3\n0 0 0 12 0 0 0\n1 2 3 4 0 0 0\n4 5 6 7 0 0 0\n", [3, 0, 0], true),
        sample("CSV", Format::Csv, b"X, \"y\",Z,name\n0,0,0,a b\n 1 , 2,3,\n", [2, 0, 0], false),
        sample("CSV with semicolons", Format::Csv, b"x;y;z\n0;0;0\n 1 ; 2;3;a,b\n", [2, 0, 0], false),
        sample("PWN", Format::Pwn, b"2\n0 0 0\n1 2 3\n0 0 1\n0 1 0\n", [2, 0, 0], true),
        sample("MA", Format::Ma, MA, [4, 1, 2], true),
    ]
}
