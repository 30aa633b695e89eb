# Reads a scenario of tests/lsp and writes it as a script of the target `editor`, in escapes of `printf %b`.

BEGIN {
    for (at = 1; at < 256; at++) number[sprintf("%c", at)] = at
    # As METHODS of src/editor.rs.
    count = split("hover completion codeAction rename prepareRename references documentHighlight definition declaration " \
        "documentSymbol foldingRange selectionRange semanticTokens/full semanticTokens/range inlayHint codeLens " \
        "documentLink onTypeFormatting prepareCallHierarchy incomingCalls outgoingCalls resolve symbol executeCommand " \
        "textDocumentContent diagnostic", names, " ")
    for (at = 1; at <= count; at++) method[names[at]] = at - 1
}

/^=== / {
    section()
    verb = $2; name = $3; rest = $4; more = $5; body = ""
    next
}

{ body = body $0 "\n" }

END { section() }

function byte(value) { return sprintf("\\0%03o", value > 252 ? 252 : value) }

function escaped(text,    at, letter, result) {
    for (at = 1; at <= length(text); at++) {
        letter = substr(text, at, 1)
        result = result (letter ~ /[A-Za-z0-9 .=%]/ ? letter : byte(number[letter]))
    }
    return result "\\0036"
}

function file(name) {
    if (name ~ /toml$/) return 2
    if (name ~ /xml$/) return 4
    if (name ~ /L9001$/) return 1
    if (name ~ /L[0-9]/) return 6
    if (!(name in files)) files[name] = (programs++ % 2) * 5
    return files[name]
}

# Takes the marks out of a text, and remembers where they stood.
function unmarked(name, text,    at, result, mark, lines, parts) {
    while ((at = index(text, "\342\200\271")) > 0) {
        result = result substr(text, 1, at - 1)
        text = substr(text, at + 3)
        at = index(text, "\342\200\272")
        mark = substr(text, 1, at - 1)
        text = substr(text, at + 3)
        lines = split(result, parts, "\n")
        if (result == "") { lines = 1; parts[1] = "" }
        place[name, mark] = byte(lines - 1) byte(length(parts[lines]))
    }
    return result text
}

function where(name, mark) { return (name, mark) in place ? place[name, mark] : byte(0) byte(0) }

function section(    parts, last, text) {
    if (verb == "file") printf "w%s%s", byte(file(name)), escaped(unmarked(name, body))
    if (verb == "open") printf "o%s%s", byte(file(name)), escaped(unmarked(name, body))
    if (verb == "text") printf "C%s%s", byte(file(name)), escaped(unmarked(name, body))
    if (verb == "close") printf "x%s", byte(file(name))
    if (verb == "findings") printf "e"
    if (verb == "edited") printf "a%s", byte(0)
    if (verb == "replace") {
        sub(/\n$/, "", body)
        printf "c%s%s%s%s%s", byte(file(name)), byte(0), where(name, rest), where(name, more), escaped(body)
    }
    if (verb == "request") {
        split(rest, parts, "@")
        rest = parts[1]
        if (split(parts[2], parts, /\.\./) < 2) parts[2] = parts[1]
        last = name
        sub(/^(textDocument|callHierarchy|codeAction|workspace)\//, "", last)
        text = body
        if (!sub(/.*"(newName|query)": "/, "", text)) text = ""
        sub(/".*/, "", text)
        printf "r%s%s%s%s%s%s", byte(method[last]), byte(rest == "" ? 0 : file(rest)), where(rest, parts[1]),
            where(rest, parts[2]), byte(body ~ /fixAll/ ? 1 : body ~ /renumber|source/ ? 2 : 3), escaped(text)
    }
    verb = ""
}
