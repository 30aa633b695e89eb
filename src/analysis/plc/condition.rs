//! Conditions over signals: what `--find` looks for. Three-valued, as in SQL: what depends on an absent value is
//! neither true nor false.

use std::cmp::Ordering;

use super::choose::{Why, of_word, why_none};
use super::dictionary::{Cell, Form, Signal, signals};
use super::grammar::{Comparison, DEEPEST, Tree, parse, too_deep};
use super::run_time;
use super::tokens::{Kind, Token, tokens};
use super::values::Value;
use crate::config::Machine;
use crate::diag::{ConditionProblem, Diagnostic, Finding, FixTitle, SignalProblem};
use crate::dict::Dialect;
use crate::sure::{Sure, small};
use crate::text::{FileId, Location, Span};

/// A condition, and the signals that it names.
#[derive(Clone, Debug)]
pub struct Condition {
    node: Node,
    signals: Vec<&'static Signal>,
}

/// Numbers are compared in millionths; signals are indices in the condition's own list.
#[derive(Clone, Debug)]
enum Node {
    Bit(usize),
    Compare { left: usize, by: Comparison, right: Operand },
    Not(Box<Node>),
    And(Vec<Node>),
    Or(Vec<Node>),
    Edge { rising: bool, of: Box<Node> },
}

#[derive(Clone, Copy, Debug)]
enum Operand {
    Signal(usize),
    Number(Number),
}

/// A number as written: millionths, rounded towards zero, and whether there is more behind them.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
struct Number {
    millionths: i128,
    more: bool,
    negative: bool,
}

const MILLION: i128 = 1_000_000;
/// Digits before the point that a number may have.
const LONGEST: usize = 18;

impl Condition {
    /// The condition that `text` is, for signals of the control of a machine.
    ///
    /// # Errors
    /// The mistakes in it, each at its place; `text` is file 0.
    pub fn read(text: &str, machine: &Machine) -> Result<Self, Vec<Diagnostic>> {
        let mut reader = Reader { text, machine, signals: Vec::new(), found: Vec::new() };
        let tokens = tokens(text);
        for token in &tokens {
            reader.look_at(*token);
        }
        let node = match too_deep(&tokens) {
            Some(token) => {
                reader.add_problem(ConditionProblem::TooDeep { limit: DEEPEST }, token.span, None);
                None
            }
            None => match parse(&tokens) {
                Ok(tree) => reader.node(&tree, false),
                Err(at) => {
                    reader.misplaced(&tokens, at);
                    None
                }
            },
        };
        let Reader { mut found, signals, .. } = reader;
        match node {
            Some(node) if found.is_empty() => Ok(Self { node, signals }),
            _ => {
                found.sort_by_key(|diagnostic| (diagnostic.at, diagnostic.code()));
                found.dedup_by_key(|diagnostic| (diagnostic.at, diagnostic.code()));
                Err(found)
            }
        }
    }

    /// The signals that it names, each once.
    pub fn signals(&self) -> &[&'static Signal] {
        &self.signals
    }

    /// Whether it holds in a step, with values of its signals in the step before and now.
    pub fn holds(&self, before: &[Value], now: &[Value]) -> bool {
        self.eval(&self.node, before, now) == Some(true)
    }

    fn eval(&self, node: &Node, before: &[Value], now: &[Value]) -> Option<bool> {
        match node {
            Node::Bit(index) => now.get(*index).copied().flatten().map(|value| value != 0),
            Node::Compare { left, by, right } => {
                let left = self.millionths(*left, now)?;
                let order = match right {
                    Operand::Signal(right) => left.cmp(&self.millionths(*right, now)?),
                    Operand::Number(number) => number.compared_with(left),
                };
                Some(by.is(order))
            }
            Node::Not(of) => self.eval(of, before, now).map(|holds| !holds),
            Node::And(all) => settle(all.iter().map(|node| self.eval(node, before, now)), false),
            Node::Or(any) => settle(any.iter().map(|node| self.eval(node, before, now)), true),
            Node::Edge { rising, of } => {
                let was = self.eval(of, before, before).map(|holds| holds != *rising);
                let is = self.eval(of, before, now).map(|holds| holds == *rising);
                settle([was, is].into_iter(), false)
            }
        }
    }

    fn millionths(&self, index: usize, values: &[Value]) -> Option<i128> {
        let value = i128::from(values.get(index).copied().flatten()?);
        let real = self.signals.get(index)?.form() == Form::Real;
        Some(if real { value } else { value * MILLION })
    }
}

/// `decisive` when one is; else absent when one is; else its opposite.
fn settle(mut values: impl Iterator<Item = Option<bool>>, decisive: bool) -> Option<bool> {
    let whole = values.try_fold(Some(!decisive), |whole, value| match value {
        Some(value) if value == decisive => Err(()),
        value => Ok(whole.and(value)),
    });
    whole.unwrap_or(Some(decisive))
}

