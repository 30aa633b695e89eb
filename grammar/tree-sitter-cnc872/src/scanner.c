// What stands before the first `%` is no part of a program, whatever it is (LEX-1). A macrocycle has no `%`, and one in a
// comment of it means nothing: a macrocycle begins with a block that holds G79 (PRG-7).

#include "tree_sitter/parser.h"

enum Token { UNREAD_START, NOTHING };

void *tree_sitter_cnc872_external_scanner_create(void) { return NULL; }
void tree_sitter_cnc872_external_scanner_destroy(void *payload) { (void)payload; }

unsigned tree_sitter_cnc872_external_scanner_serialize(void *payload, char *buffer) {
    (void)payload;
    (void)buffer;
    return 0;
}

void tree_sitter_cnc872_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
    (void)payload;
    (void)buffer;
    (void)length;
}

static bool is_digit(int32_t c) { return c >= '0' && c <= '9'; }
static bool is_blank(int32_t c) { return c == ' ' || c == '\t'; }
static bool is_line_end(int32_t c) { return c == '\r' || c == '\n'; }
static bool is_typographic(int32_t c) { return c == 0x201c || c == 0x201d || c == 0x201e; }

typedef struct {
    TSLexer *lexer;
    // The first `%` is found, and marked as the end of the token.
    bool percent;
    // Something other than blanks and line ends stands before it.
    bool text;
} Start;

static void next(Start *start) {
    int32_t c = start->lexer->lookahead;
    if (c == '%' && !start->percent) {
        start->percent = true;
        start->lexer->mark_end(start->lexer);
    }
    if (!start->percent && !is_blank(c) && !is_line_end(c)) start->text = true;
    start->lexer->advance(start->lexer, false);
}

static bool skip_comment(Start *start) {
    TSLexer *lexer = start->lexer;
    bool plain = lexer->lookahead == '"';
    if (!plain && !is_typographic(lexer->lookahead)) return false;
    next(start);
    while (!lexer->eof(lexer) && !is_line_end(lexer->lookahead)) {
        bool closes = lexer->lookahead == '"' || (!plain && is_typographic(lexer->lookahead));
        next(start);
        if (closes) break;
    }
    return true;
}

// `letter` in either case, blanks, and digits whose value is put into `number`.
static bool word(Start *start, char letter, unsigned *number) {
    TSLexer *lexer = start->lexer;
    if ((lexer->lookahead & ~0x20) != letter) return false;
    next(start);
    while (is_blank(lexer->lookahead)) next(start);
    if (!is_digit(lexer->lookahead)) return false;
    *number = 0;
    while (is_digit(lexer->lookahead)) {
        if (*number < 1000) *number = *number * 10 + (unsigned)(lexer->lookahead - '0');
        next(start);
    }
    return true;
}

// Whether the text begins with a block that holds G79.
static bool is_macrocycle(Start *start) {
    TSLexer *lexer = start->lexer;
    unsigned number;
    while (is_blank(lexer->lookahead) || is_line_end(lexer->lookahead) || skip_comment(start)) {
        if (is_blank(lexer->lookahead) || is_line_end(lexer->lookahead)) next(start);
    }
    if (!word(start, 'N', &number)) return false;
    while (!lexer->eof(lexer)) {
        int32_t c = lexer->lookahead;
        if (c == '%' || c == '*' || c == 'N' || c == 'n') return false;
        if (c == 'G' || c == 'g') {
            if (word(start, 'G', &number) && number == 79) return true;
        } else if (!skip_comment(start)) {
            next(start);
        }
    }
    return false;
}

bool tree_sitter_cnc872_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
    (void)payload;
    // While it recovers from an error, everything is valid.
    if (!valid[UNREAD_START] || valid[NOTHING]) return false;
    Start start = {.lexer = lexer, .percent = false, .text = false};
    if (is_macrocycle(&start)) return false;
    while (!start.percent && !lexer->eof(lexer)) next(&start);
    lexer->result_symbol = UNREAD_START;
    return start.percent && start.text;
}
