"""Many mutants of a file in one program. Each mutated expression e becomes (the_mutant == 7 ? e' : e), and a statement
that a mutant drops begins with if (the_mutant != 8); the environment's MUTANT says which one the program is. Functions
that the compiler could compute are left to the program, since which mutant it is is known only there. Source of the idea:
Untch, Offutt & Harrold, "Mutation analysis using mutant schemata", ISSTA 1993, doi:10.1145/154183.154265.

What is an expression is guessed from brackets and punctuation. Where the guess is wrong the compiler complains about a
line of ours, and that mutant is compiled by itself.
"""
import re

PRELUDE = """#ifndef TRIBUNAL_MUTANT
#define TRIBUNAL_MUTANT
#include <cstdlib>
inline int which_mutant() { const char* const text = std::getenv("MUTANT"); return text ? std::atoi(text) : 0; }
inline const int the_mutant = which_mutant();
#endif
"""
CONSTEXPR_FUNCTION = re.compile(r'^([ ]*(?:static )?)constexpr (?=[^=\n]*\([^\n]*\)[^=\n]*\{)', re.M)
HOPELESS = re.compile(r'was not declared in this scope|has no member named|is not a member of|no match for .operator'
                      r'|does not name a type|has not been declared')
numbers = {}


def number_of(mutant):
    return numbers.setdefault(mutant, len(numbers) + 1)


def masked(text):
    """The text with comments and strings blanked, of the same length."""
    blank = lambda m: re.sub(r'[^\n]', ' ', m.group())
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"', blank, text, flags=re.S)


def opens_body(mask, at):
    """Whether the brace at this place opens a function's body or a statement's block."""
    return re.search(r'(\)|\bconst|\bnoexcept|\belse|\bdo|\bmutable|->\s*[\w:<>&*, ]+)\s*$', mask[max(0, at - 120):at])


def in_body(mask, at):
    """Whether this place lies in a function's body."""
    depth = 0
    for i in range(at - 1, -1, -1):
        if mask[i] == '}':
            depth += 1
        elif mask[i] == '{':
            if depth == 0 and opens_body(mask, i):
                return True
            depth = max(0, depth - 1)
    return False


def is_boundary(mask, i):
    """Whether an expression ends at this character, outside of all brackets."""
    c, before, after = mask[i], mask[i - 1], mask[i + 1:i + 2]
    if c in ';,?':
        return True
    if c == ':':
        return before != ':' and after != ':'
    return c == '=' and after != '=' and before not in '=<>!'


def left_end(mask, at):
    depth, i = 0, at - 1
    while i >= 0:
        c = mask[i]
        if c in ')]' or (c == '}' and not re.match(r'[ ]*\n', mask[i + 1:])):
            depth += 1
        elif c in '([{':
            if depth == 0:
                return i + 1
            depth -= 1
        elif depth == 0:
            if c == '}' or is_boundary(mask, i):
                return i + 1
            if mask[i - 5:i + 1] == 'return' and not mask[i - 6].isalnum():
                return i + 1
        i -= 1
    return 0


def right_end(mask, at):
    depth, i = 0, at
    while i < len(mask):
        c = mask[i]
        if c in '([{':
            depth += 1
        elif c in ')]}':
            if depth == 0:
                return i
            depth -= 1
        elif depth == 0 and is_boundary(mask, i):
            return i
        i += 1
    return i


def fitting(mutants):
    """Those whose place could be found, each with number and extent known."""
    if not mutants:
        return []
    mask = masked(mutants[0].original)
    return [m for m in mutants if in_body(mask, m.start) and extent(m, mask) is not None]


def extent(mutant, mask):
    if mutant.drops_statement():
        return mutant.start, mutant.end
    l, r = left_end(mask, mutant.start), right_end(mask, mutant.end)
    while l < r and mask[l].isspace():
        l += 1
    while r > l and mask[r - 1].isspace():
        r -= 1
    return (l, r) if l <= mutant.start and mutant.end <= r and '#' not in mask[l:r] else None


def merged(mutants):
    """The text that is all of them, and for its lines (from 1) the mutant written there."""
    # Of the same length, so that all places stay where they are.
    text = CONSTEXPR_FUNCTION.sub(r'\1inline    ', mutants[0].original)
    mask = masked(text)
    places = {}
    for m in mutants:
        places.setdefault((extent(m, mask), m.drops_statement()), []).append(m)
    # Outer ones first; of two that overlap without nesting, the later is left out: its line then is nobody's.
    ordered = sorted(places, key=lambda p: (p[0][0], -p[0][1], not p[1]))
    out, owners = [], {}

    def emit(l, r, inside):
        at = l
        while inside:
            (start, end), drops = place = inside[0]
            nested = [p for p in inside[1:] if p[0][1] <= end and p[0][0] >= start]
            rest = [p for p in inside[1:] if p[0][0] >= end]
            out.append(text[at:start])
            if drops:
                out.append(f'\nif (the_mutant != {number_of(places[place][0])}) ')
                mark(places[place][0])
                emit(start, end, nested)
            else:
                out.append('(')
                for m in places[place]:
                    out.append(f'\nthe_mutant == {number_of(m)} ? ')
                    out.append('(' + text[start:m.start].replace('\n', ' ') + m.new + text[m.end:end].replace('\n', ' ') + ')')
                    mark(m)
                    out.append('\n: ')
                out.append('(')
                emit(start, end, nested)
                out.append('))')
            at, inside = end, rest
        out.append(text[at:r])

    def mark(m):
        owners[''.join(out).count('\n') + 1] = m

    out.append(PRELUDE)
    emit(0, len(text), ordered)
    return ''.join(out), owners


def blamed(complaints, file, owners):
    """Mutants on whose lines the compiler found errors, and those of them that no program could have."""
    found, hopeless = set(), set()
    for name, line, message in re.findall(r'^([^\s:]+):(\d+):\d+: error: (.*)', complaints, re.M):
        if not name.endswith(file):
            continue
        m = owners.get(int(line))
        if m is None:
            nearest = min(owners, key=lambda n: abs(n - int(line)), default=None)
            m = owners.get(nearest)
        if m is not None:
            found.add(m)
            if int(line) in owners and HOPELESS.search(message) and re.search(r'\b%s\b' % re.escape(m.new.strip()), message):
                hopeless.add(m)
    return found, hopeless
