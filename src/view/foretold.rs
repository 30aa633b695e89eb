//! How velocities and caps are foretold, in whole parts: `web/src/data/times.ts` foretells the same way.

/// Feeds are whole parts of a mm/min.
pub(super) const PER_FEED: f64 = 10_000.0;

/// A velocity in mm/s as a feed in parts of a mm/min.
pub(super) fn feed(velocity: f64) -> i64 {
    whole(velocity * 60.0 * PER_FEED)
}

#[expect(clippy::cast_possible_truncation, reason = "saturating; feeds and times are far smaller")]
pub(super) fn whole(value: f64) -> i64 {
    value.round() as i64
}

#[expect(clippy::cast_precision_loss, reason = "feeds and times have far fewer than 53 bits")]
pub(super) fn float(value: i64) -> f64 {
    value as f64
}

/// Whether a feed may replace another: within 0.0004 mm/min, or 4e-7 of it.
pub(super) fn is_near(feed: i64, other: i64) -> bool {
    feed.abs_diff(other) <= 4 + feed.unsigned_abs() / 2_500_000
}

/// The correction of a foretold feed.
pub(super) fn correction(feed: i64, foretold: i64) -> i64 {
    if is_near(feed, foretold) { 0 } else { feed - foretold }
}

/// In parts of a mm/min, from mm/s² and mm: the square of velocity gained over a length.
pub(super) fn gained(accel: f64, length: f64) -> f64 {
    2.0 * accel * length * 3600.0 * PER_FEED * PER_FEED
}

/// The programmed velocity: that of the block's F, else that of the last motion of its kind.
#[derive(Debug, Default)]
pub(super) struct Programmed {
    rapid: i64,
    other: i64,
}

impl Programmed {
    pub(super) fn correction(&mut self, rapid: bool, fed: Option<i64>, value: i64) -> i64 {
        let slot = if rapid { &mut self.rapid } else { &mut self.other };
        let foretold = fed.unwrap_or(*slot);
        let by = correction(value, foretold);
        *slot = foretold + by;
        by
    }
}

/// Caps that follow from what limits them: of the shortest block in proportion to the length, of others as the last.
#[derive(Debug, Default)]
pub(super) struct Limits {
    /// Cap by length, of the shortest block.
    shortest: f64,
    other: i64,
}

impl Limits {
    pub(super) fn foretell(&self, by: &str, length: f64) -> i64 {
        if by == "shortest_block" { whole(self.shortest * length) } else { self.other }
    }

    pub(super) fn learn(&mut self, by: &str, length: f64, cap: i64) {
        match by {
            "shortest_block" => {
                // Learned once: what is foretold later does not drift.
                if self.shortest == 0.0 && length > 0.0 {
                    self.shortest = float(cap) / length;
                }
            }
            "feed" | "rapid" => {}
            _ => self.other = cap,
        }
    }
}
