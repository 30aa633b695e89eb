//! Texts of the server, in both languages.

use crate::dict::bilingual;

bilingual! {
    /// A text for the client.
    Text {
        Note { note: String } "note: {note}", "poznámka: {note}";
        Help { help: String } "help: {help}", "nápověda: {help}";
        CalledBy { n: u32, by: &'static str, l: u32 } "called by N{n} {by} L{l}", "voláno z bloku N{n} {by} L{l}";
        NotShown { shown: usize, all: usize }
            "{shown} of {all} findings are shown",
            "zobrazeno je {shown} z {all} hlášení";
        Checking "checking", "kontroluje se";
        Misconfigured
            "the configuration has errors; programs are checked with the default settings",
            "konfigurace obsahuje chyby; programy se kontrolují s výchozím nastavením";
        Settings { wrong: String } "these settings cannot be used: {wrong}", "tato nastavení nelze použít: {wrong}";
    }
}
