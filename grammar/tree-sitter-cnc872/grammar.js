/**
 * Part programs of the CNC8x6, CNC8x9 and CNC872 controls, as `grammar/part-program.ebnf` writes them down.
 *
 * A word is an address and its value; only blanks and tabs stand between the two. Line ends and comments stand between
 * words, so they are written out and no extras. A block ends where the next `N` begins (BLK-1): its last line ends are its
 * own. What a value may be and which words go together is not said here: `cnc872c` says it.
 */

/// <reference types="tree-sitter-cli/dsl" />

const SIGN = /[+\-]/;
const NUMBER = /[+\-]?([0-9]+\.?[0-9]*|\.[0-9]+)/;
const PARAMETER = /[Rr][ \t]*[0-9]+/;

/** A word: one of `letters`, in either case, and its value. */
const word = (letters) => ($) => seq(field("address", alias(address(letters), $.address)), field("value", $._value));

/** Each kind of word has a token of its own, so that the tree tells them apart. */
const address = (letters) => token(new RegExp(`[${letters}${letters.toLowerCase()}]`));

module.exports = grammar({
  name: "cnc872",

  extras: () => [/[ \t]/],

  externals: ($) => [
    // What stands before the first `%` of a program (LEX-1).
    $.unread_start,
    // Never found: what needs it is an error.
    $._nothing,
  ],

  supertypes: ($) => [$.word],

  inline: ($) => [$._gap, $._value],

  rules: {
    program: ($) =>
      seq(
        optional($.unread_start),
        repeat($._gap),
        optional(seq($.program_number, repeat($._gap))),
        repeat($.block),
        optional(seq($.end_mark, repeat($._line_end), optional($.text_after_end))),
        optional($._tail),
      ),

    program_number: ($) => seq(field("address", alias("%", $.address)), field("value", $.number)),

    block: ($) => seq(field("number", $.block_number), repeat(choice($.word, $._gap, $._foreign))),

    block_number: ($) => seq(field("address", alias(address("N"), $.address)), field("value", $.number)),

    word: ($) =>
      choice(
        $.skip,
        $.preparatory_function,
        $.technological_function,
        $.auxiliary_function,
        $.axis_word,
        $.center_word,
        $.feed_word,
        $.speed_word,
        $.tool_word,
        $.correction_word,
        $.target_word,
        $.repeat_word,
        $.parameter_assignment,
      ),

    // LEX-10: digits after it are read and mean nothing.
    skip: () => token(/\/([ \t]*[0-9]+)?/),
    preparatory_function: word("G"),
    technological_function: word("M"),
    auxiliary_function: word("HP"),
    axis_word: word("ABCUVWXYZ"),
    center_word: word("IJK"),
    feed_word: word("F"),
    speed_word: word("S"),
    tool_word: word("T"),
    correction_word: word("D&"),
    target_word: word("L"),
    repeat_word: word("Q"),

    // PAR-1: with `=` the value may be a parameter.
    parameter_assignment: ($) =>
      choice(
        seq(field("parameter", $.parameter), "=", field("value", $._value)),
        seq(field("parameter", $.parameter), field("value", $.number)),
        // `R1.5` is no parameter with a value: blanks or a sign stand between the two.
        seq($.parameter, token.immediate(/[.,Oo][.,0-9Oo]*/), $._nothing),
      ),

    _value: ($) => choice($.number, $.parameter, $.signed_parameter),
    number: () => token(NUMBER),
    parameter: () => token(PARAMETER),
    signed_parameter: ($) => seq(field("sign", alias(token(SIGN), $.sign)), alias(token.immediate(PARAMETER), $.parameter)),

    // What is no word is one error, whatever letters are in it: text that lacks its quotes, comments as other controls write
    // them.
    _foreign: ($) => seq(token(choice(/[A-Za-zÀ-ž][A-Za-zÀ-ž][A-Za-zÀ-ž]+/, /\([^)\r\n]*\)/, /;[^\r\n]*/)), $._nothing),

    _gap: ($) => choice($.comment, $._line_end),
    // LEX-6; a typographic quote opens a comment too, and `cnc872c` says so (LEX-12).
    comment: () => token(choice(/"[^"\r\n]*"?/, /[“”„][^"“”„\r\n]*["“”„]?/)),
    _line_end: () => token(/\r\n|\n|\r/),

    end_mark: () => "*",
    // LEX-9: never read.
    text_after_end: () => token(/[^ \t\r\n\x1a\x00](.|[\r\n])*/),
    // LEX-8: as DOS editors leave it.
    _tail: () => token(/[\x1a\x00][\x1a\x00 \t\r\n]*/),
  },
});
