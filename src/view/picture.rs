//! Lays out a still picture: path, grid with numbers, axes, scale, dots with block numbers.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use super::chains::chains;
use super::display::{Class, Display, Item, LETTER, Place, text_width};
use super::lines::{Line, Lines, Point, Stroke};
use super::png::{path_png, png};
use super::projection::{Bounds, Plane, Projection};
use super::rows::Rows;
use super::svg::svg;
use crate::parallel;

/// With more points than these the path of an SVG is an image.
const MOST_POINTS: usize = 50_000;
/// With more yellow dots than these none is drawn, and the picture says so.
pub(super) const MOST_YELLOW: usize = 20_000;
/// With more red dots than these those near others are not drawn, and the picture says so.
const MOST_RED: usize = 20_000;
/// The side of the squares of which each then has one, in pixels.
const RED_SQUARE: f64 = 8.0;
/// With more than these they are small.
const MANY_YELLOW: usize = 1_000;
/// Free at the left, top, right and bottom of the path, in pixels.
const MARGINS: [f64; 4] = [64.0, 36.0, 64.0, 64.0];

/// The request for a still picture.
#[derive(Clone, Copy, Debug)]
pub struct Still {
    /// The plane of projection; `None`: the plane that shows most of the working motions.
    pub plane: Option<Plane>,
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
}

impl Default for Still {
    fn default() -> Self {
        Self { plane: None, width: 1600, height: 1000 }
    }
}

/// A dot at a joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct JointDot {
    pub seq: u64,
    pub n: u32,
    pub row: usize,
    pub red: bool,
}

/// A piece of the equidistant path.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub seq: u64,
    pub points: Vec<Point>,
    pub collides: bool,
}

/// The parts of a picture besides the rows.
#[derive(Debug, Default)]
pub(super) struct Besides {
    pub title: String,
    /// The program ended, and all of its blocks are in the picture.
    pub whole: bool,
    /// The dots are those of an assumed machine.
    pub assumed: bool,
    /// Yellow ones no more than [`MOST_YELLOW`], ascending by colour.
    pub dots: Vec<JointDot>,
    /// How many yellow ones there are.
    pub yellow: usize,
    pub equidistant: Vec<Chain>,
}

/// A still picture.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The file.
    pub bytes: Vec<u8>,
    /// The omitted parts.
    pub left_out: LeftOut,
}

/// The parts that a still picture omits, and names in its caption.
#[derive(Clone, Copy, Debug, Default)]
pub struct LeftOut {
    /// Red dots, because others stand at the same places.
    pub red: usize,
    /// Yellow dots, because there are too many.
    pub yellow: usize,
    /// Motions whose start or end is not known, and those that move none of X, Y, Z.
    pub motions: usize,
    /// Motions that are drawn from a position of another origin.
    pub stale: usize,
}

/// The picture as SVG.
pub(super) fn as_svg(rows: &Rows, still: Still, besides: &Besides) -> Picture {
    let display = lay_out(rows, still, besides);
    let points: usize =
        display.path.iter().map(|item| if let Item::Lines(_, places) = item { places.len() } else { 0 }).sum();
    let image = if points > MOST_POINTS { path_png(&display) } else { None };
    let bytes = svg(&display, image.as_deref()).into_bytes();
    Picture { bytes, left_out: display.left_out }
}

/// The picture as PNG.
pub(super) fn as_png(rows: &Rows, still: Still, besides: &Besides) -> Option<Picture> {
    let display = lay_out(rows, still, besides);
    Some(Picture { bytes: png(&display)?, left_out: display.left_out })
}