impl Comparison {
    const fn is(self, order: Ordering) -> bool {
        match self {
            Self::Equal => order.is_eq(),
            Self::NotEqual => order.is_ne(),
            Self::Less => order.is_lt(),
            Self::AtMost => order.is_le(),
            Self::Greater => order.is_gt(),
            Self::AtLeast => order.is_ge(),
        }
    }
}

impl Number {
    const fn hexadecimal(value: i128) -> Self {
        Self { millionths: value * MILLION, more: false, negative: false }
    }

    /// A decimal number that the lexer found well formed; `None` when it has too many digits.
    fn decimal(text: &str) -> Option<Self> {
        let (negative, digits) = match text.as_bytes() {
            [b'-', ..] => (true, text.get(1..)?),
            [b'+', ..] => (false, text.get(1..)?),
            _ => (false, text),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let whole = whole.trim_start_matches('0');
        if whole.len() > LONGEST {
            return None;
        }
        let (near, far) = fraction.split_at_checked(6).unwrap_or((fraction, ""));
        let magnitude = format!("{whole}{near:0<6}").parse::<i128>().ok()?;
        let more = far.bytes().any(|digit| digit != b'0');
        Some(Self { millionths: if negative { -magnitude } else { magnitude }, more, negative })
    }

    /// How `value`, in millionths, lies to the number.
    fn compared_with(self, value: i128) -> Ordering {
        value.cmp(&self.millionths).then(match (self.more, self.negative) {
            (false, _) => Ordering::Equal,
            (true, false) => Ordering::Less,
            (true, true) => Ordering::Greater,
        })
    }

    /// Whether it is above 9, so that decimal and BCD differ.
    const fn is_above_9(self) -> bool {
        self.millionths > 9 * MILLION || (self.millionths == 9 * MILLION && self.more)
    }
}

/// From the tree to the condition, with all that is wrong.
struct Reader<'a> {
    text: &'a str,
    machine: &'a Machine,
    signals: Vec<&'static Signal>,
    found: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn slice(&self, span: Span) -> &str {
        self.text.get(span.start as usize..span.end as usize).sure()
    }

    /// Reports a finding, with what to write instead where that is known.
    fn add(&mut self, finding: Finding, span: Span, written: Option<String>) {
        let diagnostic = Diagnostic::new(finding, at(span));
        self.found.push(match written {
            Some(text) => diagnostic.with_offer(FixTitle::Write { text: text.clone() }, at(span), text),
            None => diagnostic,
        });
    }

    fn add_problem(&mut self, problem: ConditionProblem, span: Span, written: Option<String>) {
        self.add(Finding::MalformedCondition { problem }, span, written);
    }

