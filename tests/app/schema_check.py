"""Validates YAML files with an independent validator of JSON Schema.

    schema_check.py SCHEMA FILE...

Prints a line for each file that does not fit: its name and the first fault. The schema itself must
be one of draft 2020-12. Exit code 1: some file does not fit.
"""

import json
import re
import sys

import jsonschema
import yaml


class Loader(yaml.SafeLoader):
    """Numbers and words as YAML 1.2 has them: 1e-5 is a number, on and off are words."""


Loader.yaml_implicit_resolvers = {
    first: [(tag, pattern) for tag, pattern in resolvers if tag not in ("tag:yaml.org,2002:bool", "tag:yaml.org,2002:float", "tag:yaml.org,2002:timestamp")]
    for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()
}
Loader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile(r"^(?:true|false)$"), list("tf"))
Loader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$"), list("-+0123456789."))


def main(schema_file, *files):
    with open(schema_file) as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    bad = 0
    for name in files:
        with open(name) as file:
            faults = sorted(validator.iter_errors(yaml.load(file, Loader)), key=lambda fault: list(map(str, fault.path)))
        if faults:
            bad = 1
            print(f"{name}: {'.'.join(map(str, faults[0].path))}: {faults[0].message[:300]}")
    return bad


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
