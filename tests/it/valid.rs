//! Random valid programs: no findings, and a stream that is what the model's own interpreter says.

use cnc872c::diag::Code;
use cnc872c::text::MemoryLoader;
use proptest::prelude::*;
use serde_json::Value;

use crate::markers::{Request, options};
use crate::model::{Executed, LETTERS, listing, program};
use crate::properties::cases;
use crate::run::{Run, run};
use crate::samples::RECORDS;

/// How far a length in the stream may be from one computed in floating point.
const CLOSE: f64 = 2e-6;

fn millionths(value: &Value) -> i64 {
    (value.as_f64().unwrap() * 1e6).round() as i64
}

fn assert_close(found: &Value, wanted: Option<f64>, what: &str) {
    match (found.as_f64(), wanted) {
        (Some(found), Some(wanted)) => {
            assert!((found - wanted).abs() <= CLOSE + wanted.abs() * 1e-12, "{what}: {found}, not {wanted}");
        }
        (found, wanted) => assert_eq!(found, wanted, "{what}"),
    }
}

fn assert_block(record: &Value, wanted: &Executed) {
    assert_eq!(record["n"], wanted.n);
    let calls: Vec<(u64, u64, u64)> = record["calls"]
        .as_array()
        .into_iter()
        .flatten()
        .map(|call| (call["l"].as_u64().unwrap(), call["pass"].as_u64().unwrap(), call["of"].as_u64().unwrap()))
        .collect();
    let wanted_calls: Vec<(u64, u64, u64)> =
        wanted.calls.iter().map(|&(l, pass, of)| (l.into(), pass.into(), of.into())).collect();
    assert_eq!(calls, wanted_calls, "calls");
    match wanted.jump {
        None => assert_eq!(record["jump"], Value::Null),
        Some((to, left)) => {
            assert_eq!(record["jump"]["to"], to);
            assert_eq!(record["jump"]["left"].as_u64(), left.map(u64::from), "0 is written");
        }
    }
    for (letter, value) in LETTERS.iter().zip(wanted.position) {
        let position = millionths(&record["position"][letter.to_string()]);
        assert_eq!(position, value * 1000, "{letter}");
    }
    assert_close(&record["motion"]["length_mm"], wanted.length_mm, "length_mm");
    assert_close(&record["motion"]["sweep_deg"], wanted.sweep_deg, "sweep_deg");
    assert_eq!(record["m"][2], wanted.spindle, "group 2");
    assert_eq!(record["s"].as_u64(), wanted.speed.map(u64::from), "S");
}

proptest! {
    #![proptest_config(cases(500))]

    /// FLW-1…FLW-4, FLW-8, FLW-10, MOT-1, MOT-5, MOT-6, LEX-3, LEX-4, BLK-1, BLK-6, MFN-7: a valid program has no
    /// finding; its records are those of the reference interpretation, in its order.
    #[test]
    fn streams_of_valid_programs(program in program()) {
        let executed = program.execute();
        prop_assume!(executed.is_some());
        let executed = executed.unwrap();
        let loader = MemoryLoader::new().with("p.nc", program.text());
        let mut request = Request::default();
        if program.block_skip {
            options(&mut request.overrides, "--block-skip");
        }
        let checked = run(&loader, "p.nc", &request);
        // Programs made at random cut before they start the spindle, and break lines anywhere.
        let codes = |run: &Run| run.codes().into_iter().filter(|code| ![Code::W0619, Code::W0221].contains(code)).collect::<Vec<_>>();
        assert_eq!(codes(&checked), [], "\n{}", listing(&program));
        request.compile = true;
        let compiled = run(&loader, "p.nc", &request);
        assert_eq!(codes(&compiled), []);
        assert_eq!((checked.executed, compiled.executed), (executed.len() as u64, executed.len() as u64), "{}", listing(&program));

        let records = compiled.records();
        let (first, last) = (records.first().unwrap(), records.last().unwrap());
        assert_eq!((&first["kind"], &first["number"], &first["title"]), (&"program".into(), &1.into(), &"MODEL".into()));
        assert_eq!(first["block_skip"].as_bool().unwrap_or(false), program.block_skip);
        let blocks = &records[1..records.len() - 1];
        let order: Vec<u64> = blocks.iter().map(|record| record["n"].as_u64().unwrap()).collect();
        let wanted: Vec<u64> = executed.iter().map(|block| block.n.into()).collect();
        assert_eq!(order, wanted, "{}", listing(&program));
        let mut path = 0;
        let mut by_type = std::collections::BTreeMap::new();
        for (seq, (record, wanted)) in blocks.iter().zip(&executed).enumerate() {
            assert_block(record, wanted);
            assert_eq!(record["seq"], seq);
            assert_eq!(record["first_block"].as_bool(), (seq == 0).then_some(true));
            assert_eq!(record["last_block"].as_bool(), (seq + 1 == blocks.len()).then_some(true));
            if record["motion"]["length_mm"].is_number() {
                let length = millionths(&record["motion"]["length_mm"]);
                path += length;
                *by_type.entry(record["motion"]["type"].as_str().unwrap().to_owned()).or_insert(0) += length;
            }
            if seq % 16 == 0 {
                assert!(RECORDS.is_valid(record), "{record}");
            }
        }
        assert_eq!(&last["kind"], "end");
        assert_eq!(last["reason"], format!("M{:02}", program.end));
        assert_eq!(last["blocks"], executed.len());
        assert_eq!(millionths(&last["path_mm"]), path);
        let sums = last["path_mm_by_type"].as_object().cloned().unwrap_or_default();
        assert_eq!(sums.iter().map(|(kind, sum)| (kind.clone(), millionths(sum))).collect::<std::collections::BTreeMap<_, _>>(), by_type);
    }
}
