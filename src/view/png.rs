//! A still picture as PNG, drawn by tiny-skia: the same bytes on every computer.

use flate2::{Compress, Compression, Crc, FlushCompress};
use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, Transform};

use super::display::{Class, DASH, DOT_SIZES, DOTS, Display, Item, LETTER, Place};
use super::glyphs;
use super::scan::Coverage;
use crate::sure::Sure;

/// Draws the picture. `None` when it has no size, or more pixels than there is memory for.
pub(super) fn png(display: &Display) -> Option<Vec<u8>> {
    let mut pixmap = Pixmap::new(display.width, display.height)?;
    pixmap.fill(Color::WHITE);
    let mut coverage = Coverage::new(display.width, display.height);
    for items in [&display.under, &display.path, &display.over] {
        draw(&mut pixmap, &mut coverage, items, display.fine);
    }
    Some(encoded(&pixmap, false))
}

/// Draws the path alone, on nothing.
pub(super) fn path_png(display: &Display) -> Option<Vec<u8>> {
    let mut pixmap = Pixmap::new(display.width, display.height)?;
    draw(&mut pixmap, &mut Coverage::new(display.width, display.height), &display.path, display.fine);
    Some(encoded(&pixmap, true))
}

/// The pixels as a PNG file, with or without transparency.
fn encoded(pixmap: &Pixmap, transparent: bool) -> Vec<u8> {
    let (width, height) = (pixmap.width(), pixmap.height());
    let mut rows = Vec::with_capacity(pixmap.data().len() + height as usize);
    for line in pixmap.pixels().chunks(width as usize) {
        // No filter: drawings have runs, not gradients.
        rows.push(0);
        for pixel in line {
            let pixel = pixel.demultiply();
            rows.extend_from_slice(&[pixel.red(), pixel.green(), pixel.blue()]);
            if transparent {
                rows.push(pixel.alpha());
            }
        }
    }
    let mut deflated = Vec::with_capacity(rows.len() / 8 + 1024);
    let mut state = Compress::new(Compression::new(6), true);
    loop {
        let done = usize::try_from(state.total_in()).unwrap_or(usize::MAX);
        deflated.reserve(1 << 16);
        let rest = rows.get(done..).sure();
        match state.compress_vec(rest, &mut deflated, FlushCompress::Finish) {
            Ok(flate2::Status::Ok | flate2::Status::BufError) => {}
            // An error cannot come from a valid state.
            Ok(flate2::Status::StreamEnd) | Err(_) => break,
        }
    }
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut header = Vec::new();
    header.extend_from_slice(&width.to_be_bytes());
    header.extend_from_slice(&height.to_be_bytes());
    // Eight bits a colour; red, green, blue, or with transparency; as usual otherwise.
    header.extend_from_slice(&[8, if transparent { 6 } else { 2 }, 0, 0, 0]);
    chunk(&mut file, *b"IHDR", &header);
    chunk(&mut file, *b"IDAT", &deflated);
    chunk(&mut file, *b"IEND", &[]);
    file
}

fn chunk(file: &mut Vec<u8>, name: [u8; 4], bytes: &[u8]) {
    file.extend_from_slice(&u32::try_from(bytes.len()).unwrap_or(u32::MAX).to_be_bytes());
    file.extend_from_slice(&name);
    file.extend_from_slice(bytes);
    let mut sum = Crc::new();
    sum.update(&name);
    sum.update(bytes);
    file.extend_from_slice(&sum.sum().to_be_bytes());
}

fn paint([red, green, blue]: [u8; 3]) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, 255);
    paint.anti_alias = true;
    paint
}

#[expect(clippy::cast_possible_truncation, reason = "places on a picture fit")]
const fn single(value: f64) -> f32 {
    value as f32
}

/// Draws items in their order. Lines of one class that follow one another are painted together.
fn draw(pixmap: &mut Pixmap, coverage: &mut Coverage, items: &[Item], fine: bool) {
    let mut open: Option<Class> = None;
    for item in items {
        let class = if let Item::Lines(class, _) = item { Some(*class) } else { None };
        if let Some(before) = open.filter(|before| class != Some(*before)) {
            coverage.paint(pixmap.data_mut(), before.colour());
        }
        open = class;
        match item {
            Item::Lines(class, places) => {
                let dash = if *class == Class::Rapid { f64::from(DASH) } else { 0.0 };
                coverage.lines(places, f64::from(class.width()), dash);
            }
            Item::Dot { at, red, .. } => dot(pixmap, *at, *red, fine),
            Item::Text { at, class, text } => letters(pixmap, *at, *class, text),
        }
    }
    if let Some(last) = open {
        coverage.paint(pixmap.data_mut(), last.colour());
    }
}

fn chain(places: &[Place]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for (at, [x, y]) in places.iter().enumerate() {
        if at == 0 { builder.move_to(single(*x), single(*y)) } else { builder.line_to(single(*x), single(*y)) }
    }
    builder.finish()
}

/// `fine`: a yellow one is small and has no edge.
fn dot(pixmap: &mut Pixmap, [x, y]: Place, red: bool, fine: bool) {
    let [size, usual, small] = DOT_SIZES;
    let path = if red {
        let mut builder = PathBuilder::new();
        builder.move_to(single(x), single(y - size));
        builder.line_to(single(x + size), single(y));
        builder.line_to(single(x), single(y + size));
        builder.line_to(single(x - size), single(y));
        builder.close();
        builder.finish()
    } else {
        PathBuilder::from_circle(single(x), single(y), single(if fine { small } else { usual }))
    };
    let [red_fill, yellow, edge] = DOTS;
    if let Some(path) = path {
        let fill = paint(if red { red_fill } else { yellow });
        pixmap.fill_path(&path, &fill, FillRule::Winding, Transform::identity(), None);
        if fine && !red {
            return;
        }
        let stroke = Stroke { width: 0.9, ..Stroke::default() };
        pixmap.stroke_path(&path, &paint(edge), &stroke, Transform::identity(), None);
    }
}

/// Letters with a light edge, so that they can be read over lines.
fn letters(pixmap: &mut Pixmap, at: Place, class: Class, text: &str) {
    for (colour, width) in [([255; 3], 4.0), (class.colour(), 1.3)] {
        let stroke = Stroke { width, line_cap: LineCap::Round, line_join: LineJoin::Round, ..Stroke::default() };
        let paint = paint(colour);
        glyphs::lines(text, at, LETTER[0] * 0.72, LETTER[1], |places| {
            if let Some(path) = chain(places) {
                pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
            }
        });
    }
}
