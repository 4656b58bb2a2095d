"""Links of the documentation, offline: files, anchors and pictures that are named are there, and pages of algorithms have all that is promised of them.

usage: links.py ROOT [BUILT]

BUILT is the folder of the built manual, whose links are looked at, too."""

import html.parser
import pathlib
import re
import sys
import urllib.parse

# What a page of an algorithm must have; `**What.**` is its definition.
PROMISED = {
    "definition": r"\*\*What\.\*\*",
    "source": r"\b(19|20)\d\d\b",
    "parameters": r"\*\*(Parameters|Options|Conditions|Filters|Uses)\b",
    "degenerate cases": r"\*\*(Degenerate|Ties|Errors|Limits|Cospherical|What is exempt|Empty|One pole)\b|^## Limits",
    "guarantees": r"\*\*(Guarantees|Check|Checks|Validation|Why it always succeeds)\b",
    "cost": r"\*\*Cost\b",
}
# Pages whose parameters a picture can show.
NO_PICTURE = {"index", "predicates"}

problems = []


def without_code(text):
    text = re.sub(r"^(`{3,})[^\n]*\n.*?^\1`*$", "", text, flags=re.M | re.S)
    text = "\n".join(line for line in text.split("\n") if not line.startswith("    "))
    return re.sub(r"(`+)(?!`).+?(?<!`)\1(?!`)", "", text, flags=re.S)


def anchors(text):
    """Of the headings, as GitHub makes them."""
    found, counts = set(), {}
    for heading in re.findall(r"^#{1,6} +(.+?) *#*$", re.sub(r"^(`{3,}).*?^\1`*$", "", text, flags=re.M | re.S), re.M):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").replace("*", "").strip().lower()
        slug = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
        number = counts.get(slug, 0)
        counts[slug] = number + 1
        found.add(f"{slug}-{number}" if number else slug)
    return found


def check_page(root, page):
    text = page.read_text(encoding="utf-8")
    body = without_code(text)
    name = page.relative_to(root)
    targets = re.findall(r"\[(?:[^\[\]]|\[[^\]]*\])*\]\(<?([^)\s>]+)>?(?: \"[^\"]*\")?\)", body)
    targets += re.findall(r"^\[[^\]]+\]: +(\S+)", body, re.M)
    for target in targets:
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = urllib.parse.unquote(target).partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.exists():
            problems.append(f"{name}: {target} is not there")
        elif not file.is_relative_to(root):
            problems.append(f"{name}: {target} leads out of the repository")
        elif anchor and file.suffix == ".md" and anchor not in anchors(file.read_text(encoding="utf-8")):
            problems.append(f"{name}: {target}: no such heading")
    # Pages that are named without a link.
    for path in re.findall(r"`([\w./-]+\.md)`", text):
        if not any((folder / path).exists() for folder in (root, root / "docs", page.parent)):
            problems.append(f"{name}: {path} is not there")
    for alternative in re.findall(r"!\[([^\]]*)\]", body):
        if not alternative.strip():
            problems.append(f"{name}: a picture without a description")
    return targets


def check_algorithm(page):
    text = page.read_text(encoding="utf-8")
    for what, pattern in PROMISED.items():
        if not re.search(pattern, text, re.M):
            problems.append(f"{page.name}: no {what}")
    if page.stem not in NO_PICTURE and "![" not in text:
        problems.append(f"{page.name}: no picture")


class Links(html.parser.HTMLParser):
    """The links and anchors of a built page."""

    def __init__(self):
        super().__init__()
        self.links, self.ids = [], set()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.ids |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        link = attributes.get("href") if tag in ("a", "link") else attributes.get("src") if tag in ("img", "script") else None
        if link and not re.match(r"[a-z]+:|//", link):
            self.links.append(link)


def check_built(folder):
    pages = {}
    for file in folder.rglob("*.html"):
        pages[file] = Links()
        pages[file].feed(file.read_text(encoding="utf-8"))
    for file, page in pages.items():
        for link in page.links:
            path, _, anchor = urllib.parse.unquote(link.split("?")[0]).partition("#")
            target = (file.parent / path).resolve() if path else file
            if target.is_dir():
                target /= "index.html"
            if not target.exists():
                problems.append(f"{file.relative_to(folder)}: {link} is not there")
            elif anchor and target in pages and anchor not in pages[target].ids:
                problems.append(f"{file.relative_to(folder)}: {link}: no such place")
    return len(pages)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = sorted((root / "docs").rglob("*.md")) + [root / name for name in ("README.md", "ARCHITECTURE.md", "CHANGELOG.md")]
    linked = set()
    for page in pages:
        for target in check_page(root, page):
            linked.add((page.parent / target.partition("#")[0]).resolve())
    for page in sorted((root / "docs" / "algorithms").glob("*.md")):
        if page.stem != "index":
            check_algorithm(page)
    for picture in sorted((root / "docs").rglob("*.png")):
        if picture.resolve() not in linked:
            problems.append(f"{picture.relative_to(root)}: on no page")
        if picture.parent.name == "gallery" and picture.stat().st_size > 300_000:
            problems.append(f"{picture.relative_to(root)}: {picture.stat().st_size} bytes")
    built = check_built(pathlib.Path(sys.argv[2]).resolve()) if len(sys.argv) > 2 else 0
    for problem in problems:
        print(problem)
    print(f"{len(pages)} pages, {len(linked)} places that they link to, {built} built pages: {len(problems)} problems")
    sys.exit(1 if problems else 0)


main()
