"""Files that appear whole or not at all, alone or several together; what was there stays till then.

A file is written as a draft in a folder of its own beside its place, as some writers keep a
journal beside their file. When all is written, drafts are brought to the disk and moved into place.
Whatever ends the work before that, an error, a full disk or an interrupt, leaves nothing behind:
no draft, and no folder that was made for it.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path

from .errors import PlatoonError, ScenarioError
from .interrupts import held_back
from .leftovers import DRAFT, forget, make_folder, remove
from .output_paths import checked_file, checked_folder

__all__ = ["all_or_none", "filled_folder", "whole_file"]


@dataclass(frozen=True, slots=True)
class _Move:
    draft: Path
    target: Path
    named: Path
    refusal: type[PlatoonError]


class _Batch:
    """Drafts that are moved together, and the folders made for them."""

    def __init__(self) -> None:
        self.moves: list[_Move] = []
        self.drafts: dict[Path, Path] = {}
        """Folders of drafts, each with the folder that it stands for."""
        self.made: list[Path] = []

    def draft_folder(self, place: Path, named: Path) -> Path:
        folder = place / f"{DRAFT}{os.urandom(8).hex()}"
        self.drafts[folder] = named
        make_folder(folder, 0o700)
        return folder

    def make_missing(self, folder: Path) -> None:
        """Make a folder with its parents, as far as they are not there."""
        missing = [place for place in (folder, *folder.parents) if not place.exists()]
        for place in reversed(missing):
            try:
                make_folder(place)
            except FileExistsError:
                if not place.is_dir():  # made by another process since
                    raise
            else:
                self.made.append(place)

    def place(self) -> None:
        """Move all drafts into place; if one cannot be, put back what the others replaced."""
        done: list[tuple[_Move, Path | None]] = []
        try:
            for move in self.moves:
                checked_file(move.target, move.refusal)  # somebody may have been quicker
                before = _kept(move) if len(self.moves) > 1 else None
                try:
                    move.draft.replace(move.target)
                except OSError as error:
                    raise _refused(move.named, move.refusal, error) from error
                done.append((move, before))
        except BaseException:
            for move, before in reversed(done):
                with suppress(OSError):
                    before.replace(move.target) if before else move.target.unlink()
            raise
        for folder in self.made:
            forget(folder)
        self.made.clear()

    def clean(self) -> None:
        for folder in (*reversed(self.drafts), *reversed(self.made)):
            remove(folder)


_open: ContextVar[_Batch | None] = ContextVar("_open", default=None)


@contextmanager
def all_or_none() -> Iterator[None]:
    """Move all files written in a block into place at its end, or none if it ends by an error.

    Yields
    ------
    None
        Nothing; `whole_file` and `filled_folder` know that they stand in the block.
    """
    with _batch():
        yield


@contextmanager
def _batch() -> Iterator[_Batch]:
    if (outer := _open.get()) is not None:
        yield outer
        return
    batch = _Batch()
    token = _open.set(batch)
    try:
        yield batch
        with held_back():
            batch.place()
    finally:
        _open.reset(token)
        with held_back():
            batch.clean()


@contextmanager
def whole_file(
    path: str | os.PathLike[str],
    refusal: type[PlatoonError] = ScenarioError,
    *,
    suffixes: Sequence[str] = (),
    synced: bool = True,
) -> Iterator[Path]:
    """Give a place to write a file, and move it to `path` once the block ends without error.

    Folders on the way that are missing are made. Inside `all_or_none` it is moved at the end of
    that. Links are followed: what they lead to is replaced, with its rights kept.

    Parameters
    ----------
    path : path-like
        The file to be.
    refusal : type of PlatoonError
        The error to raise if the file cannot be written.
    suffixes : sequence of str
        Those its format has; the draft has the first, which some writers look at. Without any,
        the draft has that of `path`.
    synced : bool
        Whether to wait until the disk has it; a file that is checked when it is read again can
        do without.

    Yields
    ------
    Path
        Where to write.

    Raises
    ------
    PlatoonError
        Of the class `refusal`: a path that cannot be written to, as `checked_file` says, or a
        write that fails.
    """
    target = checked_file(path, refusal, suffixes)
    named = Path(path)
    with _batch() as batch:
        # A writer that was given a draft writes whole files too, and people know them by its name.
        is_inner = target.parent in batch.drafts
        if is_inner:
            named = batch.drafts[target.parent] / target.name
        try:
            batch.make_missing(target.parent)
            folder = batch.draft_folder(target.parent, named.parent)
        except OSError as error:
            raise _refused(named, refusal, error) from error
        draft = folder / _draft_name(target, suffixes)
        try:
            yield draft
            _take_over_rights(draft, target)
            if is_inner:
                draft.replace(target)
                return
            if synced:
                _bring_to_disk(draft)
        except OSError as error:
            raise _refused(named, refusal, error) from error
        batch.moves.append(_Move(draft, target, named, refusal))


@contextmanager
def filled_folder(
    path: str | os.PathLike[str], refusal: type[PlatoonError] = ScenarioError
) -> Iterator[Path]:
    """Give a folder to write files into, and move them into `path` once the block ends well.

    The folder at `path` is made with its parents, if it is not there; other files in it stay.

    Parameters
    ----------
    path : path-like
        The folder.
    refusal : type of PlatoonError
        The error to raise if it cannot be made, or a file in it cannot be written.

    Yields
    ------
    Path
        Where to write.

    Raises
    ------
    PlatoonError
        Of the class `refusal`: as `checked_folder` says.
    """
    target = checked_folder(path, refusal)
    with _batch() as batch:
        try:
            batch.make_missing(target)
        except OSError as error:
            told = error.strerror or error
            raise refusal(f"{path}: cannot be made ({told}); name another folder") from error
        named = Path(path)
        try:
            draft = batch.draft_folder(target, named)
        except OSError as error:
            raise _refused(named, refusal, error) from error
        yield draft
        for file in sorted(draft.iterdir()):
            if file.name.startswith(DRAFT):
                continue
            final = checked_file(target / file.name, refusal)
            try:
                _take_over_rights(file, final)
                _bring_to_disk(file)
            except OSError as error:
                raise _refused(named / file.name, refusal, error) from error
            batch.moves.append(_Move(file, final, named / file.name, refusal))


def _draft_name(target: Path, suffixes: Sequence[str]) -> str:
    """Return the name of a draft: its file's own, unless a writer would stumble over its suffix."""
    if not suffixes or target.suffix.lower() in suffixes:
        return target.name
    return f"draft{suffixes[0]}"


def _kept(move: _Move) -> Path | None:
    """Return another name of what a move replaces, to put it back; None if nothing is there."""
    if not move.target.exists():
        return None
    before = move.draft.with_name(f"{DRAFT}{os.urandom(8).hex()}")
    try:
        os.link(move.target, before)
    except OSError:  # a file system without links
        move.target.replace(before)
    return before


def _take_over_rights(draft: Path, target: Path) -> None:
    """Give a draft the rights and the owner of the file it replaces."""
    with suppress(FileNotFoundError):
        old, new = target.stat(), draft.stat()
        if (old.st_uid, old.st_gid) != (new.st_uid, new.st_gid) and hasattr(os, "chown"):
            with suppress(PermissionError):
                os.chown(draft, old.st_uid, old.st_gid)
        draft.chmod(stat.S_IMODE(old.st_mode))


def _bring_to_disk(draft: Path) -> None:
    # Some file systems tell only here that there was no room.
    handle = os.open(draft, os.O_RDWR | getattr(os, "O_BINARY", 0))
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _refused(named: Path, refusal: type[PlatoonError], error: OSError) -> PlatoonError:
    told = error.strerror or error
    return refusal(f"{named}: cannot be written ({told}); free it or name another file")
