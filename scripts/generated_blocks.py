#!/usr/bin/env python3
"""Writes the blocks of pages anew that a command of this program made.

  scripts/generated_blocks.py docs/stability.md docs/accuracy.md [--warpgrain build/release/cli/warpgrain]

A block stands between <!-- made by: warpgrain ARGS --> and <!-- end -->. What the command prints goes there: as it is
where it prints Markdown (--markdown), else as a code block.
"""
import argparse
import pathlib
import re
import shlex
import subprocess

BLOCK = re.compile(r"(<!-- made by: warpgrain (.*?) -->\n).*?(<!-- end -->)", re.S)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="+", type=pathlib.Path)
    parser.add_argument("--warpgrain", default="build/release/cli/warpgrain")
    options = parser.parse_args()

    def made_anew(block):
        words = shlex.split(block[2])
        text = subprocess.run([options.warpgrain, *words], check=True, capture_output=True, text=True).stdout
        if "--markdown" not in words:
            text = f"```\n$ warpgrain {block[2]}\n{text}```\n"
        return f"{block[1]}\n{text}\n{block[3]}"

    for page in options.pages:
        page.write_text(BLOCK.sub(made_anew, page.read_text(encoding="utf-8")), encoding="utf-8")


main()
