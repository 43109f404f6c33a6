"""The mutants of a file: every copy of it that differs in one token."""
import dataclasses
import re

# What replaces what. clang-format puts spaces around binary operators and none around template brackets.
OPERATORS = [(' < ', ' <= '), (' > ', ' >= '), (' <= ', ' < '), (' >= ', ' > '), (' == ', ' != '), (' != ', ' == '),
             (' + ', ' - '), (' - ', ' + '), (' * ', ' + '), (' && ', ' || '), (' || ', ' && '), (' += ', ' = '),
             (' |= ', ' &= '), (' |= ', ' = '), (' & ', ' | '), (' | ', ' & '), ('++', '--'), ('--', '++')]
WORDS = [('x', 'y'), ('y', 'z'), ('z', 'x'), ('u', 'v'), ('v', 'u'), ('a', 'b'), ('b', 'c'), ('c', 'a'), ('p', 'q'),
         ('q', 'p'), ('i', 'j'), ('j', 'k'), ('k', 'i'), ('f', 'g'), ('g', 'f'), ('s', 't'), ('lo', 'hi'), ('hi', 'lo'),
         ('num', 'den'), ('den', 'num'), ('positive', 'negative'), ('negative', 'positive'), ('zero', 'positive'),
         ('true', 'false'), ('false', 'true'), ('first', 'second'), ('second', 'first'), ('edge', 'vertex'),
         ('vertex', 'interior'), ('interior', 'edge'), ('source', 'target'), ('target', 'source'),
         ('source_side', 'target_side'), ('target_side', 'source_side'), ('near_end', 'far_end'),
         ('far_end', 'near_end'), ('source_of_ab', 'target_of_ab'), ('a_of_probe', 'b_of_probe'),
         ('between', 'source'), ('oa', 'bo'), ('bo', 'oa'), ('ob', 'oa'), ('tmin', 'tmax'), ('tmax', 'tmin'),
         ('from', 'to'), ('to', 'from'), ('height', 'gain'), ('gain', 'height'), ('value', 'terms'),
         ('terms', 'value'), ('hit', 'miss'), ('miss', 'hit'), ('ab', 'ac'), ('bc', 'ab'), ('ac', 'bc'),
         ('larger', 'smaller'), ('smaller', 'larger'), ('uw', 'vd'), ('vd', 'uw'), ('forward', 'backward'),
         ('backward', 'forward'), ('external_edge', 'internal_edge'), ('internal_edge', 'inside'),
         ('inside', 'internal_edge')]
STATEMENTS = [(r'(?<=\.)k\b', 'tiny'), (r'(?<=\.)tiny\b', 'k'), (r'return miss\(\);', 'return hit_at(Contact::coplanar);'),
              (r'\bif \(.*\) return[^;]*;', ';'), (r'\bcontinue;', ';'), (r'(?<=[(,?:=] )-|(?<=\()-|(?<=return )-', ''),
              (r'!(?=[\w(])', '')]
# A name after a type is being declared: with another name the copy would not compile.
DECLARED = re.compile(r'(?<![\w.])(?!(?:return|case|else|throw) )[A-Za-z_][\w:]*(?:<[^()]*>)?[&*]{0,2} $')
PATTERNS = ([(re.compile(re.escape(old)), lambda m, new=new: [new]) for old, new in OPERATORS] +
            [(re.compile(r'\b%s\b' % old), lambda m, new=new: [new]) for old, new in WORDS] +
            [(re.compile(r'(?<![\w.:])\d+(?![\w.])'),
              lambda m: [str(n) for n in {0: [1], 1: [0, 2]}.get(int(m.group()),
                                                                   [int(m.group()) - 1, int(m.group()) + 1])])] +
            [(re.compile(pattern), lambda m, new=new: [new]) for pattern, new in STATEMENTS])


@dataclasses.dataclass(frozen=True)
class Mutant:
    """The file's text with [start, end) replaced by `new`; `number` counts lines from 1."""
    file: str
    number: int
    line: str
    changed: str
    start: int
    end: int
    new: str
    original: str = dataclasses.field(repr=False)

    def text(self):
        return self.original[:self.start] + self.new + self.original[self.end:]

    def drops_statement(self):
        return self.new == ';'


def code_lines(text):
    """Offset, number and line of code: no comments, no preprocessor, no declarations that only the compiler reads."""
    in_concept, offset = False, 0
    for number, line in enumerate(text.split('\n'), 1):
        bare = re.sub(r' /\*.*?\*/', lambda m: ' ' * len(m.group()), line.split('//')[0])
        in_concept |= 'concept ' in bare
        skip = in_concept or bare.lstrip().startswith(
            ('#', 'template', 'using', 'static_assert', 'namespace', '*', '__extension__'))
        if in_concept and bare.startswith('};'):
            in_concept = False
        if not skip and bare.strip():
            yield offset, number, bare.rstrip()
        offset += len(line) + 1


def without_strings(line):
    return re.sub(r'"(?:[^"\\]|\\.)*"', lambda m: '"' + ' ' * (len(m.group()) - 2) + '"', line)


def mutants_of(root, file):
    text = (root / file).read_text()
    for offset, number, line in code_lines(text):
        bare, seen = without_strings(line), set()
        for pattern, replacements in PATTERNS:
            for m in pattern.finditer(bare):
                if m.group()[0].isalpha() and DECLARED.search(bare[:m.start()]):
                    continue
                for new in replacements(m):
                    changed = line[:m.start()] + new + line[m.end():]
                    if changed not in seen:
                        seen.add(changed)
                        yield Mutant(file, number, line.strip(), changed.strip(), offset + m.start(), offset + m.end(),
                                     new, text)
