"""Arrays of Python objects as numpy stores them, opened without running what is in them.

Such a file is a header and a pickle, and a pickle may name any function to be called. Here it may
name what builds plain containers, numbers, texts and numpy's own arrays, and nothing else.
"""

from __future__ import annotations

import io
import pickle
from pathlib import Path
from typing import Any

from ...errors import ScenarioError

__all__ = ["plain_objects"]

MOST_BYTES = 1 << 22
"""Larger files are none of these."""

ALLOWED = {
    ("numpy", "dtype"), ("numpy", "ndarray"),
    *(
        (f"{root}.{module}", name)
        for root in ("numpy.core", "numpy._core")
        for module, name in (
            ("multiarray", "_reconstruct"), ("multiarray", "scalar"),
            ("numeric", "_frombuffer"),
        )
    ),
    ("_codecs", "encode"),
    ("builtins", "list"), ("builtins", "tuple"), ("builtins", "dict"), ("builtins", "set"),
    ("builtins", "int"), ("builtins", "float"), ("builtins", "str"), ("builtins", "bool"),
    ("collections", "OrderedDict"),
}  # fmt: skip


class _Plain(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        # What Python 2 called them.
        if (module, name) in ALLOWED or (module == "__builtin__" and ("builtins", name) in ALLOWED):
            return super().find_class(module, name)
        raise pickle.UnpicklingError(f"it names {module}.{name}")


def plain_objects(path: Path) -> Any:
    """Return what an array file of plain objects holds.

    Parameters
    ----------
    path : Path
        A file that `numpy.save` wrote of dictionaries, lists and numbers.

    Returns
    -------
    object
        The object of an array of none; else lists of its items.

    Raises
    ------
    ScenarioError
        Any other file, or one that names more than plain data.
    """
    import numpy as np
    from numpy.lib import format as npy

    try:
        data = path.read_bytes() if path.stat().st_size <= MOST_BYTES else b""
        stream = io.BytesIO(data)
        version = npy.read_magic(stream)
        read = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
        shape, _, dtype = read(stream)
        if not dtype.hasobject:
            return np.load(io.BytesIO(data), allow_pickle=False).tolist()
        found = _Plain(stream, encoding="latin1").load()
        return found.item() if shape == () and isinstance(found, np.ndarray) else _listed(found)
    except OSError as error:
        raise ScenarioError(f"{path}: cannot be read ({error.strerror})") from error
    except Exception as error:  # pickles of other programs fail in any way
        raise ScenarioError(
            f"{path}: is no array of plain numbers ({str(error)[:80]}); take the published file"
        ) from error


def _listed(found: Any) -> Any:
    return found.tolist() if hasattr(found, "tolist") else found