fn lay_out(rows: &Rows, still: Still, besides: &Besides) -> Display {
    let lines = Lines::new(rows);
    let mut strokes: Vec<(usize, Stroke)> = Vec::new();
    let mut bounds = Bounds::EMPTY;
    let mut seen = Seen::default();
    // Ascending.
    let mut left_out: Vec<usize> = Vec::new();
    let wants_seen = still.plane.is_none();
    for part in parallel::map(parts(rows.block.len()), |part| Drawn::of(&lines, part, wants_seen)) {
        strokes.extend(part.strokes);
        left_out.extend(part.left_out);
        bounds.join(&part.bounds);
        seen.add(part.seen);
    }
    let lathe = rows.turning.is_lathe();
    let plane = still.plane.unwrap_or_else(|| if lathe { Plane::Zx } else { seen.main_plane() });
    for point in besides.equidistant.iter().flat_map(|chain| &chain.points) {
        bounds.include(*point);
    }
    if bounds.is_empty() {
        bounds.include(lines.point(rows.block.len().saturating_sub(1)));
    }
    let (width, height) = (f64::from(still.width), f64::from(still.height));
    let [left, top, right, bottom] = MARGINS;
    let projection =
        Projection::fit(plane, &bounds, [left, top, (width - right).max(left + 1.0), (height - bottom).max(top + 1.0)]);
    let mut display = Display {
        width: still.width,
        height: still.height,
        title: besides.title.clone(),
        under: Vec::new(),
        path: chains(&lines, &strokes, &projection, [still.width, still.height]),
        over: Vec::new(),
        fine: false,
        left_out: LeftOut::default(),
    };
    // Passes of a loop may share a row.
    let is_left_out = |index: &usize| rows.row(*index).is_some_and(|row| left_out.binary_search(&row).is_ok());
    if !left_out.is_empty() {
        display.left_out.motions = (0..rows.count()).filter(is_left_out).count();
    }
    if rows.shape_keys.iter().any(|shape| shape.stale) {
        let is_stale =
            |index: &usize| rows.row(*index).and_then(|row| rows.shape_of(row)).is_some_and(|shape| shape.stale);
        display.left_out.stale = (0..rows.count()).filter(|index| is_stale(index) && !is_left_out(index)).count();
    }
    let mut labels = Labels::default();
    let diameter = rows.turning.diameter;
    let grid_labels = if strokes.is_empty() { Vec::new() } else { grid(&mut display, &bounds, &projection, diameter) };
    for chain in &besides.equidistant {
        let class = if chain.collides { Class::Collision } else { Class::Equidistant };
        let places = chain.points.iter().map(|point| projection.at(*point)).collect();
        display.over.push(Item::Lines(class, places));
    }
    if besides.assumed {
        assumption(&mut display, &mut labels);
    }
    axes(&mut display, &projection, &mut labels, diameter);
    scale(&mut display, &projection, &mut labels);
    dots(&mut display, besides, &lines, &projection, &mut labels);
    left_out_notes(&mut display, besides);
    for (at, text) in grid_labels {
        if labels.take(at, &text, [width, height]) {
            display.under.push(Item::Text { at, class: Class::Faint, text });
        }
    }
    display
}

/// Rows that are looked at side by side with others: always as many, so that sums do not depend on threads.
const PART: usize = 1 << 15;

/// All rows but the first, in parts.
fn parts(count: usize) -> Vec<Range<usize>> {
    (1..count).step_by(PART).map(|from| from..(from + PART).min(count)).collect()
}

/// The lines of some rows.
struct Drawn {
    strokes: Vec<(usize, Stroke)>,
    /// Rows that move, and have no line.
    left_out: Vec<usize>,
    bounds: Bounds,
    seen: Seen,
}

impl Drawn {
    /// How long they look only where `wants_seen`.
    fn of(lines: &Lines<'_>, rows: Range<usize>, wants_seen: bool) -> Self {
        let (mut strokes, mut left_out) = (Vec::new(), Vec::new());
        for row in rows {
            match lines.line(row) {
                Line::Nothing => {}
                Line::LeftOut => left_out.push(row),
                Line::Drawn(stroke) => strokes.push((row, stroke)),
            }
        }
        let mut bounds = Bounds::EMPTY;
        let mut seen = Seen::default();
        for (row, stroke) in &strokes {
            lines.points(*row, 0.05, |point| bounds.include(point));
            if !wants_seen {
                continue;
            }
            let sums = if *stroke == Stroke::Rapid { &mut seen.rapid } else { &mut seen.working };
            for (sum, length) in sums.get_or_insert_default().iter_mut().zip(lines.seen(*row)) {
                *sum += length;
            }
        }
        Self { strokes, left_out, bounds, seen }
    }
}

/// How long motions look in each plane: XY, XZ, YZ. `None` where there are none.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    rapid: Option<[f64; 3]>,
    working: Option<[f64; 3]>,
}

impl Seen {
    fn add(&mut self, other: Self) {
        for (sums, other) in [(&mut self.rapid, other.rapid), (&mut self.working, other.working)] {
            if let Some(other) = other {
                sums.get_or_insert_default().iter_mut().zip(other).for_each(|(sum, length)| *sum += length);
            }
        }
    }

    /// The plane in which the working motions look longest; of nearly equal ones the first: a surface that is milled
    /// line by line looks a little longer from the side, and shows nothing there.
    fn main_plane(self) -> Plane {
        const NEARLY: f64 = 1.1;
        let [xy, xz, yz] = self.working.or(self.rapid).unwrap_or_default();
        if xy * NEARLY >= xz && xy * NEARLY >= yz {
            Plane::Xy
        } else if xz * NEARLY >= yz {
            Plane::Xz
        } else {
            Plane::Yz
        }
    }
}

