//! `git diff` with the driver that the guides describe.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::cli::Place;

const PROJECT: &str = "macrocycles = [\"macros\"]\n";
const MACROCYCLE: &str = "N1 G79 L9001\nN2 G01 X20\nN3 G70\n";

fn program(depth: &str) -> String {
    format!("%1\nN10 G54 G90 G00 X0 Y0 Z50\nN20 T1 M06\nN30 S900 M03 F200\nN40 G01 Z-{depth}\nN50 G72 L9001\nN60 M30\n")
}

/// The commands of a guide that set the driver up.
fn commands(lang: &str) -> String {
    let guide = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("docs/guide/compare.{lang}.md")));
    let guide = guide.unwrap();
    let (_, from) = guide.split_once("```sh\necho '*.nc diff=cnc'").unwrap();
    let (commands, _) = from.split_once("```").unwrap();
    format!("echo '*.nc diff=cnc'{commands}")
}

/// With a project file that names a folder of macrocycles, and with macrocycles next to the program.
#[test]
fn as_a_driver_of_git() {
    let binary = Path::new(env!("CARGO_BIN_EXE_cnc872c")).parent().unwrap().display().to_string();
    let path = format!("{binary}:{}", std::env::var("PATH").unwrap());
    for lang in ["en", "cs"] {
        let place = Place::with(&[
            ("parts/cnc872c.toml", PROJECT.as_bytes()),
            ("parts/macros/L9001", MACROCYCLE.as_bytes()),
            ("parts/p.nc", program("5").as_bytes()),
            ("L9001", MACROCYCLE.as_bytes()),
            ("q.nc", program("2").as_bytes()),
        ]);
        let sh = |script: &str| {
            let mut command = Command::new("sh");
            command.args(["-ec", script]).current_dir(place.path("")).env("PATH", &path).env("LC_ALL", "C");
            let output = command.env("GIT_CONFIG_GLOBAL", "/dev/null").output().unwrap();
            let stderr = String::from_utf8(output.stderr).unwrap();
            assert!(output.status.success(), "{stderr}");
            String::from_utf8(output.stdout).unwrap() + &stderr
        };
        let identity = "git config user.email a@example.org; git config user.name A";
        sh(&format!("git init -q; {identity}\n{}git add .; git commit -qm 1", commands(lang)));
        place.put("parts/p.nc", program("6.25"));
        place.put("q.nc", program("3.25"));
        let said = sh("git --no-pager diff");
        assert_eq!(said.matches("T1: Z −1.25 in 1 block (N40)").count(), 2, "{lang}: {said}");
        assert!(!said.contains("E0405"), "{said}");
    }
}
