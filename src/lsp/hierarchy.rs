//! Who calls whom: main programs, subprograms, macrocycles.

use std::collections::BTreeMap;
use std::path::PathBuf;

use gen_lsp_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem, CallHierarchyOutgoingCall,
    CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams, Range, SymbolKind,
};
use serde_json::{Value, json};

use super::analysis::Analysis;
use super::places::{Places, offset};
use super::snapshot::{Answer, Snapshot};
use crate::query::cursor::{DOCUMENT, block_at, unit_of};
use crate::query::names::{Name, Usage};
use crate::query::navigation_texts::NavigationText;
use crate::query::reach::Reach;
use crate::resolve::{Unit, UnitId, UnitKind};
use crate::text::FileId;

/// A unit, the same for every program that leads to it.
#[derive(Clone, Debug, Eq, Ord, PartialEq, PartialOrd)]
struct Node {
    path: PathBuf,
    key: Key,
}

/// Which unit of a file.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
enum Key {
    Main,
    Subprogram(Option<u32>),
    Macrocycle,
}

/// `textDocument/prepareCallHierarchy`: what the word at the place calls, else the unit around it.
pub(super) fn prepare(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: CallHierarchyPrepareParams,
) -> Answer<Option<Vec<CallHierarchyItem>>> {
    let mut reach = Reach::of(analysis);
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let place = offset(&file.source, params.text_document_position_params.position, snapshot.client.unit);
    let named = reach.naming_at(place).and_then(|naming| match naming.name {
        Name::Subprogram(l) => reach.resolved().subprogram(l),
        Name::Macrocycle(l) => reach.macrocycle(l),
        Name::Block(_) | Name::Parameter(_) => None,
    });
    let around = match block_at(file, place) {
        Some(block) => unit_of(analysis, block).map(|(id, _)| id),
        None => reach.resolved().main(),
    };
    let item = named.or(around).and_then(|id| item(snapshot, &reach, id));
    Ok(item.map(|item| vec![item]))
}

/// `callHierarchy/incomingCalls`, from all open documents and what they lead to.
pub(super) fn incoming(
    snapshot: &Snapshot,
    params: CallHierarchyIncomingCallsParams,
) -> Answer<Option<Vec<CallHierarchyIncomingCall>>> {
    let Some(node) = node_of_item(snapshot, &params.item) else { return Ok(None) };
    let mut found: BTreeMap<Node, CallHierarchyIncomingCall> = BTreeMap::new();
    for analysis in &snapshot.analyses {
        let reach = Reach::of(analysis);
        let Some(called) = find(&reach, &node) else { continue };
        for (caller, ranges) in callers(snapshot, &reach, called) {
            let (Some(from), Some(node)) = (item(snapshot, &reach, caller), node_of(&reach, caller)) else { continue };
            found.entry(node).or_insert(CallHierarchyIncomingCall { from, from_ranges: ranges });
        }
    }
    Ok(Some(found.into_values().collect()))
}

/// `callHierarchy/outgoingCalls`, in the order of the text.
pub(super) fn outgoing(
    snapshot: &Snapshot,
    params: CallHierarchyOutgoingCallsParams,
) -> Answer<Option<Vec<CallHierarchyOutgoingCall>>> {
    let Some(node) = node_of_item(snapshot, &params.item) else { return Ok(None) };
    // Its own analysis knows it as well as that of a program that leads to it, and calls from the same folder.
    let own = |analysis: &&std::sync::Arc<Analysis>| analysis.path == node.path;
    let first = snapshot.analyses.iter().filter(own);
    let others = snapshot.analyses.iter().filter(|analysis| !own(analysis));
    for analysis in first.chain(others) {
        let mut reach = Reach::of(analysis);
        if let Some(unit) = find(&reach, &node) {
            return Ok(Some(called_by(snapshot, &mut reach, unit)));
        }
    }
    Ok(Some(Vec::new()))
}

fn key(unit: &Unit) -> Key {
    match unit.kind {
        UnitKind::Main => Key::Main,
        UnitKind::Subprogram(l) => Key::Subprogram(l),
        UnitKind::Macrocycle(_) => Key::Macrocycle,
    }
}

fn node_of(reach: &Reach<'_>, id: UnitId) -> Option<Node> {
    let unit = reach.resolved().unit(id)?;
    Some(Node { path: reach.path(unit.file)?, key: key(unit) })
}

/// The unit of a program that is `node`; of two subprograms of one number the first.
fn find(reach: &Reach<'_>, node: &Node) -> Option<UnitId> {
    let file = reach.file_at(&node.path)?;
    reach.resolved().units().find(|(_, unit)| unit.file == file && key(unit) == node.key).map(|(id, _)| id)
}

