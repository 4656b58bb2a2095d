//! Malformed files, one fault each: the error names the line or the byte, and says what is wrong.

use crate::samples;
use medax::io::{Format, parse};
use medax::points::PointsOptions;
use medax::{ElementKind, Job, Status};

/// A text file, the line at fault, and a part of the message.
type Fault<'a> = (&'a str, u64, &'a str);

fn check(format: Format, faults: &[Fault<'_>]) {
    for (text, line, message) in faults {
        let error = match parse(text.as_bytes(), format, &Job::default()) {
            Ok(soup) => panic!("{text:?} was read as {soup:?}"),
            Err(error) => error,
        };
        assert_eq!(error.status(), Status::Format, "{text:?}: {error}");
        assert_eq!(error.element(), Some((ElementKind::Line, *line)), "{text:?}: {error}");
        assert!(error.message().contains(message), "{text:?}: {error}");
    }
}

/// A PLY text of three vertices, with these declarations and rows behind.
fn ply(declarations: &str, rows: &str) -> String {
    format!(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n\
         property double z\n{declarations}end_header\n0 0 0\n1 0 0\n0 1 0\n{rows}"
    )
}

#[test]
fn an_empty_file_is_an_error() {
    use Format::*;
    for format in [Ply, Off, Obj, Stl, Xyz, Csv, Pwn, Ma] {
        let error = parse(b"", format, &Job::default()).unwrap_err();
        assert_eq!(error.element(), Some((ElementKind::Byte, 0)));
        assert_eq!((error.status(), error.message()), (Status::Format, "the file is empty"));
        for blank in [&b"\n"[..], b"  \n\r\n\t", b"\xef\xbb\xbf"] {
            let error = parse(blank, format, &Job::default()).unwrap_err();
            assert_eq!(error.status(), Status::Format, "{format:?} {blank:?}: {error}");
        }
    }
}

#[test]
fn noise_is_an_error_in_every_format() {
    use Format::*;
    let noise: Vec<u8> =
        (0..4096u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 21) as u8).collect();
    for format in [Ply, Off, Obj, Stl, Xyz, Csv, Pwn, Ma] {
        let error = parse(&noise, format, &Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::Format, "{format:?}: {error}");
        assert!(error.message().is_ascii() && error.message().len() < 300, "{format:?}: {error}");
    }
}

#[test]
fn faults_in_a_ply_header() {
    let with = |from: &str, to: &str| ply("", "").replacen(from, to, 1);
    check(
        Format::Ply,
        &[
            (&with("ply", "plx"), 1, "begins with the line 'ply'"),
            (&with("ascii", "binary"), 2, "'binary' is not a PLY format"),
            (&with("1.0", "2.0"), 2, "version"),
            (&with("format ascii 1.0\n", ""), 6, "without a format"),
            (&with("vertex 3", "vertex -3"), 3, "whole number"),
            (&with("vertex 3", "vertex three"), 3, "'three'"),
            (&with("vertex 3", "vertex"), 3, "the line ends"),
            (&with("vertex 3", "vertex 3 3"), 3, "'3' follows"),
            (&with("vertex 3", "vertex 4000000000"), 7, "too few for the 4000000000 rows"),
            (&with("double x", "long x"), 4, "'long' is not a PLY type"),
            (&with("double x", "double"), 4, "the line ends"),
            (&with("property double y\n", ""), 3, "has no property 'y'"),
            (&with("double y", "double x"), 5, "declared twice"),
            (&with("double y", "list uchar double y"), 3, "is a list"),
            (&with("element vertex 3\n", ""), 3, "before the first element"),
            (&with("element vertex", "element points"), 7, "no element 'vertex'"),
            (&with("end_header\n", ""), 7, "does not belong in a PLY header"),
            ("ply\nformat ascii 1.0\nelement vertex 3\n", 3, "before 'end_header'"),
            (&ply("element vertex 1\nproperty int a\n", ""), 7, "declared twice"),
            (
                &ply("element face 1\nproperty list float int vertex_indices\n", "3 0 1 2"),
                8,
                "whole type",
            ),
            (
                &ply("element face 1\nproperty list int float vertex_indices\n", "3 0 1 2"),
                7,
                "whole type",
            ),
            (&ply("element face 1\nproperty int vertex_indices\n", "3"), 7, "must be a list"),
            (&ply("element face 1\nproperty int a\n", "3"), 7, "no property 'vertex_indices'"),
            (&ply("element edge 1\nproperty int vertex1\n", "0 1"), 7, "no property 'vertex2'"),
            (
                &ply("element edge 1\nproperty int vertex1\nproperty float vertex2\n", "0 1"),
                7,
                "whole type",
            ),
        ],
    );
}

