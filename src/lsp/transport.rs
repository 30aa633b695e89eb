//! Messages over standard input and output, framed as the base protocol says. A frame that cannot be understood is
//! handed on as such, to be answered; it never ends the server.

use std::io::{self, BufRead, Read, Write};

use lsp_server::{ErrorCode, Message, RequestId};
use serde_json::{Value, json};

/// Longest content of one message, in bytes: a program of 4 GiB is refused as too large anyway.
const LONGEST: usize = 1 << 31;

/// What stands before the length of the content.
const LENGTH: &str = "content-length:";

/// What comes in.
#[derive(Debug)]
pub(super) enum Incoming {
    /// A message.
    Message(Message),
    /// Something else, with the answer that it gets.
    Malformed {
        /// Its `id`, when that can be told; null otherwise.
        id: Value,
        /// The code of the error.
        code: ErrorCode,
        /// In words, for the client's log.
        message: String,
    },
}

/// Reads one frame. `None` at the end of the input.
///
/// # Errors
/// What reading gives; the input is of no use then.
pub(super) fn read(input: &mut impl BufRead) -> io::Result<Option<Incoming>> {
    let mut length = None;
    let mut begun = false;
    loop {
        let mut line = Vec::new();
        if read_line(input, &mut line)? == 0 {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        if line.is_empty() {
            match (length, begun) {
                (Some(length), _) => return read_content(input, length).map(Some),
                (None, true) => return Ok(Some(malformed(ErrorCode::ParseError, "a header without Content-Length"))),
                (None, false) => continue,
            }
        }
        begun = true;
        // Of a frame without a length the content has no line end, and stands before the next header.
        if let Some(at) = line.to_ascii_lowercase().rfind(LENGTH) {
            length = line.get(at + LENGTH.len()..).and_then(|value| value.trim().parse::<usize>().ok());
        }
    }
}

/// Reads a line of a header; of a longer one than any header has, a piece.
fn read_line(input: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<usize> {
    input.take(1 << 12).read_until(b'\n', line)
}

fn read_content(input: &mut impl BufRead, length: usize) -> io::Result<Incoming> {
    if length > LONGEST {
        let skipped = io::copy(&mut input.take(length as u64), &mut io::sink())?;
        return Ok(malformed(ErrorCode::InvalidRequest, &format!("a message of {skipped} bytes is too long")));
    }
    // Grows as bytes arrive: a length alone takes no memory.
    let mut content = Vec::new();
    input.take(length as u64).read_to_end(&mut content)?;
    if content.len() < length {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    Ok(match understand(&content) {
        Incoming::Malformed { code: ErrorCode::ParseError, .. } => understand(&without_half_characters(&content)),
        understood @ (Incoming::Message(_) | Incoming::Malformed { .. }) => understood,
    })
}

/// JSON in which half a character, as an editor may cut one in two, is U+FFFD: that is as long in UTF-16, so that all
/// later places stay right.
fn without_half_characters(json: &[u8]) -> Vec<u8> {
    let code = |at: usize| {
        let digits = json.get(at..at + 6)?.strip_prefix(br"\u")?;
        u16::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()
    };
    let mut whole = Vec::with_capacity(json.len());
    let mut at = 0;
    while let Some(&byte) = json.get(at) {
        let length = match (byte, code(at)) {
            (b'\\', Some(0xD800..=0xDBFF)) if matches!(code(at + 6), Some(0xDC00..=0xDFFF)) => 12,
            (b'\\', Some(0xD800..=0xDFFF)) => {
                whole.extend(br"\ufffd");
                at += 6;
                continue;
            }
            (b'\\', _) => 2,
            _ => 1,
        };
        whole.extend(json.get(at..at + length).unwrap_or_default());
        at += length;
    }
    whole
}

fn understand(content: &[u8]) -> Incoming {
    match serde_json::from_slice::<Message>(content) {
        // A request whose id is none of a request looks like a notification.
        Ok(message) if !matches!(message, Message::Notification(_)) || !has_id(content) => Incoming::Message(message),
        Ok(_) | Err(_) => match serde_json::from_slice::<Value>(content) {
            Ok(value) => Incoming::Malformed {
                id: value.get("id").cloned().unwrap_or(Value::Null),
                code: ErrorCode::InvalidRequest,
                message: "this is no request, notification or response".to_owned(),
            },
            Err(error) => malformed(ErrorCode::ParseError, &error.to_string()),
        },
    }
}

/// Whether a message has an `id`; told of short ones only, because the long ones are texts of documents.
fn has_id(content: &[u8]) -> bool {
    #[derive(serde::Deserialize)]
    struct Identified {
        id: Option<serde::de::IgnoredAny>,
    }
    content.len() < 1 << 16 && serde_json::from_slice::<Identified>(content).is_ok_and(|message| message.id.is_some())
}

fn malformed(code: ErrorCode, message: &str) -> Incoming {
    Incoming::Malformed { id: Value::Null, code, message: message.to_owned() }
}

/// What goes out.
#[derive(Debug)]
pub(super) enum Outgoing {
    /// A message.
    Message(Message),
    /// The result of a request, as JSON.
    Result {
        /// Of which request.
        id: RequestId,
        /// The result.
        result: String,
    },
    /// An answer to something malformed, whose `id` may be anything.
    Refusal(Value),
}

impl Outgoing {
    /// The answer to something malformed.
    pub(super) fn refusal(id: &Value, code: ErrorCode, message: &str) -> Self {
        Self::Refusal(json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code as i32, "message": message } }))
    }
}

