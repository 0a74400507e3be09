#!/usr/bin/env python3
"""Measures the project's C++ sources and says what has grown beyond its limits.

    scripts/check_sources.py        prints sizes, cycles and the share of comments; ends with 1 where a limit is passed

Functions must stay as short as they are, files of one screenful after another be split, the core's folders build on
each other in one direction, each source be listed to be built, each test stand beside the source that it tests, and
each thing have one word.
"""

import re
import statistics
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PRODUCT = ("app", "core", "widgets")
# Lines of a function: at the median, of nine in ten, of the longest.
MOST_FUNCTION_LINES = (7, 17, 59)
MOST_FILE_LINES = 400
# Of a source's lines that are not empty. More would say again what the code says.
COMMENT_SHARE = (0.04, 0.20)
# Where algorithms stand each is explained above its source, so that less than this means some are not.
LEAST_ALGORITHM_SHARE = 0.12
# The core's folders in the order in which they build on each other; what is drawn stands beside them.
CORE_ORDER = ("support", "geometry", "model", "dynamics", "decoding", "surface", "solid", "probing", "fuzzy", "texture", "project", "authoring",
              "exchange", "samples")
# Of these, the folders of algorithms.
ALGORITHM_FOLDERS = ("geometry", "model", "dynamics", "surface", "solid", "probing", "fuzzy", "texture")
MAY_INCLUDE = {
    "core": ("core",),
    "widgets": ("core", "widgets"),
    "app/editor": ("core", "widgets", "app/editor"),
    "app/esm": ("core", "widgets", "app/editor", "app/esm"),
    "app/esmc": ("core", "app/esmc"),
    "app/decode": ("core", "app/decode"),
    "app/python": ("core", "app/python"),
}

# One word for each thing: what must not be said, and what is said instead.
WORDS = (
    (re.compile(r"(?<!@)\bthr(?:ow|ew)\w*\b(?! (?-i:[A-Z]|std))[^.;]{0,60}\bphotos?\b|\bphotos?\b[^.;]{0,40}(?<!@)\bthr(?:ow|ew)\w*\b(?! (?-i:[A-Z]|std))", re.I),
     "a photo is projected: to throw is for exceptions"),
    (re.compile(r"\b(?:Held|Led)Node\b"), "a node that is led along a path is prescribed"),
    (re.compile(r"\b(?:Page|Owned)Band\b|\bBandOwners\b|\bforEachBand\b"), "rows of a page are a strip"),
)
# The same of what people read in the window.
SHOWN_WORDS = ((re.compile(r"\b(?:texel|multi-band)s?\b", re.I), "a developer's word in a text of the window"),)
COMMENT_GOES_ON = re.compile(r"\n\s*///?<?")
SHOWN_TEXT = re.compile(r'\btr\(\s*((?:"(?:\\.|[^"\\\n])*"\s*)+)')

TOKEN = re.compile(
    r'R"(?P<delimiter>[^()\\\s]{0,16})\(.*?\)(?P=delimiter)"'  # raw strings
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'"  # not the marks within 1'000
    r"|//(?:\\\n|[^\n])*|/\*.*?\*/", re.S)
CONTROL = re.compile(r"\b(if|for|while|switch|catch|do|else|try|return)\b")
TYPE = re.compile(r"(^|\s)(class|struct|union|enum)\s")


def blanked(text, comments_alone=False):
    """The text with comments and the insides of strings blanked out, line for line; or comments alone."""
    def blank(match):
        token = match[0]
        is_comment = token.startswith(("//", "/*"))
        if comments_alone and not is_comment:
            return token
        return re.sub(r"[^\n]", " ", token) if is_comment else '"' + re.sub(r"[^\n]", " ", token[1:-1]) + '"'
    return TOKEN.sub(blank, text)


def without_directives(text):
    """Blanks `#define` and the like, with the lines that they go on over."""
    return re.sub(r"^[ \t]*#(?:\\\n|[^\n])*", lambda match: re.sub(r"[^\n]", " ", match[0]), text, flags=re.M)


def matching(text, start):
    """Where the bracket that opens at `start` is closed, or the end of the text."""
    closing = {"{": "}", "(": ")"}[text[start]]
    depth = 0
    for place in range(start, len(text)):
        if text[place] == text[start]:
            depth += 1
        elif text[place] == closing:
            depth -= 1
            if depth == 0:
                return place
    return len(text) - 1


def is_function(head):
    """Whether what stands before a `{`, since the last statement, declares a function."""
    head = re.sub(r"\boperator\s*(\(\)|[^\s(]+)", "operator_", head)
    before, opening, _ = head.partition("(")
    return bool(opening) and "=" not in before and not TYPE.search(" " + before) and not CONTROL.search(before)


def begins_member(head):
    """Whether a `{` after `head` gives a member its first value, in the list before a constructor's body."""
    after = re.search(r"\)\s*(?:noexcept\s*)?:(?!:)(.*)$", head, re.S)
    return bool(after) and not after[1].rstrip().endswith((")", "}"))


