"""Pages of which a script writes a part: what stands between <!-- begin NAME --> and <!-- end NAME -->."""
import sys


def with_block(page, name, text):
    """The text of the page, a pathlib.Path, with that part replaced; ends the program where the page has no such part."""
    marks = f"<!-- begin {name} -->", f"<!-- end {name} -->"
    before, begin, rest = page.read_text(encoding="utf-8").partition(marks[0])
    _, end, after = rest.partition(marks[1])
    if not begin or not end:
        sys.exit(f"{page}: no lines {marks[0]} and {marks[1]}")
    return f"{before}{begin}\n{text}{end}{after}"


def write_or_check(word, page, name, text):
    """What `--write` and `--check` of a script do that makes that part of the page."""
    made = with_block(page, name, text)
    if word == "--write":
        page.write_text(made, encoding="utf-8")
    elif made != page.read_text(encoding="utf-8"):
        sys.exit(f"{page} is not what the readings say; expected what --write makes of them")
