"""Tables of a study as TOML text."""

import json
import tomllib

from tests.support.small import TEXT

CLUSTER = {  # every key of the table [cluster]
    "where": "slurm",
    "queue": "normal",
    "cores": 4,
    "memory": "8GB",
    "walltime": "02:00:00",
    "account": "friction",
    "prologue": ["module load python"],
    "directives": ["--qos=long"],
    "leave_out": ["--mem", "--no-requeue"],
    "jobs": 25,
    "interface": "ib0",
    "log_folder": "logs",
    "patience": 86400,
    "tls_ca_file": "ca.pem",
    "tls_cert": "me.pem",
    "tls_key": "me.key",
}


def toml(value):
    """Return ``value`` as inline TOML."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(toml(entry) for entry in value) + "]"
    if isinstance(value, bool | str):
        return json.dumps(value)
    if isinstance(value, int | float):
        return repr(value)
    return value.isoformat()


def document(tables):
    """Return tables as TOML text."""
    return "\n".join(f"{json.dumps(key)} = {toml(value)}" for key, value in tables.items())


def without(*places):
    """Return the text of the small study without some settings, each given as TABLE.KEY."""
    tables = tomllib.loads(TEXT)
    for where in places:
        table, key = where.split(".")
        del tables[table][key]
    return document(tables)
