"""Reads a report's pages as a browser would have to: well-formed, every id once, every link and file there, both
languages with the same parts, nothing from a network.

Usage: report_page.py DIR     prints the counts; exit status 1 with a line for each fault
       report_page.py --self-test
"""
import pathlib
import re
import sys
import tempfile
import xml.etree.ElementTree as ET

PAGES = {"index.html": "en", "index.ja.html": "ja"}
XHTML = "{http://www.w3.org/1999/xhtml}"


def ids_of(tree):
    return [e.get("id") for e in tree.iter() if e.get("id")]


def faults_of_page(folder, name, language):
    try:
        tree = ET.parse(folder / name)
    except (ET.ParseError, OSError) as e:
        return [f"{name}: {e}"], None
    faults, ids = [], ids_of(tree)
    if tree.getroot().get("lang") != language:
        faults.append(f"{name}: its language is {tree.getroot().get('lang')}")
    faults += [f"{name}: the id {i} stands {ids.count(i)} times" for i in sorted(set(ids)) if ids.count(i) > 1]
    for e in tree.iter():
        for attribute in ("href", "src"):
            target = e.get(attribute)
            if target is None:
                continue
            if target.startswith("#"):
                if target[1:] not in ids:
                    faults.append(f"{name}: nothing has the id {target[1:]}")
            elif re.match(r"[a-z]+:|//", target):
                faults.append(f"{name}: {target} is not in the folder")
            elif not (folder / target).is_file():
                faults.append(f"{name}: {target} is missing")
        if e.tag in (XHTML + "script", XHTML + "link"):
            faults.append(f"{name}: has a {e.tag}")
        if e.tag == XHTML + "img" and not e.get("alt"):
            faults.append(f"{name}: a picture has no words")
    text = "".join(tree.getroot().find(XHTML + "body").itertext())
    if "{{" in text or "…" in text:
        faults.append(f"{name}: a number is missing in a text")
    if language == "ja":
        sections = [s for s in tree.iter(XHTML + "section") if s.get("class") == "step"]
        faults += [f"{name}: {s.get('id')} has no Japanese" for s in sections
                   if not re.search("[ぁ-んァ-ヶ]", "".join(s.itertext()))]
    return faults, tree


def faults_of(folder):
    folder = pathlib.Path(folder)
    faults, shapes = [], []
    for name, language in PAGES.items():
        found, tree = faults_of_page(folder, name, language)
        faults += found
        if tree is not None:
            shapes.append((ids_of(tree), sum(1 for _ in tree.iter(XHTML + "img")), sum(1 for _ in tree.iter(XHTML + "tr"))))
    if len(shapes) == 2 and shapes[0] != shapes[1]:
        faults.append("the two languages do not have the same parts")
    if not faults:
        print(f"{len(shapes[0][0])} ids, {shapes[0][1]} pictures, {shapes[0][2]} rows")
    return faults


def page(language, body):
    return f'<!DOCTYPE html>\n<html xmlns="http://www.w3.org/1999/xhtml" lang="{language}"><body>{body}</body></html>'


def self_test():
    good = '<p id="a"><a href="#a">x</a></p>'
    bad = {"open": "<p>", "twice": '<p id="a"/><p id="a"/>', "nowhere": '<a href="#b">x</a>', "missing": '<img src="x.png" alt="x"/>',
           "network": '<img src="https://example.org/x.png" alt="x"/>', "script": "<script/>", "wordless": '<img src="index.html"/>',
           "unfilled": "{{red}}", "other parts": '<p id="b"/>'}
    for name, body in {"good": good, **bad}.items():
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "index.html").write_text(page("en", body), encoding="utf-8")
            (folder / "index.ja.html").write_text(page("ja", good), encoding="utf-8")
            assert bool(faults_of(folder)) == (name != "good"), name
    return 0


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        sys.exit(self_test())
    found = faults_of(sys.argv[1])
    for fault in found:
        print(fault)
    sys.exit(1 if found else 0)