fn item(snapshot: &Snapshot, reach: &Reach<'_>, id: UnitId) -> Option<CallHierarchyItem> {
    let unit = reach.resolved().unit(id)?;
    let file = reach.resolved().file(unit.file)?;
    let path = reach.path(unit.file)?;
    let name = match unit.kind {
        UnitKind::Main => {
            file.program.and_then(|word| word.whole()).map_or("%".to_owned(), |number| format!("%{number}"))
        }
        UnitKind::Subprogram(_) | UnitKind::Macrocycle(_) => unit.name(),
    };
    let file_name = || path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let (detail, data) = match unit.kind {
        UnitKind::Main => (NavigationText::MainProgram, json!({ "unit": "main" })),
        UnitKind::Subprogram(l) => (NavigationText::Subprogram, json!({ "unit": "subprogram", "l": l })),
        UnitKind::Macrocycle(_) => (NavigationText::Macrocycle { file: file_name() }, json!({ "unit": "macrocycle" })),
    };
    let title = file.title.filter(|_| unit.kind == UnitKind::Main).map(|title| file.comment_text(title).to_owned());
    let (all, selection) = reach.unit_place(unit)?;
    let range = |span| Places::new(&file.source, snapshot.client.unit).range(span);
    Some(CallHierarchyItem {
        name,
        kind: if unit.kind == UnitKind::Main { SymbolKind::Module } else { SymbolKind::Function },
        tags: None,
        detail: Some(title.unwrap_or_else(|| detail.text(snapshot.client.lang()))),
        uri: snapshot.files.uri_of(&reach.path(unit.file)?)?,
        range: range(all),
        selection_range: range(selection),
        data: Some(data),
    })
}

fn node_of_item(snapshot: &Snapshot, item: &CallHierarchyItem) -> Option<Node> {
    let data = item.data.as_ref()?;
    let key = match data.get("unit").and_then(Value::as_str)? {
        "main" => Key::Main,
        "subprogram" => Key::Subprogram(data.get("l").and_then(Value::as_u64).and_then(|l| u32::try_from(l).ok())),
        _ => Key::Macrocycle,
    };
    Some(Node { path: snapshot.files.path_of(&item.uri), key })
}

/// The units that call `called`, with the places of their calls.
fn callers(snapshot: &Snapshot, reach: &Reach<'_>, called: UnitId) -> BTreeMap<UnitId, Vec<Range>> {
    let mut callers: BTreeMap<UnitId, Vec<Range>> = BTreeMap::new();
    let Some(unit) = reach.resolved().unit(called) else { return callers };
    let (name, files): (Name, Vec<FileId>) = match unit.kind {
        UnitKind::Main | UnitKind::Subprogram(None) => return callers,
        UnitKind::Subprogram(Some(l)) => (Name::Subprogram(l), vec![unit.file]),
        UnitKind::Macrocycle(l) => (Name::Macrocycle(l), reach.files().collect()),
    };
    for file in files {
        let Some(parsed) = reach.resolved().file(file) else { continue };
        let mut places = Places::new(&parsed.source, snapshot.client.unit);
        for naming in reach.occurrences(file, name, &snapshot.cancel) {
            let block = block_at(parsed, naming.number.start).filter(|_| naming.usage == Usage::Call);
            if let Some((caller, _)) = block.and_then(|block| reach.unit_of(file, block)) {
                callers.entry(caller).or_default().push(places.range(naming.number));
            }
        }
    }
    callers
}

/// The calls of a unit.
fn called_by(snapshot: &Snapshot, reach: &mut Reach<'_>, caller: UnitId) -> Vec<CallHierarchyOutgoingCall> {
    let calls = calls(snapshot, reach, caller);
    let mut order: Vec<(UnitId, Vec<Range>)> = Vec::new();
    for (name, range) in calls {
        let called = match name {
            Name::Subprogram(l) => reach.resolved().subprogram(l),
            Name::Macrocycle(l) => reach.macrocycle(l),
            Name::Block(_) | Name::Parameter(_) => None,
        };
        let Some(called) = called else { continue };
        match order.iter_mut().find(|(known, _)| *known == called) {
            Some((_, ranges)) => ranges.push(range),
            None => order.push((called, vec![range])),
        }
    }
    let reach = &*reach;
    let call =
        |(called, from_ranges)| Some(CallHierarchyOutgoingCall { to: item(snapshot, reach, called)?, from_ranges });
    order.into_iter().filter_map(call).collect()
}

/// The calls written in a unit.
fn calls(snapshot: &Snapshot, reach: &Reach<'_>, caller: UnitId) -> Vec<(Name, Range)> {
    let mut calls = Vec::new();
    let Some(unit) = reach.resolved().unit(caller) else { return calls };
    let Some(names) = reach.names(unit.file) else { return calls };
    let mut places = Places::new(&names.file.source, snapshot.client.unit);
    for block in names.file.block_ids().filter(|block| unit.contains(*block)) {
        if snapshot.cancel.is_cancelled() {
            break;
        }
        let found = names.of_block(block, |name| matches!(name, Name::Subprogram(_) | Name::Macrocycle(_)));
        let calling = found.into_iter().filter(|naming| naming.usage == Usage::Call);
        calls.extend(calling.map(|naming| (naming.name, places.range(naming.number))));
    }
    calls
}
