"""Parses pages as XML: well_formed.py PAGE... prints a line a page: "well-formed", or where it is not."""
import sys
import xml.etree.ElementTree as ElementTree

for name in sys.argv[1:]:
    try:
        ElementTree.parse(name)
        print("well-formed")
    except ElementTree.ParseError as error:
        print(error)
