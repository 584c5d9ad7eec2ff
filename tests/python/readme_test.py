# SPDX-License-Identifier: MIT
"""The examples of docs/python.md run, one after another, and what they assert holds."""
import pathlib
import re
import unittest


class Readme(unittest.TestCase):
    def test_examples(self):
        path = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"
        text = path.read_text()
        names = {}
        blocks = list(re.finditer(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL))
        self.assertGreater(len(blocks), 3)
        for block in blocks:
            line = text.count("\n", 0, block.start(1))
            exec(compile("\n" * line + block[1], path, "exec"), names)


if __name__ == "__main__":
    unittest.main()