#[test]
fn faults_in_ply_rows() {
    let face = |rows: &str| ply("element face 2\nproperty list uchar int vertex_index\n", rows);
    let edge = |rows: &str| {
        ply("element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty char c\n", rows)
    };
    let vertex = |row: &str| ply("", "").replacen("1 0 0", row, 1);
    check(
        Format::Ply,
        &[
            (&vertex("1 zero 0"), 9, "the value must be a number, not 'zero'"),
            (&vertex("1.0 0"), 9, "the line ends"),
            (&vertex("1 0 0 0"), 9, "'0' follows"),
            (&ply("", "9 9 9\n"), 11, "'9' follows the last row"),
            (&face("3 0 1 2\n"), 13, "before the last of the 2 rows"),
            (&face("3 0 1 2        \n"), 13, "the file ends here, before the last of the 2 rows"),
            (&face("3 0 1 2\n3 0 1 3\n"), 14, "no vertex 3 among 3"),
            (&face("3 0 1 -1\n3 0 1 2\n"), 13, "no vertex -1 among 3"),
            (&face("3 0 1 4294967296\n3 0 1 2\n"), 13, "'4294967296' is not a whole number"),
            (&face("3 0 1\n3 0 1 2\n"), 13, "the line ends"),
            (&face("3 0 1 2 0\n3 0 1 2\n"), 13, "'0' follows"),
            (&face("2 0 1\n3 0 1 2\n"), 13, "three corners or more, and has 2"),
            (&face("0\n3 0 1 2\n"), 13, "three corners or more, and has 0"),
            (&face("-3 0 1 2\n3 0 1 2\n"), 13, "'-3' is not a whole number of its type"),
            (&face("256 0 1 2\n3 0 1 2\n"), 13, "'256' is not a whole number of its type"),
            (&edge("0 3 0\n"), 15, "no vertex 3 among 3"),
            (&edge("0 1 128\n"), 15, "'128' is not a whole number of its type"),
            (&edge("0 1.5 0\n"), 15, "'1.5' is not a whole number"),
        ],
    );
}

#[test]
fn faults_in_binary_ply() {
    let good = samples::ply("binary_little_endian");
    let start = good.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    // Where the two faces begin: an i32 length, three u16 corners, an f32.
    let faces = good.len() - 6 - 28;
    let fault = |edit: &dyn Fn(&mut Vec<u8>), byte: usize, message: &str| {
        let mut bytes = good.clone();
        edit(&mut bytes);
        let error = parse(&bytes, Format::Ply, &Job::default()).unwrap_err();
        assert_eq!(error.element(), Some((ElementKind::Byte, byte as u64)), "{error}");
        assert_eq!(error.status(), Status::Format);
        assert!(error.message().contains(message), "{error}");
    };
    let header = |from: &str, to: &str| {
        let text = String::from_utf8_lossy(&good[..start]).replacen(from, to, 1);
        [text.as_bytes(), &good[start..]].concat()
    };
    let end = good.len();
    fault(&|b| b.push(b'x'), end, "1 bytes follow the last row");
    fault(&|b| b[faces + 4] = 4, faces + 4, "no vertex 4 among 4");
    fault(&|b| b[faces] = 2, faces, "three corners or more, and has 2");
    fault(&|b| b[faces + 3] = 0x80, faces, "negative");
    fault(&|b| b[faces + 3] = 0x7f, end, "the file ends here");
    fault(&|b| b[end - 6..end - 4].copy_from_slice(&[255, 255]), end - 6, "no vertex -1");
    let promise = |to: &str| header("vertex 4", to);
    let longer = promise("vertex 4000000000");
    fault(
        &|b| *b = longer.clone(),
        longer.len(),
        "before the last of the 4000000000 rows of element 'vertex'",
    );
    let longest = promise("vertex 18446744073709551615");
    fault(&|b| *b = longest.clone(), longest.len(), "the file ends here");
}

