"""Validates JSON documents: validate.py SCHEMA DOCUMENT...

Checks the schema itself first, then prints a line a document: "valid", or the first place that is not and why.
"""
import json
import sys

from jsonschema import Draft202012Validator

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
for name in sys.argv[2:]:
    with open(name, encoding="utf-8") as file:
        error = next(validator.iter_errors(json.load(file)), None)
    print("valid" if error is None else f"{error.json_path}: {error.message[:200]}")
