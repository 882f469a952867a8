#!/usr/bin/env python3
"""Documents: what is linked or cited is there."""

import re
import unittest
from pathlib import Path

from program import main

TOP = Path(__file__).resolve().parents[2]
DOCUMENTS = [*TOP.glob("*.md"), *TOP.glob("docs/*.md"), *TOP.glob("tests/**/*.md")]
SOURCES = [path for folder in ["src", "tests", "tools"] for path in (TOP / folder).rglob("*")
           if path.suffix in {".h", ".cpp", ".py", ".txt", ".inc"} or path.parent == TOP / "tools"]


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


if __name__ == "__main__":
    main()