#[test]
fn faults_in_off() {
    check(
        Format::Off,
        &[
            ("3 1 0\n0 0 0\n", 1, "begins with the keyword OFF, not '3'"),
            ("XOFF\n1 0 0\n0 0 0\n", 1, "'XOFF'"),
            ("OFFS\n1 0 0\n0 0 0\n", 1, "'OFFS'"),
            ("OFF\n", 1, "before the counts"),
            ("OFF\n\n# c\n1\n0 0 0\n", 4, "the line ends before the number of faces"),
            ("OFF\n1 none 0\n0 0 0\n", 2, "'none'"),
            ("OFF\n-1 0 0\n0 0 0\n", 2, "'-1'"),
            ("OFF\n1 0 0 0\n0 0 0\n", 2, "'0' follows the counts"),
            ("OFF 4000000000 0 0\n0 0 0\n", 1, "too few for the 4000000000 vertices"),
            ("OFF\n1 4000000000 0\n0 0 0\n", 2, "too few for the 4000000000 faces"),
            ("OFF\n2 0 0\n0 0 0\n      ", 4, "the file ends here, before the last vertex"),
            ("OFF\n1 0 0\n0 0\n\n", 3, "the line ends before z"),
            ("OFF\n1 0 0\n0 0 x\n", 3, "z must be a number, not 'x'"),
            ("OFF\n1 0 0\n0 0 0 1\n", 3, "1 numbers follow the vertex"),
            ("OFF\n1 0 0\n0 0 0 red\n", 3, "'red'"),
            ("COFF\n1 0 0\n0 0 0\n", 3, "0 numbers follow the vertex"),
            ("NOFF\n1 0 0\n0 0 0 0 1\n", 3, "the line ends before nz"),
            ("STOFF\n1 0 0\n0 0 0 1\n", 3, "1 numbers follow the vertex"),
            ("OFF\n1 0 0\n0 0 0\n3 0 0 0\n", 4, "'3' follows the last face"),
            ("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", 5, "a vertex from 0 to below 3, not '3'"),
            ("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", 5, "'-1'"),
            ("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1.0\n", 5, "'1.0'"),
            ("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n", 5, "the line ends before a corner"),
            ("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1  \n", 5, "this one has 2"),
            ("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0 0\n", 5, "2 numbers follow the face"),
        ],
    );
    for kind in ["OFF BINARY\n", "4OFF\n1 0 0\n0 0 0 1\n", "nOFF\n3\n1 0 0\n0 0 0\n"] {
        let error = parse(kind.as_bytes(), Format::Off, &Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::Unsupported, "{kind:?}");
        assert_eq!(error.element(), Some((ElementKind::Line, 1)), "{kind:?}");
    }
}

#[test]
fn faults_in_obj() {
    let after = |statement: &str| format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{statement}");
    check(
        Format::Obj,
        &[
            ("# nothing\n", 1, "holds no vertex"),
            ("g nothing\n", 1, "holds no vertex"),
            ("o nothing\nf 1 1 1\n", 2, "vertex 1 is named, and there are 0"),
            ("v 0 0\n", 1, "three coordinates or more, and this one has 2"),
            ("v 0 nil 0\n", 1, "y must be a number, not 'nil'"),
            ("v 0 0 0\n\x01\x02 1\n", 2, "does not begin an OBJ statement"),
            ("v 0 0 0\n1 2 3\n", 2, "'1' does not begin"),
            (&after("f 1 2\n"), 4, "a face needs three or more, and this one has 2"),
            (&after("f\n"), 4, "this one has 0"),
            (
                &after("f 1 2 4\nv 0 0 1\nf 1 2 9\nf 1 2 5\n"),
                6,
                "vertex 9 is named, and there are 4",
            ),
            (&after("f 0 1 2\n"), 4, "count from 1"),
            (&after("f 1 2 -4\n"), 4, "'-4' counts back past"),
            (&after("f 1 2 99999999999999999999\n"), 4, "'99999999999999999999' does not name"),
            (&after("f 1 2 3.5\n"), 4, "'3.5'"),
            (&after("f 1//x 2//1 3//1\n"), 4, "'1//x'"),
            (&after("f 1/1/1/1 2 3\n"), 4, "'1/1/1/1'"),
            (&after("f /1 2 3\n"), 4, "'/1'"),
            (&after("l 1\n"), 4, "a line needs two or more"),
            (&after("l 1 7\n"), 4, "vertex 7"),
            (&after("f 1 2 \\\n"), 4, "before the continued statement"),
            (&after("f 1 2 \\\nx\n"), 4, "'x' does not name a vertex"),
        ],
    );
}

