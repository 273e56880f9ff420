"""Sources with one number or operator changed, to see whether a test would notice.

Numbers become one more and one less; comparisons lose or gain their bound; sums become
differences, "and" becomes "or", the smallest becomes the largest, yes becomes no. What only says
something (texts, types, decorators) stays.
"""

from __future__ import annotations

import ast
import inspect
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from types import CodeType, ModuleType

__all__ = ["Mutant", "mutants_of"]

OTHER: dict[type[ast.AST], type[ast.AST]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Add, ast.FloorDiv: ast.Mult,
    ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip
NAMES = {"min": "max", "max": "min", "any": "all", "all": "any"}


@dataclass(frozen=True)
class Mutant:
    """A source with one change, there until the next one is asked for."""

    name: str
    tree: ast.Module

    def code(self) -> CodeType:
        ast.fix_missing_locations(self.tree)
        return compile(self.tree, "<mutant>", "exec")


Change = tuple[ast.AST, Callable[[], None], Callable[[], None]]


def mutants_of(module: ModuleType, inside: str = "") -> Iterator[Mutant]:
    """Yield all mutants of a module, or of one of its functions."""
    tree = ast.parse(inspect.getsource(module))
    short = module.__name__.rpartition(".")[2]
    root: ast.AST = tree
    if inside:
        root = next(node for node in tree.body if getattr(node, "name", "") == inside)
    for node, owner, where in list(_nodes(root, "", None)):
        for change, undo in _changes(node):
            before = ast.unparse(owner)
            change()
            name = f"{short}.{where}: {before} => {ast.unparse(owner)}"
            yield Mutant(name, tree)
            undo()


def _nodes(
    node: ast.AST, where: str, owner: ast.AST | None
) -> Iterator[tuple[ast.AST, ast.AST, str]]:
    """Yield what may change, the expression it stands in, and the function."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        where = f"{where}.{node.name}".strip(".")
    if isinstance(node, ast.JoinedStr) or (isinstance(node, ast.keyword) and node.arg == "strict"):
        return
    if isinstance(node, ast.Compare | ast.BinOp | ast.BoolOp | ast.Call | ast.UnaryOp | ast.Tuple):
        owner = node
    if owner is None and isinstance(node, ast.stmt) and not hasattr(node, "body"):
        owner = node
    yield node, owner or node, where
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list", "slice") and not isinstance(
            node, ast.Subscript
        ):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST):
                yield from _nodes(child, where, None if hasattr(node, "body") else owner)


def _changes(node: ast.AST) -> Iterator[tuple[Callable[[], None], Callable[[], None]]]:
    if isinstance(node, ast.Constant) and type(node.value) in (int, bool):
        old = node.value
        for new in [not old] if isinstance(old, bool) else [old + 1, old - 1]:
            yield _setting(node, "value", new)
    elif isinstance(node, ast.Compare):
        for k, operator in enumerate(node.ops):
            yield _item(node.ops, k, OTHER[type(operator)]())
    elif (
        (isinstance(node, ast.BinOp) and type(node.op) in OTHER and not _is_type(node))
        or isinstance(node, ast.BoolOp)
        or (isinstance(node, ast.AugAssign) and type(node.op) in OTHER)
    ):
        yield _setting(node, "op", OTHER[type(node.op)]())
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield _setting(node, "op", ast.UAdd())
    elif isinstance(node, ast.Name) and node.id in NAMES:
        yield _setting(node, "id", NAMES[node.id])


def _is_type(node: ast.BinOp) -> bool:
    return isinstance(node.op, ast.BitOr)


def _setting(
    node: ast.AST, name: str, new: object
) -> tuple[Callable[[], None], Callable[[], None]]:
    old = getattr(node, name)
    return lambda: setattr(node, name, new), lambda: setattr(node, name, old)


def _item(
    items: list[ast.cmpop], k: int, new: ast.AST
) -> tuple[Callable[[], None], Callable[[], None]]:
    old = items[k]
    return lambda: items.__setitem__(k, new), lambda: items.__setitem__(k, old)  # type: ignore[call-overload]