def function_sizes(text):
    """The lines of every function's definition, from the first line of its name and type to its last bracket."""
    text = without_directives(blanked(text))
    sizes, start, place = [], 0, 0
    while place < len(text):
        character = text[place]
        if character == "(":
            place = matching(text, place)
        elif character in ";}":
            start = place + 1
        elif character == "{":
            head = re.sub(r"^(?:\s*(?:public|private|protected|signals|public slots)\s*:)+", "", text[start:place])
            if is_function(head):
                end = matching(text, place)
                if not begins_member(head):
                    first = place - len(head.lstrip())
                    sizes.append(text.count("\n", first, end) + 1)
                    start = end + 1
                place = end
            elif head.rstrip().endswith(("=", ",", ")")) or "=" in head:
                place = matching(text, place)  # a value
            else:
                start = place + 1  # a namespace or a type: what it holds is looked at
        place += 1
    return sizes


def comment_lines(text):
    """How many lines are comments or hold one, and how many are not empty."""
    bare = blanked(text, comments_alone=True).split("\n")
    lines = text.split("\n")
    written = sum(1 for line in lines if line.strip())
    comments = sum(1 for line, code in zip(lines, bare) if line.strip() and line != code)
    return comments, written


def includes(text):
    return re.findall(r'^\s*#\s*include\s*"([^"]+)"', text, re.M)


def cycle(edges):
    """Folders that build on each other in a ring, the first again at the end; empty where there is none."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return []
        path.append(node)
        for following in sorted(edges.get(node, ())):
            ring = visit(following)
            if ring:
                return ring
        path.pop()
        done.add(node)
        return []

    for node in sorted(edges):
        ring = visit(node)
        if ring:
            return ring
    return []


def folder_edges(sources):
    """For each folder, as deep as they go, those that its files include from.

    A folder and one within it are parts of the same, and may know each other.
    """
    edges = {}
    for path, text in sources.items():
        folder = path.rpartition("/")[0]
        others = {name.rpartition("/")[0] for name in includes(text) if name.startswith(PRODUCT)}
        edges.setdefault(folder, set()).update(
            other for other in others if not f"{other}/".startswith(f"{folder}/")
            and not f"{folder}/".startswith(f"{other}/"))
    return edges


def layering_problems(sources):
    """Includes that go against the order of targets, and of the core's folders."""
    problems = []
    for path, text in sources.items():
        layer = next((name for name in MAY_INCLUDE if path.startswith(name + "/")), None)
        if not layer:
            continue
        for name in includes(text):
            if name.startswith(PRODUCT) and not name.startswith(tuple(f"{may}/" for may in MAY_INCLUDE[layer])):
                problems.append(f"{path}: includes {name}, which {layer} must not know")
            parts = [part.split("/")[1] for part in (path, name) if part.startswith("core/")]
            if len(parts) == 2 and parts[0] in CORE_ORDER:
                here, there = parts
                if there not in CORE_ORDER or CORE_ORDER.index(there) > CORE_ORDER.index(here):
                    problems.append(f"{path}: includes {name}, but core/{there} builds on core/{here}")
    return problems


def misplaced_tests(paths):
    """Tests that stand beside no source of theirs: subject_test.cpp or subject_aspect_test.cpp mirrors subject.h."""
    subjects = {path.rpartition(".")[0] for path in paths if path.endswith((".h", ".cpp"))}
    problems = []
    for path in paths:
        if not path.startswith("tests/") or not path.endswith("_test.cpp"):
            continue
        folder, _, name = path[len("tests/"):-len("_test.cpp")].rpartition("/")
        words = name.split("_")
        names = ["_".join(words[:count]) for count in range(len(words), 0, -1)]
        if not any(f"{place}/{subject}" in subjects for subject in names for place in (folder, "tests/support")):
            problems.append(f"{path}: there is no source {folder}/{name}, nor one that its name begins with")
    return problems


def unlisted_sources(paths, lists):
    """Sources that no CMakeLists.txt above them names: what is not listed is not built, and no test says so."""
    problems = []
    for path in paths:
        if not path.endswith(".cpp"):
            continue
        folders = [str(parent) for parent in Path(path).parents]
        named = (re.search(rf"(?<![\w/]){re.escape(str(Path(path).relative_to(folder)))}(?!\w)", lists.get(folder, ""))
                 for folder in folders)
        others = any(f"/{path}" in text for text in lists.values())
        if not any(named) and not others:
            problems.append(f"{path}: no CMakeLists.txt lists it, so that it is not built")
    return problems


