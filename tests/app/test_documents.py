#!/usr/bin/env python3
"""Documents: what is linked or cited is there, down to the numbered section."""

import re
import unittest
from pathlib import Path

from program import main

TOP = Path(__file__).resolve().parents[2]
DOCUMENTS = [*TOP.glob("*.md"), *TOP.glob("docs/*.md"), *TOP.glob("tests/**/*.md")]
SOURCES = [path for folder in ["src", "tests", "tools"] for path in (TOP / folder).rglob("*")
           if path.suffix in {".h", ".cpp", ".py", ".txt", ".inc"} or path.parent == TOP / "tools"]

# "physics.md 3.5", "physics.md 3.3, 3.4", "[physics.md](docs/physics.md) 12"; not "levels.md, 1e-9 m".
NUMBER = r"\d+(?:\.\d+)*[a-z]?(?![\w-])(?!\.\d)"
CITATION = re.compile(rf"\b([\w-]+\.md)\)? ({NUMBER}(?:(?:, | to | and ){NUMBER})*)")


def sections_of(text):
    """The numbers of a document's headings: "## 3. Legs", "### 3.5 Circular track"."""
    return re.findall(r"^#{2,} (\d+(?:\.\d+)*)\.? \S", text, re.MULTILINE)


def cited_sections(text):
    """Which sections of which documents a text cites; comments may break a citation over two lines."""
    joined = re.sub(r"\n[ \t]*(?://|#)?[ \t]*", " ", text)
    return [(name, number) for name, numbers in CITATION.findall(joined) for number in re.findall(NUMBER, numbers)]


def cited_in_vain(text, sections):
    """The citations, as text, of sections that their documents do not have. `sections`: of each document by its name."""
    return [f"{name} {number}" for name, number in cited_sections(text) if number not in sections.get(name, [])]


class Documents(unittest.TestCase):
    def test_links_lead_somewhere(self):
        links = 0
        for document in DOCUMENTS:
            for link in re.findall(r"\]\(([^)#]+)[^)]*\)", document.read_text()):
                if "://" in link:
                    continue
                links += 1
                self.assertTrue((document.parent / link).exists(), f"{document}: {link}")
        self.assertGreater(links, 10)

    def test_documents_that_code_cites_exist(self):
        known = {document.name for document in DOCUMENTS}
        cited = 0
        for source in filter(lambda path: path.is_file(), SOURCES):
            for name in re.findall(r"\b([\w-]+\.md)\b", source.read_text(errors="replace")):
                cited += 1
                self.assertIn(name, known, f"{source} cites {name}")
        self.assertGreater(cited, 20)

    def test_sections_that_are_cited_exist(self):
        sections = {document.name: sections_of(document.read_text()) for document in DOCUMENTS}
        cited = 0
        for path in filter(lambda path: path.is_file() and path != Path(__file__).resolve(), [*SOURCES, *DOCUMENTS]):
            text = path.read_text(errors="replace")
            cited += len(cited_sections(text))
            self.assertEqual(cited_in_vain(text, sections), [], path)
        self.assertGreater(cited, 40)

    def test_a_section_that_does_not_exist_is_seen(self):
        sections = {"physics.md": sections_of("# A\n\n## 1. One\n\n### 1.2 Two\n\ntext 3.4\n\n## 10. Ten\n")}
        self.assertEqual(sections["physics.md"], ["1", "1.2", "10"])
        for text in ["// (docs/physics.md 1.2).", "# physics.md 1, 1.2", "as physics.md 10: r = 0.5", "// physics.md, 7 m",
                     "// physics.md 7e-3 m", "// physics.md argues 7"]:
            self.assertEqual(cited_in_vain(text, sections), [], text)
        for text, wrong in {"// (physics.md 2)": "2", "physics.md 1.2, 1.3": "1.3", "physics.md 1 to 1.4": "1.4",
                            "physics.md 1 and 3.": "3", "  // see physics.md\n  // 1.5 on": "1.5", "physics.md 1a": "1a",
                            "[physics.md](docs/physics.md) 2.1": "2.1", "# physics.md\n# 9": "9"}.items():
            self.assertEqual(cited_in_vain(text, sections), [f"physics.md {wrong}"], text)
        self.assertEqual(cited_in_vain("game.md 1", sections), ["game.md 1"])

    def test_numbered_documents_number_each_section_once_and_refer_to_their_own(self):
        numbered = 0
        for document in DOCUMENTS:
            text = document.read_text()
            sections = sections_of(text)
            numbered += len(sections)
            self.assertEqual(len(set(sections)), len(sections), document)
            if not sections:
                continue
            # "(3.2)", "(8.1, 8.2)", "of 12.3": a number and a point and a number that is no quantity.
            for numbers in re.findall(r"\((?:see )?(\d+\.\d+(?:, \d+\.\d+)*)\)", text):
                for number in numbers.split(", "):
                    self.assertIn(number, sections, document)
        self.assertGreater(numbered, 40)


if __name__ == "__main__":
    main()