/// 1, 2 or 5 times a power of ten, at least so much.
fn round_step(least: f64) -> f64 {
    let mut power = 1e-6;
    while power * 10.0 <= least {
        power *= 10.0;
    }
    let lead = least / power;
    power
        * if lead <= 1.0 {
            1.0
        } else if lead <= 2.0 {
            2.0
        } else if lead <= 5.0 {
            5.0
        } else {
            10.0
        }
}

/// A number without trailing zeros.
fn shown(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Draws the grid in the plane that is seen most from above, on the far side; gives the numbers along its edges.
fn grid(display: &mut Display, bounds: &Bounds, projection: &Projection, diameter: bool) -> Vec<(Place, String)> {
    let [tx, ty, tz] = projection.towards.map(f64::abs);
    let normal = if tz + 1e-9 >= tx && tz + 1e-9 >= ty {
        2
    } else if ty >= tx {
        1
    } else {
        0
    };
    let [a, b] = match normal {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    };
    let of = |point: Point, axis: usize| point.get(axis).copied().unwrap_or_default();
    let level = if of(projection.towards, normal) >= 0.0 { of(bounds.min, normal) } else { of(bounds.max, normal) };
    let step = round_step(70.0 / projection.scale);
    let range = |axis: usize| {
        let (low, high) = ((of(bounds.min, axis) / step - 1e-9).floor(), (of(bounds.max, axis) / step + 1e-9).ceil());
        if low >= high { (low - 1.0, high + 1.0) } else { (low, high) }
    };
    let ((low_a, high_a), (low_b, high_b)) = (range(a), range(b));
    let point = |u: f64, v: f64| {
        let mut point = [0.0; 3];
        for (axis, slot) in point.iter_mut().enumerate() {
            *slot = if axis == normal {
                level
            } else if axis == a {
                u * step
            } else {
                v * step
            };
        }
        point
    };
    let (right, up) = (projection.right, projection.up);
    let lowest = |axis: usize| of(up, axis) + of(right, axis) * 1e-3 >= 0.0;
    let leftmost = |axis: usize| of(right, axis) + of(up, axis) * 1e-3 >= 0.0;
    let is_steep = |axis: usize| of(up, axis).abs() >= of(right, axis).abs();
    let edge_b = if if is_steep(b) { lowest(b) } else { leftmost(b) } { low_b } else { high_b };
    let edge_a = if if is_steep(a) { lowest(a) } else { leftmost(a) } { low_a } else { high_a };
    let mut labels = Vec::new();
    let sides = [f64::from(display.width), f64::from(display.height)];
    let mut line = |from: Point, to: Point, is_zero: bool| {
        let class = if is_zero { Class::GridStrong } else { Class::Grid };
        display.under.push(Item::Lines(class, vec![projection.at(from), projection.at(to)]));
    };
    // Positions along X are radii.
    let scale = |axis: usize| if diameter && axis == 0 { 2.0 } else { 1.0 };
    let mut label = |at: Point, inward: Point, value: f64| {
        let ([x, y], [ix, iy]) = (projection.at(at), projection.at(inward));
        let length = ((x - ix) * (x - ix) + (y - iy) * (y - iy)).sqrt().max(1e-9);
        let text = shown(value * step);
        let width = text_width(&text);
        let far = 8.0 + width / 2.0 * ((x - ix) / length).abs() + 8.0 * ((y - iy) / length).abs();
        let [to_x, to_y] = [(ix - x) / length, (iy - y) / length];
        let outside = [x - to_x * far - width / 2.0, y - to_y * far + LETTER[0] * 0.36];
        let back = back_inside(outside, width, [to_x, to_y], sides);
        labels.push(([outside[0] + to_x * back, outside[1] + to_y * back], text));
    };
    let mut u = low_a;
    while u <= high_a {
        line(point(u, low_b), point(u, high_b), u == 0.0);
        let inward = if edge_b == low_b { edge_b + 1.0 } else { edge_b - 1.0 };
        label(point(u, edge_b), point(u, inward), u * scale(a));
        u += 1.0;
    }
    let mut v = low_b;
    while v <= high_b {
        line(point(low_a, v), point(high_a, v), v == 0.0);
        let inward = if edge_a == low_a { edge_a + 1.0 } else { edge_a - 1.0 };
        label(point(edge_a, v), point(inward, v), v * scale(b));
        v += 1.0;
    }
    labels
}

/// How far a number goes back along its line, so that the picture has it where the grid reaches beyond its edge.
fn back_inside([x, y]: Place, wide: f64, [to_x, to_y]: Place, [width, height]: [f64; 2]) -> f64 {
    let needs = |over: f64, towards: f64| if over > 0.0 && towards > 0.1 { over / towards } else { 0.0 };
    needs(4.0 - x, to_x)
        .max(needs(x + wide + 4.0 - width, -to_x))
        .max(needs(LETTER[0] + 4.0 - y, to_y))
        .max(needs(y + 6.0 - height, -to_y))
}

/// Says in the upper right corner, above all dots, what they rest on. The same bytes in every language.
fn assumption(display: &mut Display, labels: &mut Labels) {
    let text = "assumed machine".to_owned();
    let [left, y] = [f64::from(display.width) - 20.0 - text_width(&text), 14.0];
    labels.block([left - 4.0, 0.0, f64::from(display.width), y + 4.0]);
    display.over.push(Item::Text { at: [left, y], class: Class::Faint, text });
}

fn axes(display: &mut Display, projection: &Projection, labels: &mut Labels, diameter: bool) {
    let [cx, cy] = [42.0, f64::from(display.height) - 30.0];
    labels.block([0.0, cy - 40.0, cx + 40.0, cy + 26.0]);
    let directions = [0_u8, 1, 2].map(|axis| {
        let of = |point: Point| point.get(usize::from(axis)).copied().unwrap_or_default();
        (axis, of(projection.right) * 26.0, -of(projection.up) * 26.0, of(projection.towards))
    });
    let mut sorted = directions;
    sorted.sort_by(|a, b| a.3.total_cmp(&b.3));
    for (axis, x, y, _) in sorted {
        let length = (x * x + y * y).sqrt();
        if length < 2.0 {
            continue;
        }
        let letter = match axis {
            0 if diameter => "ØX",
            0 => "X",
            1 => "Y",
            _ => "Z",
        };
        display.over.push(Item::Lines(Class::Axis(axis), vec![[cx, cy], [cx + x, cy + y]]));
        let far = (length + 9.0) / length;
        let at = [cx + x * far - LETTER[1] / 2.0, cy + y * far + LETTER[0] * 0.36];
        display.over.push(Item::Text { at, class: Class::Axis(axis), text: letter.to_owned() });
    }
}

fn scale(display: &mut Display, projection: &Projection, labels: &mut Labels) {
    let step = round_step(80.0 / projection.scale);
    let length = step * projection.scale;
    let [right, y] = [f64::from(display.width) - 20.0, f64::from(display.height) - 16.0];
    let text = format!("{} mm", shown(step));
    let width = text_width(&text);
    labels.block([right - length.max(width) - 8.0, y - 26.0, right + 8.0, y + 8.0]);
    let bar = vec![[right - length, y - 5.0], [right - length, y], [right, y], [right, y - 5.0]];
    display.over.push(Item::Lines(Class::Ink, bar));
    let at = [right - length / 2.0 - width / 2.0, y - 8.0];
    display.over.push(Item::Text { at, class: Class::Ink, text });
}

/// A number, or the numbers of several dots that stand so near that their texts would cover each other.
#[derive(Clone, Copy, Debug)]
struct Numbers {
    at: Place,
    least: u32,
    greatest: u32,
}

impl Numbers {
    fn text(&self) -> String {
        let Self { least, greatest, .. } = self;
        if least == greatest { format!("N{least}") } else { format!("N{least}…N{greatest}") }
    }

    fn area(&self) -> [f64; 4] {
        let [x, y] = self.at;
        [x, y - LETTER[0], x + text_width(&self.text()) + 4.0, y + 3.0]
    }
}

fn dots(display: &mut Display, besides: &Besides, lines: &Lines<'_>, projection: &Projection, labels: &mut Labels) {
    let place = |dot: &JointDot| projection.at(lines.start(dot.row));
    display.fine = besides.yellow > MANY_YELLOW;
    if besides.yellow <= MOST_YELLOW {
        for dot in besides.dots.iter().filter(|dot| !dot.red) {
            display.over.push(Item::Dot { at: place(dot), red: false, seq: dot.seq });
        }
    } else {
        display.left_out.yellow = besides.yellow;
    }
    let mut numbers: Vec<Numbers> = Vec::new();
    let red = besides.dots.iter().filter(|dot| dot.red);
    let thin = red.clone().count() > MOST_RED;
    let mut taken: HashMap<(i64, i64), usize> = HashMap::new();
    for dot in red {
        let at = place(dot);
        if thin {
            let known = *taken.entry(square(at, RED_SQUARE)).or_insert(numbers.len());
            if let Some(number) = numbers.get_mut(known) {
                (number.least, number.greatest) = (number.least.min(dot.n), number.greatest.max(dot.n));
                display.left_out.red += 1;
                continue;
            }
        }
        display.over.push(Item::Dot { at, red: true, seq: dot.seq });
        let [x, y] = at;
        numbers.push(Numbers { at: [x + 8.0, y - 5.0], least: dot.n, greatest: dot.n });
    }
    let width = f64::from(display.width);
    for mut number in joined(numbers) {
        let [.., right, _] = number.area();
        number.at[0] -= (right - width).max(0.0);
        labels.block(number.area());
        display.over.push(Item::Text { at: number.at, class: Class::Ink, text: number.text() });
    }
}

/// Says in the upper left corner what is not drawn. The same bytes in every language.
fn left_out_notes(display: &mut Display, besides: &Besides) {
    let LeftOut { red, yellow, motions, stale } = display.left_out;
    let mut notes = Vec::new();
    if !besides.whole {
        notes.push("not the whole program".to_owned());
    }
    for (count, what) in [(motions, "not drawn"), (stale, "from another origin")] {
        match count {
            0 => {}
            1 => notes.push(format!("1 motion {what}")),
            count => notes.push(format!("{count} motions {what}")),
        }
    }
    if red > 0 {
        notes.push(format!("{red} red dots not drawn"));
    }
    if yellow > 0 {
        notes.push(format!("{yellow} yellow dots not drawn"));
    }
    let mut y = 22.0;
    for text in notes {
        display.over.push(Item::Text { at: [20.0, y], class: Class::Faint, text });
        y += LETTER[0] + 4.0;
    }
}

/// The square of a place.
#[expect(clippy::cast_possible_truncation, reason = "saturating; places on a picture are small")]
fn square([x, y]: Place, side: f64) -> (i64, i64) {
    ((x / side).floor() as i64, (y / side).floor() as i64)
}

/// Joins numbers whose texts cover each other until none does.
fn joined(mut numbers: Vec<Numbers>) -> Vec<Numbers> {
    loop {
        let before = numbers.len();
        let mut kept: Vec<Numbers> = Vec::new();
        // By squares of the picture: which of the kept ones reach into it.
        let mut squares: BTreeMap<(i64, i64), Vec<usize>> = BTreeMap::new();
        for number in numbers {
            let area = number.area();
            let covered = squares_of(area).flat_map(|square| squares.get(&square).into_iter().flatten());
            let other = covered.copied().find(|other| kept.get(*other).is_some_and(|kept| cover(kept.area(), area)));
            let place = match other {
                Some(place) => {
                    if let Some(kept) = kept.get_mut(place) {
                        kept.least = kept.least.min(number.least);
                        kept.greatest = kept.greatest.max(number.greatest);
                    }
                    place
                }
                None => {
                    kept.push(number);
                    kept.len() - 1
                }
            };
            if let Some(kept) = kept.get(place) {
                for square in squares_of(kept.area()) {
                    let reaching = squares.entry(square).or_default();
                    if !reaching.contains(&place) {
                        reaching.push(place);
                    }
                }
            }
        }
        numbers = kept;
        if numbers.len() == before {
            return numbers;
        }
    }
}

fn squares_of([left, top, right, bottom]: [f64; 4]) -> impl Iterator<Item = (i64, i64)> {
    #[expect(clippy::cast_possible_truncation, reason = "saturating; places on a picture are small")]
    let square = |value: f64| (value / 40.0).floor() as i64;
    let (top, bottom) = (square(top), square(bottom));
    (square(left)..=square(right)).flat_map(move |column| (top..=bottom).map(move |row| (column, row)))
}

fn cover([al, at, ar, ab]: [f64; 4], [bl, bt, br, bb]: [f64; 4]) -> bool {
    al < br && bl < ar && at < bb && bt < ab
}

/// Areas that have a text.
#[derive(Debug, Default)]
struct Labels {
    taken: Vec<[f64; 4]>,
}

impl Labels {
    fn block(&mut self, area: [f64; 4]) {
        self.taken.push(area);
    }

    /// Whether a text finds room; it has it then.
    fn take(&mut self, [x, y]: Place, text: &str, [width, height]: [f64; 2]) -> bool {
        let area = [x - 2.0, y - LETTER[0], x + text_width(text) + 2.0, y + 3.0];
        let [left, top, right, bottom] = area;
        let inside = left >= 0.0 && top >= 0.0 && right <= width && bottom <= height;
        let free = inside && !self.taken.iter().any(|taken| cover(*taken, area));
        if free {
            self.taken.push(area);
        }
        free
    }
}