def word_problems(texts):
    """Words that say another thing than what is meant; and, in the window, those that only developers know."""
    problems = []
    for path, text in texts.items():
        # A sentence in a comment goes on over lines; blanks keep every place where it was.
        whole = COMMENT_GOES_ON.sub(lambda mark: " " * len(mark[0]), text)
        found = [(word.start(), instead) for words, instead in WORDS for word in words.finditer(whole)]
        found += [(shown.start(), why) for shown in SHOWN_TEXT.finditer(text)
                  for words, why in SHOWN_WORDS if words.search(shown[1])]
        problems += [f"{path}:{text.count(chr(10), 0, place) + 1}: {what}" for place, what in found]
    return problems


def quantiles(sizes):
    ordered = sorted(sizes)
    return statistics.median_low(ordered), ordered[int(0.9 * (len(ordered) - 1))], ordered[-1]


def tracked_sources():
    listed = subprocess.run(["git", "ls-files", "*.h", "*.cpp"], cwd=ROOT, check=True, capture_output=True, text=True)
    return {path: (ROOT / path).read_text() for path in listed.stdout.split() if (ROOT / path).exists()}


def tracked_lists():
    """What the CMakeLists.txt of each folder says."""
    listed = subprocess.run(["git", "ls-files", "CMakeLists.txt", "*/CMakeLists.txt"], cwd=ROOT, check=True,
                            capture_output=True, text=True)
    return {str(Path(path).parent): (ROOT / path).read_text() for path in listed.stdout.split()}


def tracked_pages():
    listed = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, check=True, capture_output=True, text=True)
    return {path: (ROOT / path).read_text() for path in listed.stdout.split() if (ROOT / path).exists()}


def function_problems(product):
    sizes = {path: function_sizes(text) for path, text in product.items()}
    found = quantiles([size for of_file in sizes.values() for size in of_file])
    print(f"functions: {found[0]} lines at the median, {found[1]} of nine in ten, {found[2]} the longest "
          f"(at most {', '.join(map(str, MOST_FUNCTION_LINES))})")
    problems = [f"{path}: a function of {max(of_file)} lines"
                for path, of_file in sizes.items() if max(of_file, default=0) > MOST_FUNCTION_LINES[2]]
    if any(size > most for size, most in zip(found[:2], MOST_FUNCTION_LINES)):
        problems.append("functions have become longer at the median or of nine in ten")
    return problems


def file_problems(sources):
    lines = {path: text.count("\n") for path, text in sources.items()}
    for ending in (".cpp", ".h"):
        sizes = {path: size for path, size in lines.items() if path.endswith(ending)}
        longest = max(sizes, key=sizes.get)
        print(f"{ending} files: {len(sizes)}, {statistics.median_low(sizes.values())} lines at the median, "
              f"{sizes[longest]} the longest ({longest})")
    return [f"{path}: {size} lines, {MOST_FILE_LINES} at most"
            for path, size in lines.items() if path.endswith(".cpp") and size > MOST_FILE_LINES]


def comment_problems(product):
    problems = []
    for what, ending in (("headers", ".h"), ("sources", ".cpp")):
        counts = [comment_lines(text) for path, text in product.items() if path.endswith(ending)]
        share = sum(comments for comments, _ in counts) / sum(written for _, written in counts)
        print(f"comments in {what}: {100 * share:.1f} % of lines")
        if ending == ".cpp" and not COMMENT_SHARE[0] <= share <= COMMENT_SHARE[1]:
            problems.append(f"comments are {100 * share:.1f} % of sources: from {100 * COMMENT_SHARE[0]:.0f} "
                            f"to {100 * COMMENT_SHARE[1]:.0f} % is meant")
    return problems


def algorithm_comment_problems(product):
    """Folders of algorithms, all that is within them counted, whose sources explain too little."""
    problems = []
    for folder in ALGORITHM_FOLDERS:
        counts = [comment_lines(text) for path, text in product.items()
                  if path.startswith(f"core/{folder}/") and path.endswith(".cpp")]
        if not counts:
            continue
        share = sum(comments for comments, _ in counts) / sum(written for _, written in counts)
        print(f"comments in sources of core/{folder}: {100 * share:.1f} % of lines")
        if share < LEAST_ALGORITHM_SHARE:
            problems.append(f"core/{folder}: comments are {100 * share:.1f} % of its sources, "
                            f"{100 * LEAST_ALGORITHM_SHARE:.0f} % at least: say above each algorithm why it is so")
    return problems


def main():
    sources = tracked_sources()
    product = {path: text for path, text in sources.items() if path.startswith(PRODUCT)}
    problems = (function_problems(product) + file_problems(sources) + comment_problems(product)
                + algorithm_comment_problems(product))
    ring = cycle(folder_edges(product))
    print("folders: " + (" -> ".join(ring) if ring else "no cycles"))
    if ring:
        problems.append("folders build on each other in a ring: " + " -> ".join(ring))
    problems += layering_problems(product) + misplaced_tests(list(sources))
    problems += unlisted_sources(list(sources), tracked_lists()) + word_problems({**sources, **tracked_pages()})
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