#[test]
fn faults_in_stl() {
    let text = std::str::from_utf8(samples::STL_TEXT).unwrap();
    let with = |from: &str, to: &str| text.replacen(from, to, 1);
    check(
        Format::Stl,
        &[
            (&with("facet", "facit"), 2, "'facet' belongs here, not 'facit'"),
            (&with("outer loop", "outer"), 3, "the line ends before 'loop'"),
            (&with("vertex 1 0 0", "vertex 1 0"), 5, "before z"),
            (&with("vertex 1 0 0", "vertex 1 0 0 0"), 5, "'0' follows"),
            (&with("vertex 1 0 0", "vertex 1 O 0"), 5, "y must be a number, not 'O'"),
            (&with("      vertex 1 0 0\n", ""), 6, "'vertex' belongs here, not 'endloop'"),
            (&with("endloop", "vertex 0 0 9"), 7, "'endloop' belongs here, not 'vertex'"),
            (&with("endsolid\n", ""), 9, "'facet' belongs here, not 'solid'"),
            (&with("endsolid another\n", ""), 17, "before 'endsolid'"),
            (&format!("{text}facet\n"), 19, "'solid' belongs here, not 'facet'"),
        ],
    );
    let good = samples::stl(b"", &samples::QUAD);
    let fault = |bytes: &[u8], byte: u64, message: &str| {
        let error = parse(bytes, Format::Stl, &Job::default()).unwrap_err();
        assert_eq!(error.element(), Some((ElementKind::Byte, byte)), "{error}");
        assert!(error.message().contains(message), "{error}");
    };
    fault(&good[..83], 83, "too short for a binary STL");
    fault(&[&good[..], b"\0"].concat(), 184, "bytes follow the last of the 2 facets");
    let mut huge = good.clone();
    huge[80..84].fill(0xff);
    fault(&huge, 184, "before the last of the 4294967295 facets");
}

#[test]
fn faults_in_tables() {
    let faults: [Fault<'_>; 19] = [
        ("# nothing\n", 1, "holds no row"),
        ("0 0 0\n1 2\n", 2, "the line ends before z"),
        ("0 0 0\n1 two 3\n", 2, "y must be a number, not 'two'"),
        ("0 0 0\nx y z\n", 2, "x must be a number, not 'x'"),
        ("0,0,0\n1,,3\n", 2, "the column of y is empty"),
        ("0,0,0\n1,2\n", 2, "the line ends before z"),
        ("0,0,0\n1 2,3,4\n", 2, "y must be a number, not '2,3,4'"),
        ("0;0;0\n0,5;1;1\n", 2, "y must be a number, not '5;1;1'"),
        ("0;0;0\n5;0,5;1\n", 2, "y must be a number, not '0,5'"),
        ("0 0 0\n0 0, 0\n", 2, "y must be a number, not '0,'"),
        ("0 0 0\n0 0 # 0\n", 2, "the line ends before z"),
        ("0,0,0\n0,0,#0\n", 2, "the column of z is empty"),
        (",0,0\n", 1, "the column of x is empty"),
        ("0;0;0\n1;2;\n", 2, "the column of z is empty"),
        ("3\n0 0 0\n1 1 1\n2 2  ", 4, "the line ends before z"),
        ("3\n0 0 0\n1 1 1\n      ", 4, "the file ends here, before row 3"),
        ("2\n0 0 0\n1 1 1\n2 2 2\n", 4, "a row follows the 2 promised"),
        ("4000000000\n0 0 0\n", 1, "only 6 bytes follow, too few for the 4000000000 rows"),
        ("name,x,y,z\na,0,0,0\n", 1, "x must be a number, not 'name'"),
    ];
    check(Format::Xyz, &faults);
    check(Format::Csv, &faults);
    check(
        Format::Pwn,
        &[
            ("0 0 0\n", 1, "begins with the number of points"),
            ("many\n0 0 0\n", 1, "begins with the number of points"),
            ("-1\n0 0 0\n", 1, "begins with the number of points"),
            ("1\n0 0 0\n", 1, "too few for the 1 points with normals"),
            ("1\n0 0 0\n      \n", 3, "before the last normal"),
            ("1\n0 0 0\n0 0 1\n0 0 2\n", 4, "a row follows the last normal"),
            ("1\n0 0 0\n0 0 up\n", 3, "z must be a number, not 'up'"),
            ("4000000000\n0 0 0\n", 1, "4000000000 points"),
        ],
    );
}

