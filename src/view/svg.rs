//! A still picture as SVG.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::display::{Class, DASH, DOT_SIZES, DOTS, Display, Item, LETTER, Place};
use super::page::escaped;

/// Writes the picture. `image`: the path as PNG, in place of its lines.
pub(super) fn svg(display: &Display, image: Option<&[u8]>) -> String {
    let mut out = String::with_capacity(1 << 16);
    let Display { width, height, title, under, path, over, fine, left_out: _ } = display;
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         role=\"img\">"
    );
    let _ = writeln!(out, "<title>{}</title>", escaped(title));
    styles(&mut out, *fine);
    let _ = writeln!(out, "<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>");
    items(&mut out, under, *fine);
    match image {
        Some(png) => {
            let _ = writeln!(
                out,
                "<image class=\"path\" width=\"{width}\" height=\"{height}\" href=\"data:image/png;base64,{}\"/>",
                STANDARD.encode(png)
            );
        }
        None => items(&mut out, path, *fine),
    }
    items(&mut out, over, *fine);
    out.push_str("</svg>\n");
    out
}

fn styles(out: &mut String, fine: bool) {
    let lines = [
        Class::Grid,
        Class::GridStrong,
        Class::Rapid,
        Class::Straight,
        Class::Arc,
        Class::Thread,
        Class::Equidistant,
        Class::Collision,
        Class::Axis(0),
        Class::Axis(1),
        Class::Axis(2),
        Class::Ink,
        Class::Faint,
    ];
    out.push_str("<style>path{fill:none;stroke-linejoin:round}");
    for class in lines {
        let selector = class.name().replace(' ', ".");
        let colour = hex(class.colour());
        let _ = write!(
            out,
            "path.{selector}{{stroke:{colour};stroke-width:{}}}text.{selector}{{fill:{colour}}}",
            class.width()
        );
    }
    let [red, yellow, edge] = DOTS.map(hex);
    let edgeless = if fine { ";stroke:none" } else { "" };
    let _ = writeln!(
        out,
        "path.rapid{{stroke-dasharray:{DASH}}}.dot{{stroke:{edge};stroke-width:.9}}path.dot.red{{fill:{red};stroke:{edge};stroke-width:.9}}\
         .dot.yellow{{fill:{yellow}{edgeless}}}text{{font:{}px monospace;paint-order:stroke;stroke:#fff;stroke-width:3px;\
         stroke-linejoin:round}}</style>",
        LETTER[0]
    );
}

fn items(out: &mut String, items: &[Item], fine: bool) {
    for item in items {
        match item {
            Item::Lines(class, places) => {
                let _ = write!(out, "<path class=\"{}\" d=\"", class.name());
                let mut letter = 'M';
                for place in places {
                    out.push(letter);
                    point(out, *place);
                    letter = 'L';
                }
                out.push_str("\"/>\n");
            }
            Item::Dot { at: [x, y], red: true, seq } => {
                let size = DOT_SIZES[0];
                out.push_str("<path class=\"dot red\" d=\"M");
                for (place, letter) in
                    [[*x, y - size], [x + size, *y], [*x, y + size], [x - size, *y]].into_iter().zip("LLLZ".chars())
                {
                    point(out, place);
                    out.push(letter);
                }
                let _ = writeln!(out, "\" data-seq=\"{seq}\"/>");
            }
            Item::Dot { at: [x, y], red: false, seq } => {
                out.push_str("<circle class=\"dot yellow\" cx=\"");
                number(out, *x);
                out.push_str("\" cy=\"");
                number(out, *y);
                let [_, usual, small] = DOT_SIZES;
                let _ = writeln!(out, "\" r=\"{}\" data-seq=\"{seq}\"/>", if fine { small } else { usual });
            }
            Item::Text { at: [x, y], class, text } => {
                let _ = write!(out, "<text class=\"{}\" x=\"", class.name());
                number(out, *x);
                out.push_str("\" y=\"");
                number(out, *y);
                let _ = writeln!(out, "\">{}</text>", escaped(text));
            }
        }
    }
}

fn point(out: &mut String, [x, y]: Place) {
    number(out, x);
    out.push(' ');
    number(out, y);
}

/// With two decimals at most.
fn number(out: &mut String, value: f64) {
    #[expect(clippy::cast_possible_truncation, reason = "saturating; places on a picture are small")]
    let hundredths = (value * 100.0).round() as i64;
    if hundredths < 0 {
        out.push('-');
    }
    let (whole, part) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    let _ = match part {
        0 => write!(out, "{whole}"),
        part if part % 10 == 0 => write!(out, "{whole}.{}", part / 10),
        part => write!(out, "{whole}.{part:02}"),
    };
}

fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_two_decimals_at_most() {
        let shown = |value: f64| {
            let mut out = String::new();
            number(&mut out, value);
            out
        };
        assert_eq!([1.0, 1.5, -0.004, -1.256, 0.05].map(shown), ["1", "1.5", "0", "-1.26", "0.05"]);
    }
}
