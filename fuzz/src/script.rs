//! What an editor does, read from bytes.

use crate::SEPARATOR;
use crate::world::FILES;

/// Most steps of a script: more take long, and show nothing else.
const MOST_STEPS: usize = 48;

/// A place as the client names it; may be one that no text has.
pub type Place = (u64, u64);

/// One step. Files are indices of [`FILES`].
#[derive(Clone, Debug)]
pub enum Step {
    Open(usize, String),
    /// The changes of one notification: a range and its new text, or the whole text.
    Change(usize, Vec<(Option<(Place, Place)>, String)>),
    Close(usize),
    Save(usize),
    /// Another program writes a file, or takes it away.
    Disk(usize, Option<Vec<u8>>),
    Settings(u8),
    Folders(u8),
    Request {
        method: u8,
        file: usize,
        from: Place,
        to: Place,
        extra: u8,
        text: String,
    },
    /// Cancels the request so many before.
    Cancel(u8),
    /// Waits for pending messages.
    Settle,
    /// Does the edit of the last answer.
    Apply(u8),
    /// A message that is anything.
    Content(Vec<u8>),
}

/// How the client is, and what it does.
#[derive(Clone, Debug)]
pub struct Script {
    pub client: u8,
    pub way: u8,
    pub settings: u8,
    pub steps: Vec<Step>,
}

impl Script {
    pub fn read(data: &[u8]) -> Option<Self> {
        let (&[client, way, settings], rest) = data.split_first_chunk()?;
        let mut bytes = Bytes(rest);
        let mut steps = Vec::new();
        while steps.len() < MOST_STEPS {
            let Some(verb) = bytes.byte() else { break };
            steps.push(bytes.step(verb));
        }
        Some(Self { client, way, settings, steps })
    }
}

struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn byte(&mut self) -> Option<u8> {
        let (&first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(first)
    }

    fn number(&mut self) -> u8 {
        self.byte().unwrap_or_default()
    }

    /// Digits name files in seeds.
    fn file(&mut self) -> usize {
        usize::from(self.number()) % FILES.len()
    }

    fn coordinate(&mut self) -> u64 {
        match self.number() {
            255 => u64::from(u32::MAX),
            254 => u64::from(i32::MAX.unsigned_abs()) + 1,
            253 => 70_000,
            small => u64::from(small),
        }
    }

    fn place(&mut self) -> Place {
        (self.coordinate(), self.coordinate())
    }

    /// Up to the separator.
    fn bytes(&mut self) -> Vec<u8> {
        let end = self.0.iter().position(|byte| *byte == SEPARATOR).unwrap_or(self.0.len());
        let (piece, rest) = self.0.split_at(end);
        self.0 = rest.get(1..).unwrap_or_default();
        piece.to_vec()
    }

    fn text(&mut self) -> String {
        String::from_utf8_lossy(&self.bytes()).into_owned()
    }

    fn step(&mut self, verb: u8) -> Step {
        const VERBS: &[u8] = b"ocCxswdgfrkeaRl";
        let verb = if VERBS.contains(&verb) { verb } else { VERBS[usize::from(verb) % VERBS.len()] };
        match verb {
            b'o' => Step::Open(self.file(), self.text()),
            b'c' => {
                let file = self.file();
                let count = self.number() % 3 + 1;
                let change = |bytes: &mut Self| (Some((bytes.place(), bytes.place())), bytes.text());
                Step::Change(file, (0..count).map(|_| change(self)).collect())
            }
            b'C' => Step::Change(self.file(), vec![(None, self.text())]),
            b'x' => Step::Close(self.file()),
            b's' => Step::Save(self.file()),
            b'w' => Step::Disk(self.file(), Some(self.bytes())),
            b'd' => Step::Disk(self.file(), None),
            b'g' => Step::Settings(self.number()),
            b'f' => Step::Folders(self.number()),
            b'r' => {
                let (method, file, from, to) = (self.number(), self.file(), self.place(), self.place());
                Step::Request { method, file, from, to, extra: self.number(), text: self.text() }
            }
            b'l' => Step::Open(self.file(), straight(self.number())),
            b'k' => Step::Cancel(self.number()),
            b'e' => Step::Settle,
            b'a' => Step::Apply(self.number()),
            _ => Step::Content(self.bytes()),
        }
    }
}

/// A straight program without findings.
fn straight(kind: u8) -> String {
    let mut text = "%1\nN1 G00 X0 Y0 Z5\nN2 G01 F2000 Z0\n".to_owned();
    let (blocks, kind) = (usize::from(kind % 32) + 4, usize::from(kind / 32));
    for block in 3..blocks {
        let n = block * 10;
        let words = match (block + kind) % 12 {
            3 => "X0 Y0".to_owned(),
            4 => "G02 X0 Y10 I0 J5 \"oblouk".to_owned(),
            5 => "G01 X0 Y0 M08".to_owned(),
            6 => "G91 X1".to_owned(),
            7 => format!("G90 X{block} F{}", 100 + block),
            8 => "S500 M03".to_owned(),
            _ => format!("X{block}.125 Y{kind}.25 Z{}", block % 7),
        };
        text += &format!("N{n} {words}\n");
    }
    text + &format!("N{} M30\n", blocks * 10)
}
