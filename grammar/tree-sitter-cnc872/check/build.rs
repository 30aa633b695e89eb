//! Compiles the parser.

fn main() {
    let source = std::path::Path::new("../src");
    let mut build = cc::Build::new();
    build.include(source).std("c11").warnings_into_errors(true).flag_if_supported("-Wno-unused-parameter");
    for file in ["parser.c", "scanner.c"] {
        let path = source.join(file);
        println!("cargo:rerun-if-changed={}", path.display());
        build.file(path);
    }
    build.opt_level(2).compile("tree-sitter-cnc872");
}
