//! Writes the generated pages of the documentation and the grammar of the editors: `cargo run --example reference`.

use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

mod pages;
mod textmate;

fn main() -> ExitCode {
    let project = Path::new(env!("CARGO_MANIFEST_DIR"));
    match write(project) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Nothing can be done about a standard error stream that cannot be written to.
            let _ = writeln!(io::stderr(), "reference: cannot write in {}: {error}", project.display());
            ExitCode::FAILURE
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "writing files is all this is for")]
fn write(project: &Path) -> io::Result<()> {
    let pages = pages::pages().into_iter().map(|(name, text)| (format!("{}/{name}", pages::FOLDER), text));
    for (name, text) in pages.chain([(textmate::FILE.to_owned(), textmate::grammar())]) {
        let path = project.join(&name);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::write(path, text)?;
        writeln!(io::stdout(), "{name}")?;
    }
    Ok(())
}
