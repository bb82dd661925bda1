#!/usr/bin/env python3
"""Writes the blocks of pages anew that a command of this program made, and the figures of the same documents.

  scripts/generated_blocks.py docs/stability.md docs/accuracy.md [--figures docs/figures] [--only WORDS]

A block stands between <!-- made by: warpgrain ARGS --> and <!-- end -->. What the command prints goes there: as it is
where it prints Markdown (--markdown), else as a code block. Wildcards in ARGS are expanded. Where ARGS are followed by
(as NAME), --figures has scripts/figures.mjs draw what the command writes as JSON.
"""
import argparse
import glob
import pathlib
import re
import shlex
import subprocess
import tempfile

BLOCK = re.compile(r"(<!-- made by: warpgrain (.*?)(?: \(as (\w+)\))? -->\n).*?(<!-- end -->)", re.S)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="+", type=pathlib.Path)
    parser.add_argument("--warpgrain", default="build/release/cli/warpgrain")
    parser.add_argument("--figures", help="folder for the figures")
    parser.add_argument("--only", default="", help="only blocks whose command has these words in it")
    options = parser.parse_args()

    def made_anew(block):
        if options.only not in block[2]:
            return block[0]
        words = shlex.split(block[2])
        call = [options.warpgrain, *(name for word in words for name in sorted(glob.glob(word)) or [word])]
        with tempfile.TemporaryDirectory() as folder:
            document = f"{folder}/{block[3]}.json"
            if options.figures and block[3]:
                call += ["--json", document]
            text = subprocess.run(call, check=True, capture_output=True, text=True).stdout
            if options.figures and block[3]:
                figures = pathlib.Path(__file__).with_name("figures.mjs")
                subprocess.run(["node", figures, options.figures, document], check=True)
        if "--markdown" not in words:
            text = f"```\n$ warpgrain {block[2]}\n{text}```\n"
        return f"{block[1]}\n{text}\n{block[4]}"

    for page in options.pages:
        page.write_text(BLOCK.sub(made_anew, page.read_text(encoding="utf-8")), encoding="utf-8")


main()