/// Writes one frame.
///
/// # Errors
/// What writing gives.
pub(super) fn write(output: &mut impl Write, outgoing: Outgoing) -> io::Result<()> {
    match outgoing {
        Outgoing::Message(message) => message.write(output),
        Outgoing::Result { id, result } => {
            let head = format!(r#"{{"jsonrpc":"2.0","id":{},"result":"#, json!(id));
            write_frame(output, &[&head, &result, "}"])
        }
        Outgoing::Refusal(value) => write_frame(output, &[&value.to_string()]),
    }
}

fn write_frame(output: &mut impl Write, content: &[&str]) -> io::Result<()> {
    let length: usize = content.iter().map(|part| part.len()).sum();
    write!(output, "Content-Length: {length}\r\n\r\n")?;
    content.iter().try_for_each(|part| output.write_all(part.as_bytes()))?;
    output.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(mut text: &[u8]) -> Vec<String> {
        let mut found = Vec::new();
        while let Ok(Some(incoming)) = read(&mut text) {
            found.push(match incoming {
                Incoming::Message(Message::Request(request)) => format!("request {} {}", request.id, request.method),
                Incoming::Message(Message::Notification(note)) => format!("note {}", note.method),
                Incoming::Message(Message::Response(response)) => format!("response {}", response.id),
                Incoming::Malformed { id, code, .. } => format!("{code:?} {id}"),
            });
        }
        found
    }

    fn frame(content: &str) -> String {
        format!("Content-Length: {}\r\n\r\n{content}", content.len())
    }

    /// Half a character keeps its length; what stands around it stays as it is.
    #[test]
    fn half_characters_do_not_lose_a_message() {
        let text = r#"{"method":"x","params":["\ud83d","a\ude00b","\ud83d\ude00","\\ud83d","\ud83d\ud83d\ude00"]}"#;
        let Incoming::Message(Message::Notification(read)) = read(&mut frame(text).as_bytes()).unwrap().unwrap() else {
            panic!("not read");
        };
        assert_eq!(read.params, json!(["\u{fffd}", "a\u{fffd}b", "😀", "\\ud83d", "\u{fffd}😀"]));
    }

    #[test]
    fn what_is_malformed_is_answered_and_the_next_message_read() {
        let good = frame(r#"{"jsonrpc":"2.0","method":"initialized","params":{}}"#);
        for (bad, expected) in [
            (frame("{"), "ParseError null"),
            (frame("[1,2]"), "InvalidRequest null"),
            (frame(r#"{"id":3000000000,"method":"x"}"#), "InvalidRequest 3000000000"),
            (frame(r#"{"id":7}"#), "InvalidRequest 7"),
            (frame(r#"{"id":[7],"method":"x"}"#), "InvalidRequest [7]"),
            (frame("\u{fffd}"), "ParseError null"),
            ("Nonsense: 1\r\n\r\n".to_owned(), "ParseError null"),
            ("Content-Length: -4\r\n\r\n".to_owned(), "ParseError null"),
            ("Content-Length: x\r\n\r\n{\"id\":1,\"method\":\"a\"}".to_owned(), "ParseError null"),
        ] {
            assert_eq!(all(format!("{bad}{good}").as_bytes()), [expected, "note initialized"], "{bad}");
        }
        let two =
            format!("content-length: 33\r\nContent-Type: x\r\n\r\n{}{good}", r#"{"id":1,"method":"a","params":{}}"#);
        assert_eq!(all(two.as_bytes()), ["request 1 a", "note initialized"]);
    }

    #[test]
    fn a_message_cut_short_ends_the_input() {
        assert!(
            read(&mut "Content-Length: 4000000000000\r\n\r\n{}".as_bytes()).is_err()
                || cfg!(target_pointer_width = "64")
        );
        assert!(read(&mut "Content-Length: 40\r\n\r\n{}".as_bytes()).is_err());
        assert!(matches!(read(&mut "".as_bytes()), Ok(None)));
    }
}
