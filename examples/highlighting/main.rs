//! Writes the files that editors colour part programs by: `cargo run --example highlighting`.

use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

mod files;

fn main() -> ExitCode {
    match write(Path::new(env!("CARGO_MANIFEST_DIR"))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Nothing can be done about a standard error stream that cannot be written to.
            let _ = writeln!(io::stderr(), "highlighting: {error}");
            ExitCode::FAILURE
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "writing files is all this is for")]
fn write(root: &Path) -> io::Result<()> {
    for (name, text) in files::files() {
        let path = root.join(&name);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::write(path, text)?;
        writeln!(io::stdout(), "{name}")?;
    }
    Ok(())
}
