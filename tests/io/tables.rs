//! Tables of points: what parts their columns, and where a comment begins.

use medax::Job;
use medax::io::{Format, parse};

fn check(text: &str) {
    for format in [Format::Xyz, Format::Csv] {
        let soup = match parse(text.as_bytes(), format, &Job::default()) {
            Ok(soup) => soup,
            Err(error) => panic!("{text:?}: {error}"),
        };
        assert_eq!(soup.vertices(), [[1.0, 2.0, 3.0]], "{text:?}");
    }
}

#[test]
fn a_comment_ends_the_line_whatever_it_holds() {
    check("1 2 3 # corner a, b");
    check("1,2,3 # note");
    check("1;2;3# a, b");
    check("1 2 3 // a; b");
    check("1, 2 ,3//note");
    check("1 2 3#note");
    check("# a;b\n1 2 3\n#");
    check("// a, b\n1,2,3\n  // 4,5,6\n");
    check("x,y,z # a; b\n1,2,3");
    check("1 # row, just one\n1 2 3");
}

#[test]
fn what_follows_the_first_column_parts_the_others() {
    check("1 2 3 255,0,0");
    check("1 2 3 255;0;0");
    check("1,2,3,255;0;0");
    check("1 , 2 , 3 , a;b c");
    check("1;2;3;a,b");
    check(" 1 ;2; 3;a,b c");
    check("1\t2\t3\ta,b");
    check("1\t,2\t,3");
}