    /// Reports a token that is malformed by itself.
    fn look_at(&mut self, token: Token) {
        let written = self.slice(token.span).to_owned();
        if let Some(right) = token.kind.meant() {
            let problem = ConditionProblem::OtherOperator { written, right: right.to_owned() };
            self.add_problem(problem, token.span, Some(right.to_owned()));
        } else if token.kind == Kind::Malformed {
            let fix =
                written.contains(',').then(|| written.replace(',', ".")).filter(|text| Number::decimal(text).is_some());
            let fix = fix.filter(|text| text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.".contains(&byte)));
            self.add_problem(ConditionProblem::NoNumber { written }, token.span, fix);
        } else if token.kind == Kind::Unknown {
            self.add_problem(ConditionProblem::Character { written }, token.span, None);
        }
    }

    /// The token at `index` has no place there.
    fn misplaced(&mut self, tokens: &[Token], index: usize) {
        let end = small(self.text.len());
        let before = index.checked_sub(1).and_then(|index| tokens.get(index)).copied();
        let here = tokens.get(index).copied();
        let span = here.map_or_else(|| Span::empty(before.map_or(end, |token| token.span.end)), |token| token.span);
        // A malformed token has its finding already.
        if here.is_some_and(|token| matches!(token.kind, Kind::Malformed | Kind::Unknown)) {
            return;
        }
        let ends_operand = before.is_some_and(|token| {
            matches!(token.kind, Kind::Name | Kind::Hexadecimal | Kind::Decimal | Kind::Close | Kind::Malformed)
        });
        let problem = match (before.map(|token| token.kind), here.map(|token| token.kind)) {
            (None, None) => ConditionProblem::Empty,
            (Some(Kind::Rising | Kind::Falling), _) => ConditionProblem::EdgeParentheses,
            (_, None) if ends_operand => ConditionProblem::Unclosed,
            (_, Some(Kind::Close)) if ends_operand => ConditionProblem::Superfluous,
            (_, Some(Kind::Name | Kind::Rising | Kind::Falling | Kind::Not | Kind::WordNot | Kind::Open))
                if ends_operand =>
            {
                ConditionProblem::NoOperator
            }
            (_, Some(Kind::Hexadecimal | Kind::Decimal)) if ends_operand => ConditionProblem::NoOperator,
            (_, Some(Kind::Hexadecimal | Kind::Decimal)) => ConditionProblem::NumberFirst,
            (_, Some(kind)) if ends_operand && kind != Kind::Close => ConditionProblem::ComparedTwice,
            (Some(kind), _) if Comparison::of(kind).is_some() => ConditionProblem::MissingOperand,
            _ => ConditionProblem::MissingSignal,
        };
        self.add_problem(problem, span, None);
    }

    fn node(&mut self, tree: &Tree, within_edge: bool) -> Option<Node> {
        match tree {
            Tree::Signal { name, compared: None } => {
                let signal = self.signal(*name)?;
                if signal.form() != Form::Bit {
                    let problem =
                        ConditionProblem::NoBit { name: signal.name.clone(), example: example(signal).to_owned() };
                    self.add_problem(problem, name.span, None);
                    return None;
                }
                Some(Node::Bit(self.index(signal)))
            }
            Tree::Signal { name, compared: Some((by, with)) } => {
                let left = self.signal(*name);
                let right = self.operand(*with, *by, left);
                Some(Node::Compare { left: self.index(left?), by: *by, right: right? })
            }
            Tree::Not { at, of } => {
                self.check_not(*at, of);
                Some(Node::Not(Box::new(self.node(of, within_edge)?)))
            }
            Tree::And(all) => self.nodes(all, within_edge).map(Node::And),
            Tree::Or(any) => self.nodes(any, within_edge).map(Node::Or),
            Tree::Group(of) => self.node(of, within_edge),
            Tree::Edge { at, rising, of } => {
                if within_edge {
                    self.add_problem(ConditionProblem::EdgeInEdge, *at, None);
                    return None;
                }
                Some(Node::Edge { rising: *rising, of: Box::new(self.node(of, true)?) })
            }
        }
    }

    /// All of them, with all that is wrong in any.
    fn nodes(&mut self, trees: &[Tree], within_edge: bool) -> Option<Vec<Node>> {
        let nodes: Vec<_> = trees.iter().map(|tree| self.node(tree, within_edge)).collect();
        nodes.into_iter().collect()
    }

    /// `!PB06 == 19h`: the `!` belongs to the name alone.
    fn check_not(&mut self, not: Span, of: &Tree) {
        if let Tree::Signal { name, compared: Some((_, with)) } = of {
            let comparison = self.slice(Span::new(name.span.start, with.span.end)).to_owned();
            let right = format!("!({comparison})");
            let span = Span::new(not.start, with.span.end);
            // `NOT PB06 == 19h`: one change is enough.
            self.found.retain(|found| found.at != at(not));
            let problem = ConditionProblem::NotOfComparison { right: right.clone() };
            self.add_problem(problem, span, Some(right));
        }
    }

    fn operand(&mut self, token: Token, by: Comparison, left: Option<&'static Signal>) -> Option<Operand> {
        let text = self.slice(token.span).to_owned();
        if token.kind == Kind::Hexadecimal {
            let digits = text.get(..text.len() - 1)?.trim_start_matches('0');
            let value = if digits.is_empty() { Some(0) } else { i128::from_str_radix(digits, 16).ok() };
            let value = value.filter(|_| digits.len() <= LONGEST);
            if value.is_none() {
                self.add_problem(ConditionProblem::NumberTooLong, token.span, None);
            }
            let number = Number::hexadecimal(value?);
            self.check_possible(left, by, number, token.span)?;
            return Some(Operand::Number(number));
        }
        if token.kind == Kind::Decimal {
            let Some(number) = Number::decimal(&text) else {
                self.add_problem(ConditionProblem::NumberTooLong, token.span, None);
                return None;
            };
            if let Some(left) = left.filter(|left| left.is_bcd() && number.is_above_9()) {
                self.add_decimal(left, &text, token.span);
                return None;
            }
            self.check_possible(left, by, number, token.span)?;
            return Some(Operand::Number(number));
        }
        // `FFh` reads as a name.
        let digits = text.strip_suffix(['h', 'H']).unwrap_or_default();
        if !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
            let right = format!("0{text}");
            let problem = ConditionProblem::HexadecimalLetter { right: right.clone() };
            self.add_problem(problem, token.span, Some(right));
            return None;
        }
        let signal = self.signal(token)?;
        Some(Operand::Signal(self.index(signal)))
    }

