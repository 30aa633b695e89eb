//! The data that requests are answered from, and the type of an answer.

use std::sync::Arc;

use lsp_server::{ErrorCode, ResponseError};

use super::analysis::{Analysis, Found};
use super::checked::Checked;
use super::client::Client;
use super::files::EditorFiles;
use crate::query;
use crate::query::cancel::Cancel;

/// The server's state at the moment of a request. Handlers read it in other threads.
#[derive(Clone, Debug)]
pub(super) struct Snapshot {
    pub(super) client: Arc<Client>,
    pub(super) files: EditorFiles,
    /// Of the request's document; `None` when it is no program.
    pub(super) analysis: Option<Arc<Analysis>>,
    /// Of the request's document, when the request needs it.
    pub(super) found: Option<Arc<Found>>,
    /// Of all open documents.
    pub(super) analyses: Vec<Arc<Analysis>>,
    /// Programs that are not open.
    pub(super) checked: Checked,
    /// Raised when the client wants no answer any more.
    pub(super) cancel: Cancel,
}

impl Snapshot {
    /// The analyses of all open documents.
    pub(super) fn open(&self) -> impl Iterator<Item = &query::analysis::Analysis> {
        self.analyses.iter().map(|analysis| &***analysis)
    }
}

/// Why a request gets no result.
#[derive(Debug)]
pub(super) struct Refusal {
    pub(super) code: ErrorCode,
    pub(super) message: String,
}

impl Refusal {
    /// Refuses a request; the client shows `message` to the user.
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self { code: ErrorCode::RequestFailed, message: message.into() }
    }

    /// For parameters of a request that are not of their type.
    #[expect(clippy::needless_pass_by_value, reason = "what `map_err` gives")]
    pub(super) fn wrong_params(error: serde_json::Error) -> Self {
        Self { code: ErrorCode::InvalidParams, message: error.to_string() }
    }
}

impl From<Refusal> for ResponseError {
    fn from(refusal: Refusal) -> Self {
        Self { code: refusal.code as i32, message: refusal.message, data: None }
    }
}

/// What must be known before a request is answered.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub(super) enum Needs {
    /// Nothing of a document.
    Nothing,
    /// Its analysis.
    Analysis,
    /// Its findings, too.
    Findings,
    /// The analyses of all open documents: the answer also comes from programs that call this one, or that it calls.
    Everything,
    /// The same; the answer comes from the execution of some blocks.
    Blocks,
    /// The same; the answer comes from the execution of the whole program.
    Run,
}

/// A result, or why there is none.
pub(super) type Answer<T> = Result<T, Refusal>;
