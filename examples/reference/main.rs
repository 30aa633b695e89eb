//! Writes the generated pages of the documentation: `cargo run --example reference`.

use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

mod pages;

fn main() -> ExitCode {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(pages::FOLDER);
    match write(&folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Nothing can be done about a standard error stream that cannot be written to.
            let _ = writeln!(io::stderr(), "reference: cannot write to {}: {error}", folder.display());
            ExitCode::FAILURE
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "writing files is all this is for")]
fn write(folder: &Path) -> io::Result<()> {
    for (name, text) in pages::pages() {
        let path = folder.join(&name);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::write(path, text)?;
        writeln!(io::stdout(), "{}/{name}", pages::FOLDER)?;
    }
    Ok(())
}
