"""The published form of a fleet file: what is written fits it, and it tells what each field is."""

import copy
import json

import jsonschema
import numpy as np
import pytest
from certificates import certificate_of, drawn_shares, file_with_plan
from exhaustive import optimum, random_instance
from places import ROOT
from referencing import Registry, Resource

from platoon_osm.errors import ScenarioError
from platoon_osm.inspection.certificate.told import told_of

SCHEMA, PLAN = (
    json.loads((ROOT / "docs" / name).read_text(encoding="utf-8"))
    for name in ("fleet.schema.json", "plan.schema.json")
)
FIT = jsonschema.Draft202012Validator(
    SCHEMA, registry=Registry().with_resource("plan.schema.json", Resource.from_contents(PLAN))
)


def written(seed):
    instance = random_instance(seed, waiting=None)
    schedules = optimum(instance).schedules
    shares = drawn_shares(instance, np.random.default_rng(seed))
    certificate = certificate_of(instance, schedules, shares)
    return json.loads(json.dumps(file_with_plan(certificate, instance, schedules)))


def test_the_schema_is_one():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("seed", range(6))
def test_what_is_written_fits_it(seed):
    FIT.validate(written(seed))


def fields(part, path=()):
    """Yield all fields of the certificate, with the way to them."""
    for name, inner in part.get("properties", {}).items():
        yield (*path, name), inner
        yield from fields(inner, (*path, name))


@pytest.mark.parametrize(
    "path", [path for path, _ in fields(SCHEMA)], ids=lambda path: ".".join(path)
)
def test_every_field_is_described_and_needed_by_schema_and_checker(path):
    assert dict(fields(SCHEMA))[path]["description"].endswith(".")
    file = copy.deepcopy(FILE)
    part = file
    for step in path[:-1]:
        part = part[step]
    del part[path[-1]]
    assert not FIT.is_valid(file)
    with pytest.raises(ScenarioError):
        told_of(file)


FILE = written(1)
