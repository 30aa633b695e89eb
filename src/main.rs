//! tmp
fn main() {
    let path = std::env::args().nth(1).unwrap_or_default();
    let compile = std::env::args().nth(2).is_some();
    struct D;
    impl cnc872c::text::Loader for D {
        fn read(&self, p: &std::path::Path) -> std::io::Result<Vec<u8>> {
            std::fs::read(p)
        }
        fn list(&self, p: &std::path::Path) -> Vec<std::path::PathBuf> {
            let mut v: Vec<_> = std::fs::read_dir(if p.as_os_str().is_empty() { std::path::Path::new(".") } else { p })
                .into_iter()
                .flatten()
                .flatten()
                .map(|e| e.path())
                .filter(|p| p.is_file())
                .collect();
            v.sort();
            v
        }
        fn canonical(&self, p: &std::path::Path) -> std::path::PathBuf {
            p.canonicalize().unwrap_or(p.to_path_buf())
        }
    }
    let settings = cnc872c::config::Settings::default();
    let s = cnc872c::session::Session { loader: &D, settings: &settings, progress: None };
    let o = if compile {
        s.compile(path.as_ref(), &path, Default::default(), &mut std::io::stdout()).unwrap()
    } else {
        s.check(path.as_ref(), &path)
    };
    for d in o.findings.into_sorted() {
        let src = o.sources.get(d.at.file).unwrap();
        let lc = src.line_column(d.at.span.start);
        eprintln!(
            "{}:{}:{}: {} {} | {:?}",
            src.name(),
            lc.line,
            lc.column,
            d.code(),
            d.finding.message(Default::default()),
            src.slice(d.at.span)
        );
    }
}