    /// A comparison that no value of the signal can fulfil is an error, as `M03PI == 2`.
    fn check_possible(&mut self, left: Option<&Signal>, by: Comparison, number: Number, span: Span) -> Option<()> {
        let Some((left, [low, high])) = left.and_then(|left| Some((left, left.range()?))) else { return Some(()) };
        // How the least and the greatest value lie to the number.
        let (low_lies, high_lies) = (number.compared_with(low * MILLION), number.compared_with(high * MILLION));
        let whole = !number.more && number.millionths % MILLION == 0;
        let possible = match by {
            Comparison::Equal => whole && low_lies.is_le() && high_lies.is_ge(),
            Comparison::NotEqual => true,
            Comparison::Less => low_lies.is_lt(),
            Comparison::AtMost => low_lies.is_le(),
            Comparison::Greater => high_lies.is_gt(),
            Comparison::AtLeast => high_lies.is_ge(),
        };
        if possible {
            return Some(());
        }
        let problem =
            ConditionProblem::NeverHolds { name: left.name.clone(), low: low.to_string(), high: high.to_string() };
        self.add_problem(problem, span, None);
        None
    }

    /// A decimal number above 9 against a cell in BCD.
    fn add_decimal(&mut self, signal: &Signal, text: &str, span: Span) {
        let digits = text.trim_start_matches('+');
        // 12.0 is 12.
        let digits = match digits.split_once('.') {
            Some((whole, rest)) if rest.bytes().all(|digit| digit == b'0') => whole,
            _ => digits,
        };
        // The cell may have no room for as many digits.
        let holds = |value: i128| signal.range().is_none_or(|[_, high]| value <= high);
        let whole =
            digits.bytes().all(|byte| byte.is_ascii_digit()) && i128::from_str_radix(digits, 16).is_ok_and(holds);
        let right = if whole { format!("{digits}h") } else { String::new() };
        let tool = matches!(signal.cell, Cell::Tool | Cell::ToolByte(_));
        let finding =
            Finding::DecimalForBcd { name: signal.name.clone(), number: text.to_owned(), right: right.clone(), tool };
        self.add(finding, span, whole.then_some(right));
    }

    fn signal(&mut self, token: Token) -> Option<&'static Signal> {
        let name = self.slice(token.span).to_owned();
        let known = signals().iter().find(|signal| signal.name == name && signal.row.is_of(self.machine.dialect));
        if known.is_none() {
            let why = match of_word(&name, self.machine) {
                Some(near) => Why::Near(near),
                None => why_none(&name, self.machine.dialect),
            };
            if name.contains('*') && !matches!(why, Why::RunTime { .. }) {
                // One of several signals cannot be meant.
                self.add_problem(ConditionProblem::Character { written: "*".to_owned() }, token.span, None);
                return None;
            }
            let why = signal_problem(&why, self.machine.dialect);
            let plain = name.strip_prefix("BLK[0].").map_or_else(|| name.clone(), |cell| format!("BLK.{cell}"));
            let written = if let SignalProblem::Near(near) = &why {
                Some(near.clone()).filter(|near| near.eq_ignore_ascii_case(&plain))
            } else {
                None
            };
            self.add(Finding::UnknownSignal { name, why }, token.span, written);
        }
        known
    }

    fn index(&mut self, signal: &'static Signal) -> usize {
        let known = self.signals.iter().position(|other| other.name == signal.name);
        known.unwrap_or_else(|| {
            self.signals.push(signal);
            self.signals.len() - 1
        })
    }
}

/// The problem with a name that is no signal.
pub fn signal_problem(why: &Why, dialect: Dialect) -> SignalProblem {
    match why {
        Why::RunTime { name } => match run_time::find(name) {
            Some(known) => SignalProblem::RunTime(known.reason.clone()),
            None => SignalProblem::Nothing,
        },
        Why::OtherControl => SignalProblem::OtherControl(dialect.name().to_owned()),
        Why::Near(near) => SignalProblem::Near(near.clone()),
        Why::Nothing => SignalProblem::Nothing,
    }
}

impl Signal {
    /// The least and the greatest value; none of real numbers.
    fn range(&self) -> Option<[i128; 2]> {
        Some(match (self.cell, self.form()) {
            (_, Form::Real) => return None,
            (Cell::Gear, _) => [1, 4],
            (_, Form::Bit) => [0, 1],
            (_, Form::Byte) if self.is_bcd() => [0, 0x99],
            (_, Form::Byte) => [0, 0xFF],
            (_, Form::Word) => [0, 0xFFFF],
            (_, Form::DWord) => [0, 0xFFFF_FFFF],
        })
    }
}

/// How a signal that is no bit may be compared.
const fn example(signal: &Signal) -> &'static str {
    if signal.is_hexadecimal() {
        return "== 19h";
    }
    match signal.form() {
        Form::Real => "> 12.5",
        Form::Bit | Form::Byte | Form::Word | Form::DWord => "== 1",
    }
}

const fn at(span: Span) -> Location {
    Location { file: FileId(0), span }
}

#[cfg(test)]
#[path = "condition_tests.rs"]
mod tests;
