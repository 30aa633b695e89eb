//! The calls that lead to executed blocks: each chain is kept once, as its last call and the chain before it.

use std::collections::HashMap;

use serde_json::{Value, json};

use super::column::Column;
use super::files::Files;
use super::parts::Interned;
use crate::run::{Call, Executed};
use crate::text::FileId;

/// A chain of calls: its index in the columns and one more, 0 for none.
type Context = u32;

/// All chains.
#[derive(Debug, Default)]
pub(super) struct Contexts {
    /// The calls in progress, with the chains that end in them.
    open: Vec<(Key, Context)>,
    known: HashMap<(Context, Key), Context>,
    called: Interned<(&'static str, u32)>,
    pub parent: Column,
    pub block: Column,
    pub call: Column,
    pub pass: Column,
    pub of: Column,
}

#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
struct Key {
    by: &'static str,
    l: u32,
    /// Where the calling block stands.
    file: FileId,
    start: u32,
    pass: u32,
    of: u32,
}

impl Contexts {
    /// The chain of calls that led to a block.
    pub fn find(&mut self, block: &Executed<'_>, files: &Files) -> Context {
        let mut depth = 0;
        let mut context = 0;
        for call in block.calls() {
            let Call { by, l, file, at, pass, of, .. } = call;
            let key = Key { by: by.name(), l, file, start: at.span.start, pass, of };
            context = match self.open.get(depth) {
                Some((known, context)) if *known == key => *context,
                _ => {
                    self.open.truncate(depth);
                    let next = self.enter(context, key, files);
                    self.open.push((key, next));
                    next
                }
            };
            depth += 1;
        }
        self.open.truncate(depth);
        context
    }

    /// The bytes that they take, roughly.
    pub fn memory(&self) -> usize {
        self.known.capacity() * 64 + 20 * self.parent.len()
    }

    fn enter(&mut self, parent: Context, key: Key, files: &Files) -> Context {
        if let Some(known) = self.known.get(&(parent, key)) {
            return *known;
        }
        self.parent.push(i64::from(parent));
        self.block.push(i64::from(files.block_at(key.file, key.start)));
        let called = self.called.get((key.by, key.l), || json!({ "by": key.by, "l": key.l }));
        self.call.push(i64::from(called));
        self.pass.push(i64::from(key.pass));
        self.of.push(i64::from(key.of));
        let next = Context::try_from(self.parent.len()).unwrap_or(Context::MAX);
        self.known.insert((parent, key), next);
        next
    }

    /// The called units, with their callers.
    pub fn called(&self) -> &[Value] {
        self.called.values()
    }
}
