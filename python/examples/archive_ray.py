"""Facts about the programs of an archive, made by all workers of a Ray cluster: one row a program, as Parquet.

    python archive_ray.py FOLDER OUT [--config cnc872c.toml] [--extension nc --extension mpf]

Without a cluster Ray starts workers on this machine. On a cluster say where it is, before or in the environment
(`RAY_ADDRESS=ray://head:10001`), name FOLDER and OUT as all workers see them (`s3://…`, a shared folder), and have the
package on every worker (`runtime_env={"pip": ["cnc872c"]}`).
"""

from __future__ import annotations

import argparse
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pyarrow
import ray
import ray.data

import cnc872c


def facts(batch: pyarrow.Table, config: Mapping[str, Any]) -> pyarrow.Table:
    """The rows of some programs, whose paths and bytes are given. Macrocycles have none."""
    programs = zip(batch["path"].to_pylist(), batch["bytes"].to_pylist())
    rows = [cnc872c.stats(path, text=text, config=config).to_arrow() for path, text in programs]
    return pyarrow.concat_tables(rows)


def main() -> None:
    """Reads the programs, and writes their facts."""
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder")
    arguments.add_argument("out")
    arguments.add_argument("--config", type=Path)
    arguments.add_argument("--extension", action="append")
    given = arguments.parse_args()
    # Workers may not see the file: they get what is in it.
    config = tomllib.loads(given.config.read_text("utf-8")) if given.config else {}
    programs = ray.data.read_binary_files(
        given.folder, include_paths=True, file_extensions=given.extension or ["nc"]
    )
    rows = programs.map_batches(facts, batch_format="pyarrow", batch_size=256, fn_kwargs={"config": config})
    rows.write_parquet(given.out)


if __name__ == "__main__":
    main()