#[test]
fn counts_past_64_bits_are_told_as_the_file_has_them() {
    let count = "99999999999999999999999";
    let told = |what: &str| format!("{what} is '{count}', more than any file holds");
    let header = ply("", "").replacen("vertex 3", &format!("vertex {count}"), 1);
    check(Format::Ply, &[(&header, 3, &told("the number of rows"))]);
    let off = format!("OFF\n1 {count} 0\n0 0 0\n");
    check(Format::Off, &[(&off, 2, &told("the number of faces"))]);
    check(Format::Xyz, &[(&format!("{count}\n0 0 0\n"), 1, &told("the number of rows"))]);
    check(Format::Pwn, &[(&format!("{count}\n0 0 0\n"), 1, &told("the number of rows"))]);
    let ma = format!("{count} 0 0\nv 0 0 0 1\n");
    check(Format::Ma, &[(&ma, 1, &told("the number of vertices"))]);
}

#[test]
fn faults_in_ma() {
    check(
        Format::Ma,
        &[
            ("1 0\nv 0 0 0 1\n", 1, "before the number of faces"),
            ("1 0 0 0\nv 0 0 0 1\n", 1, "'0' follows the counts"),
            ("4000000000 0 0\nv 0 0 0 1\n", 1, "4000000000 vertices"),
            ("1 4000000000 0\nv 0 0 0 1\n", 1, "4000000000 edges"),
            ("1 0 4000000000\nv 0 0 0 1\n", 1, "4000000000 faces"),
            ("1 0 0\nv 0 0 0\n\n\n", 2, "before the radius"),
            ("1 0 0\nv 0 0 0 big\n", 2, "the radius must be a number, not 'big'"),
            ("1 0 0\nv 0 0 0 1\nv 0 0 0 1\n", 3, "more vertices than promised"),
            ("1 0 0\nw 0 0 0 1\n", 2, "begins with v, e or f, not 'w'"),
            ("2 1 0\nv 0 0 0 1\nv 0 0 1 1\ne 0 2\n", 4, "below 2, not '2'"),
            ("2 1 0\nv 0 0 0 1\nv 0 0 1 1\ne 0\n      ", 4, "the line ends before a corner"),
            (
                "2 1 0\nv 0 0 0 1\nv 0 0 1 1\n      \n",
                4,
                "the file ends here, before the last 1 of the edges",
            ),
        ],
    );
}

#[test]
fn numbers_that_a_float_cannot_hold_are_refused() {
    let digits = "1".repeat(400);
    let (small, large) = (format!("0.{}1", "0".repeat(400)), format!("-{digits}.5"));
    for (word, is) in [
        ("1e400", "large"),
        ("-1e400", "large"),
        ("1.8E308", "large"),
        (&large, "large"),
        ("1e-400", "small"),
        ("-0.00001e-330", "small"),
        ("2e-324", "small"),
        (&small, "small"),
    ] {
        let message = format!("is too {is} for double precision: '{}", &word[..word.len().min(24)]);
        check(Format::Xyz, &[(&format!("0 0 0\n1 {word} 0\n"), 2, &format!("y {message}"))]);
        check(Format::Csv, &[(&format!("0,0,0\n1, {word},0\n"), 2, &format!("y {message}"))]);
        check(Format::Pwn, &[(&format!("1\n0 0 0\n{word} 0 0\n"), 3, &format!("x {message}"))]);
        check(Format::Off, &[(&format!("OFF\n1 0 0\n0 0 {word}\n"), 3, &format!("z {message}"))]);
        check(Format::Obj, &[(&format!("v 0 0 {word}\n"), 1, &format!("z {message}"))]);
        let radius = format!("the radius {message}");
        check(Format::Ma, &[(&format!("1 0 0\nv 0 0 0 {word}\n"), 2, &radius)]);
        let text = std::str::from_utf8(samples::STL_TEXT).unwrap();
        let corner = text.replacen("vertex 1 0 0", &format!("vertex 1 {word} 0"), 1);
        check(Format::Stl, &[(&corner, 5, &format!("y {message}"))]);
        let row = ply("", "").replacen("1 0 0", &format!("1 0 {word}"), 1);
        check(Format::Ply, &[(&row, 9, &message)]);
    }
    let single = |word: &str| {
        let text = ply("", "").replace("double y", "float y");
        text.replacen("1 0 0", &format!("1 {word} 0"), 1)
    };
    check(
        Format::Ply,
        &[
            (&single("1e39"), 9, "the value is too large for single precision: '1e39'"),
            (&single("-1e-46"), 9, "the value is too small for single precision: '-1e-46'"),
        ],
    );
    // In double precision these are numbers like any other, and so are the last ones.
    for word in ["1e39", "-1e-46", "5e-324", "1.7976931348623157e308"] {
        let soup = parse(format!("{word} 0 0\n").as_bytes(), Format::Xyz, &Job::default()).unwrap();
        assert_eq!(soup.vertices()[0][0], word.parse::<f64>().unwrap());
    }
    let zeros = b"0e400 -0.000e-999 0\n-0 .0 00e5\n";
    let soup = parse(zeros, Format::Xyz, &Job::default()).unwrap();
    assert_eq!(soup.vertices(), [[0.0; 3]; 2]);
    let soup = parse(b"inf -Infinity +nan\n", Format::Xyz, &Job::default()).unwrap();
    let [x, y, z] = soup.vertices()[0];
    assert!(x == f64::INFINITY && y == f64::NEG_INFINITY && z.is_nan());
}

