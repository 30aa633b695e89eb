//! Columns and their header as one deflated stream, and that stream as text of a page.

use flate2::{Compress, Compression, FlushCompress};

use super::column::{Column, Form};
use crate::parallel;
use crate::sure::{Sure, small};

/// Bytes that are deflated together; pieces are independent of one another, so that all processors work.
const PIECE: usize = 1 << 19;

/// Deflate level: of the higher ones the columns get no shorter, only slower.
const LEVEL: u32 = 5;

/// The columns of a page by name, with a header of JSON.
#[derive(Debug, Default)]
pub(super) struct Container {
    columns: Vec<(String, Form)>,
    bytes: Vec<u8>,
    texts: Vec<(&'static str, Long)>,
}

/// Bytes that are kept deflated only: texts may be as long as the program.
#[derive(Debug, Default)]
pub(super) struct Long {
    count: usize,
    deflated: Vec<u8>,
    open: Vec<u8>,
}

impl Long {
    /// Adds bytes.
    pub fn push(&mut self, mut bytes: &[u8]) {
        self.count += bytes.len();
        while !bytes.is_empty() {
            let room = (PIECE - self.open.len()).min(bytes.len());
            let (now, later) = bytes.split_at_checked(room).unwrap_or((bytes, &[]));
            self.open.extend_from_slice(now);
            bytes = later;
            if self.open.len() == PIECE {
                self.deflated.extend_from_slice(&deflate(&self.open));
                self.open.clear();
            }
        }
    }

    fn finish(mut self) -> Vec<u8> {
        if !self.open.is_empty() {
            self.deflated.extend_from_slice(&deflate(&self.open));
        }
        self.deflated
    }
}

impl Container {
    /// Packs columns under their names, on all processors.
    pub fn add_all(&mut self, columns: Vec<(String, &Column)>) {
        let filled = columns.into_iter().filter(|(_, column)| column.len() > 0).collect();
        let packed = parallel::map(filled, |(name, column): (String, &Column)| {
            let mut bytes = Vec::new();
            let form = column.pack(&mut bytes);
            (name, form, bytes)
        });
        for (name, form, bytes) in packed {
            self.bytes.extend_from_slice(&bytes);
            self.columns.push((name, form));
        }
    }

    /// Adds a text under its name.
    pub fn add_text(&mut self, name: &'static str, text: Long) {
        self.texts.push((name, text));
    }

    /// The stream: the length of the header in four bytes, the header (the object of `fields`, with `columns` and
    /// `texts` added), the columns, the texts; deflated.
    pub fn finish(self, mut fields: serde_json::Map<String, serde_json::Value>) -> Vec<u8> {
        let forms = self.columns.iter().map(|(name, form)| {
            let Form { count, order, sparse, wide, bytes } = *form;
            serde_json::json!([name, count, order, u8::from(sparse), u8::from(wide), bytes])
        });
        fields.insert("columns".into(), forms.collect());
        let texts = self.texts.iter().map(|(name, text)| serde_json::json!([name, text.count]));
        fields.insert("texts".into(), texts.collect());
        let header = serde_json::Value::Object(fields).to_string().into_bytes();
        let mut head = small(header.len()).to_le_bytes().to_vec();
        head.extend_from_slice(&header);
        let pieces: Vec<&[u8]> = head.chunks(PIECE).chain(self.bytes.chunks(PIECE)).collect();
        let deflated: Vec<Vec<u8>> = parallel::map(pieces, deflate);
        let mut stream = deflated.concat();
        for (_, text) in self.texts {
            stream.extend_from_slice(&text.finish());
        }
        // The last block: empty.
        stream.extend_from_slice(&[3, 0]);
        stream
    }
}

/// One piece of a raw deflate stream, whole bytes of it, without the last block.
fn deflate(piece: &[u8]) -> Vec<u8> {
    let mut out = Vec::with_capacity(piece.len() / 2 + 64);
    let mut state = Compress::new(Compression::new(LEVEL), false);
    loop {
        let done = usize::try_from(state.total_in()).unwrap_or(usize::MAX);
        let written = out.len();
        let rest = piece.get(done..).sure();
        // Memory is always there: the vector grows. An error cannot come from a valid state.
        let ended = state.compress_vec(rest, &mut out, FlushCompress::Sync).is_err();
        if ended || (out.len() < out.capacity() && state.total_in() >= piece.len() as u64) {
            return out;
        }
        if out.len() == written || out.len() == out.capacity() {
            out.reserve(piece.len() / 4 + 64);
        }
    }
}

/// Bytes as text that HTML keeps as it is: seven bits a character. The three characters that a page would change stand
/// two bytes wide. 17 % longer than the bytes; base 64 is 33 %.
pub(super) fn text(bytes: &[u8]) -> String {
    let mut out = String::with_capacity(bytes.len() * 8 / 7 + bytes.len() / 32 + 16);
    let (mut held, mut bits) = (0_u32, 0);
    let put = |out: &mut String, seven: u32| match u8::try_from(seven & 127).unwrap_or_default() {
        0 => out.push('¡'),
        b'\r' => out.push('¢'),
        b'<' => out.push('£'),
        other => out.push(char::from(other)),
    };
    for byte in bytes {
        held = held << 8 | u32::from(*byte);
        bits += 8;
        while bits >= 7 {
            bits -= 7;
            put(&mut out, held >> bits);
        }
        held &= (1 << bits) - 1;
    }
    if bits > 0 {
        put(&mut out, held << (7 - bits));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;

    #[test]
    fn pieces_make_one_stream() {
        let mut container = Container::default();
        let mut column = Column::default();
        for row in 0..1_500_000_i64 {
            column.push(row * row % 100_003);
        }
        container.add_all(vec![("test".to_owned(), &column)]);
        let mut text = Long::default();
        (0..900).for_each(|_| text.push(&[b'a'; 1000]));
        container.add_text("long", text);
        let stream = container.finish(serde_json::Map::new());
        let mut inflated = Vec::new();
        flate2::read::DeflateDecoder::new(&stream[..]).read_to_end(&mut inflated).unwrap();
        let header = u32::from_le_bytes(inflated[..4].try_into().unwrap()) as usize;
        let json: serde_json::Value = serde_json::from_slice(&inflated[4..4 + header]).unwrap();
        let form = &json["columns"][0];
        assert_eq!((form[0].as_str(), form[1].as_u64()), (Some("test"), Some(1_500_000)));
        let texts = 4 + header + form[5].as_u64().unwrap() as usize;
        assert_eq!(json["texts"][0], serde_json::json!(["long", 900_000]));
        assert_eq!(inflated[texts..], [b'a'; 900_000]);
    }

    #[test]
    fn text_is_seven_bits_a_character() {
        assert_eq!(text(&[0, 0, 0, 0, 0, 0, 0]), "¡".repeat(8));
        // 0001101 0111100 1000001 0
        assert_eq!(text(&[0b0001_1010, 0b1111_0010, 0b0000_1000]), "¢£A¡");
    }
}
