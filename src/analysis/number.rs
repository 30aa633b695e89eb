//! A number in JSON objects.

use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::dict::{Decimal, Micro};

/// A number with at most six decimals; whole ones without a point.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(inline)]
pub struct Number(#[schemars(with = "f64")] pub Micro);

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.millionths() % 1_000_000 == 0 {
            serializer.serialize_i64(self.0.millionths() / 1_000_000)
        } else {
            serializer.serialize_f64(self.0.to_f64())
        }
    }
}

impl From<Decimal> for Number {
    fn from(value: Decimal) -> Self {
        Self(value.into())
    }
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        Self(Micro::from_f64(value))
    }
}
