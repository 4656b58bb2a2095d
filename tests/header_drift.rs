//! `include/medax.h` is what cbindgen makes of `src/capi`, and documents every function.
//!
//! `MEDAX_WRITE_HEADER=1 cargo test --test header_drift` writes it, as `make header` does.

use cbindgen::{Builder, Config};
use std::path::Path;
use std::{env, fs};

/// The chapters of the header in order: the files of `src/capi`.
const CHAPTERS: [&str; 42] = [
    "status",
    "handle",
    "view",
    "attribute",
    "job",
    "validation",
    "points",
    "triangulation",
    "incidence",
    "dual",
    "poles",
    "crust",
    "relabel",
    "variants",
    "sizes",
    "cocone",
    "labels",
    "medial",
    "flow",
    "core",
    "flow_complex",
    "pair",
    "onto",
    "place",
    "half_faces",
    "complex",
    "figure",
    "topology",
    "winding",
    "normals",
    "compare",
    "decimate",
    "flatten",
    "sites",
    "distance",
    "decide",
    "field_axis",
    "medial_graph",
    "balls",
    "file",
    "io",
    "sample",
];

/// What cbindgen puts round the functions of each chapter; the header has it once.
const OPEN: &str = "#ifdef __cplusplus\nextern \"C\" {\n#endif // __cplusplus\n\n";
const CLOSE: &str = "#ifdef __cplusplus\n}  // extern \"C\"\n#endif  // __cplusplus\n";

/// The header as `src/capi` and `cbindgen.toml` have it now.
fn generate() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut config = Config::from_file(root.join("cbindgen.toml")).unwrap();
    let head = config.header.take().unwrap();
    let macros = config.after_includes.take().unwrap();
    let tail = config.trailer.take().unwrap();
    let macros = macros
        .replace("@MAJOR@", env!("CARGO_PKG_VERSION_MAJOR"))
        .replace("@MINOR@", env!("CARGO_PKG_VERSION_MINOR"))
        .replace("@PATCH@", env!("CARGO_PKG_VERSION_PATCH"));
    let mut header = format!("{}\n\n{}\n", head.trim(), macros.trim());
    for (number, chapter) in CHAPTERS.iter().enumerate() {
        let path = root.join(format!("src/capi/{chapter}.rs"));
        header += &banner(number + 1, &fs::read_to_string(&path).unwrap());
        let bindings =
            Builder::new().with_config(config.clone()).with_src(&path).generate().unwrap();
        let mut text = Vec::new();
        bindings.write(&mut text);
        let text = String::from_utf8(text).unwrap();
        header += text.replace(OPEN, "").replace(CLOSE, "").trim();
        header += "\n";
    }
    header + "\n" + tail.trim() + "\n"
}

/// The title of a chapter: the module's own documentation.
fn banner(number: usize, source: &str) -> String {
    let mut lines = source.lines().map_while(|line| line.strip_prefix("//!")).map(str::trim);
    let title = lines.next().unwrap_or_default();
    let rule = "-".repeat(85 - title.len());
    let mut banner = format!("\n/* ---- {number}. {title} {rule}\n");
    for line in lines {
        banner += format!(" * {line}").trim_end();
        banner += "\n";
    }
    banner + " */\n\n"
}

#[test]
fn the_header_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include/medax.h");
    let made = generate();
    if env::var_os("MEDAX_WRITE_HEADER").is_some() {
        fs::write(&path, &made).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    let line = made.lines().zip(found.lines()).position(|(a, b)| a != b);
    assert!(made == found, "include/medax.h is stale from line {line:?} on: run `make header`");
}

#[test]
fn every_function_is_documented_in_full() {
    let header = generate();
    let code = header.split("extern \"C\" {").nth(1).unwrap();
    let mut parts: Vec<&str> = code.split("MEDAX_API").collect();
    for (before, declaration) in parts.clone().iter().zip(parts.drain(1..)) {
        let declaration = declaration.split(';').next().unwrap();
        let text = before.rsplit("/**").next().unwrap();
        assert!(text.trim_end().ends_with("*/"), "no text before {declaration}");
        assert!(text.contains("Since 0."), "no version before {declaration}");
        let (head, arguments) = declaration.split_once('(').unwrap();
        let returns = !head.trim_start().starts_with("void ");
        assert_eq!(text.contains("\\return"), returns, "\\return before {declaration}");
        let name = |argument: &str| {
            argument.trim_end_matches(')').rsplit([' ', '*']).next().unwrap().to_string()
        };
        for argument in arguments.split(',').map(name).filter(|name| name != "void") {
            assert!(
                text.contains(&format!("\\param {argument} ")),
                "\\param {argument} before {declaration}"
            );
        }
    }
}
