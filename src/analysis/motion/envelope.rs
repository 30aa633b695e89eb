//! The envelope with constant accelerations (VEL-9): the greatest velocities at the joints of a stretch that respect
//! the caps, the accelerations and look-ahead. Exact, and in memory for look-ahead and one more part only.

/// Blocks that are planned at once beyond those that are looked ahead over.
const PART: usize = 1024;

/// One motion of a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    /// Its length.
    pub length: f64,
    /// Block cap.
    pub cap: f64,
    /// Joint cap at its start; 0 at the start of a stretch.
    pub joint: f64,
    /// Greatest acceleration.
    pub accel: f64,
}

/// A planned motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Linked {
    /// Velocity at its start.
    pub start: f64,
    /// Velocity at its end.
    pub end: f64,
    /// The velocity at its start from which it can stop within what is seen, where more follows.
    pub seen: f64,
}

/// Plans stretches.
#[derive(Clone, Debug)]
pub(super) struct Envelope {
    look_ahead: usize,
    links: Vec<Link>,
    /// Velocity at the start of the first of `links`.
    entry: f64,
    /// Squares of the velocities at the joints.
    squares: Vec<f64>,
    /// Squares of the caps by look-ahead.
    seen: Vec<f64>,
}

impl Envelope {
    /// For a control that sees so many blocks.
    pub(super) fn new(look_ahead: usize) -> Self {
        Self { look_ahead: look_ahead.max(1), links: Vec::new(), entry: 0.0, squares: Vec::new(), seen: Vec::new() }
    }

    /// Adds a motion; gives those that are settled by it to `done`.
    pub(super) fn push(&mut self, link: Link, done: impl FnMut(&Link, Linked)) {
        self.links.push(link);
        if self.links.len() > self.look_ahead + PART {
            self.plan(false, done);
        }
    }

    /// Ends the stretch: the rest is settled.
    pub(super) fn close(&mut self, done: impl FnMut(&Link, Linked)) {
        self.plan(true, done);
        self.entry = 0.0;
    }

    fn plan(&mut self, closed: bool, mut done: impl FnMut(&Link, Linked)) {
        let Self { look_ahead, links, entry, squares, seen } = self;
        let count = links.len();
        // The planner settles motions with a full look-ahead behind them.
        let settled = if closed { count } else { count - *look_ahead - 1 };
        caps_by_look_ahead(links, *look_ahead, seen);
        squares.clear();
        squares.resize(count + 1, if closed { 0.0 } else { f64::INFINITY });
        let mut next = if closed { 0.0 } else { f64::INFINITY };
        for ((square, link), seen) in squares.iter_mut().zip(links.iter()).zip(seen.iter()).rev() {
            next = (link.joint * link.joint).min(*seen).min(next + 2.0 * link.accel * link.length);
            *square = next;
        }
        let mut start = *entry;
        let ends = squares.iter().skip(1);
        for ((link, end), seen) in links.iter().zip(ends).zip(seen.iter()).take(settled) {
            let end = end.min(start * start + 2.0 * link.accel * link.length).sqrt();
            done(link, Linked { start, end, seen: seen.sqrt() });
            start = end;
        }
        *entry = start;
        links.drain(..settled);
    }
}

/// The squares of the velocities from which the machine stops within the next `look_ahead` blocks, at the start of each
/// link; without limit where these are not all here, or nothing follows them.
fn caps_by_look_ahead(links: &[Link], look_ahead: usize, seen: &mut Vec<f64>) {
    seen.clear();
    let mut way: f64 = links.iter().take(look_ahead).map(|link| link.length).sum();
    // Summed anew now and then, so that what is lost by adding and taking away stays small.
    for (place, link) in links.iter().enumerate() {
        match links.get(place + look_ahead) {
            Some(beyond) => {
                if place % 256 == 255 {
                    way = links.iter().skip(place).take(look_ahead).map(|link| link.length).sum();
                }
                seen.push(2.0 * link.accel * way.max(0.0));
                way += beyond.length - link.length;
            }
            None => seen.push(f64::INFINITY),
        }
    }
}

/// The time and the greatest velocity of a motion from `start` to `end`, both at most `cap`, with constant
/// acceleration. Without `rise`, its velocity does not go above the higher of both.
pub(super) fn trapezoid(length: f64, start: f64, end: f64, cap: f64, accel: f64, rise: bool) -> (f64, f64) {
    let peak = if rise {
        cap.min(((start * start + end * end) / 2.0 + accel * length).max(0.0).sqrt())
    } else {
        start.max(end)
    };
    let peak = peak.max(start).max(end);
    let ramps = (2.0 * peak * peak - start * start - end * end) / (2.0 * accel);
    let hold = (length - ramps).max(0.0);
    ((2.0 * peak - start - end) / accel + if hold > 0.0 { hold / peak } else { 0.0 }, peak)
}