#[test]
fn rows_that_are_not_finite_are_kept_for_the_points_to_judge() {
    let job = Job::default();
    let soup = parse(b"0 0 0\nNaN 0 0\n1 -inf 0\n1 1 1\n", Format::Xyz, &job).unwrap();
    assert!(soup.vertices()[1][0].is_nan());
    assert_eq!(soup.vertices()[2][1], f64::NEG_INFINITY);
    let error = soup.points(PointsOptions::default(), &job).unwrap_err();
    assert_eq!(error.status(), Status::NonFinite);
    assert_eq!(error.element(), Some((ElementKind::Row, 1)));
    let points = soup.points(PointsOptions { skip_non_finite: true }, &job).unwrap();
    assert_eq!((points.len(), points.skipped_count()), (2, 2));
    let error = soup.into_complex().unwrap_err();
    assert_eq!((error.status(), error.element()), (Status::NonFinite, Some((ElementKind::Row, 1))));
}

#[test]
fn a_file_without_points_names_the_place_that_says_so() {
    let ply = |encoding: &str| {
        let properties = "property float x\nproperty float y\nproperty float z\n";
        format!("ply\nformat {encoding} 1.0\nelement vertex 0\n{properties}end_header\n")
    };
    let (text, little) = (ply("ascii"), ply("binary_little_endian"));
    let binary = samples::stl(b"", &[]);
    let cases: [(Format, &[u8], ElementKind, u64); 10] = [
        (Format::Xyz, b"# of nothing\n0\n\n", ElementKind::Line, 2),
        (Format::Csv, b"# columns\nx;y;z\n", ElementKind::Line, 2),
        (Format::Obj, b"o nothing\n", ElementKind::Line, 1),
        (Format::Pwn, b"0\n", ElementKind::Line, 1),
        (Format::Off, b"OFF\n# none\n0 0 0\n", ElementKind::Line, 3),
        (Format::Ma, b"0 0 0\n", ElementKind::Line, 1),
        (Format::Ply, text.as_bytes(), ElementKind::Line, 3),
        (Format::Ply, little.as_bytes(), ElementKind::Line, 3),
        (Format::Stl, b"solid\n\nendsolid\n", ElementKind::Line, 3),
        (Format::Stl, &binary, ElementKind::Byte, 80),
    ];
    for (format, bytes, kind, index) in cases {
        let soup = parse(bytes, format, &Job::default()).unwrap();
        let error = soup.points(PointsOptions::default(), &Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::TooFewPoints, "{format:?}");
        assert_eq!(error.element(), Some((kind, index)), "{format:?}: {error}");
        // As a complex it is empty, and sound.
        assert!(soup.into_complex().unwrap().vertices().is_empty());
    }
    // Rows that are left out are still rows: no place of the file is at fault.
    let soup = parse(b"nan 0 0\n", Format::Xyz, &Job::default()).unwrap();
    let skip = PointsOptions { skip_non_finite: true };
    let error = soup.points(skip, &Job::default()).unwrap_err();
    assert_eq!((error.status(), error.element()), (Status::TooFewPoints, None));
}

#[test]
fn a_face_or_edge_that_repeats_a_vertex_is_read_and_is_no_complex() {
    for (text, kind, index) in [
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n", ElementKind::Face, 1),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3 3\n", ElementKind::Edge, 2),
    ] {
        let soup = parse(text.as_bytes(), Format::Obj, &Job::default()).unwrap();
        assert_eq!(soup.points(PointsOptions::default(), &Job::default()).unwrap().len(), 3);
        let error = soup.into_complex().unwrap_err();
        assert_eq!((error.status(), error.element()), (Status::Format, Some((kind, index))));
    }
}

#[test]
fn vtu_is_not_read() {
    let error = parse(b"<VTKFile/>", Format::Vtu, &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::Unsupported);
}
