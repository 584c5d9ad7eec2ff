# SPDX-License-Identifier: MIT
"""Reads the visible sets of `occlude bake` (docs/bake.md). Needs Python 3.10 and nothing else."""
import mmap
import struct
from bisect import bisect_left
from itertools import accumulate


class VisibleSets:
    """A file, mapped. Sets are sets of numbers. A cell that there is not raises IndexError, what is no set ValueError."""

    def __init__(self, file):
        """Reads the header alone."""
        with open(file, "rb") as f:
            self.data = mmap.mmap(f.fileno(), 0, access=mmap.ACCESS_READ)
        self._require(len(self.data) >= 64 and self.data[:8] == b"OCCLPVS1")
        size, self.model, self.cells, self.items, self.widest = struct.unpack_from("<QQIId", self.data, 8)
        self._require(size == len(self.data) and 64 + self.cells * 64 + 8 <= size)

    def check(self):
        """Reads all. Raises ValueError if any byte is damaged."""
        value = 0xCBF29CE484222325
        for byte in self.data[:40] + self.data[48:]:
            value = (value ^ byte) * 0x100000001B3 % 2**64
        self._require((value,) == struct.unpack_from("<Q", self.data, 40))

    def box(self, cell):
        """The least corner and the greatest: six numbers."""
        return struct.unpack_from("<6d", self.data, 64 + self._known(cell) * 48)

    def cell_at(self, eye):
        """The first cell that holds the eye, or None."""
        first = bisect_left(range(self.cells), eye[0] - self.widest, key=lambda cell: self.box(cell)[0])
        for cell in range(first, self.cells):
            box = self.box(cell)
            if box[0] > eye[0]:
                return None
            if all(box[i] <= eye[i] <= box[i + 3] for i in range(3)):
                return cell
        return None

    def visible(self, cell, other=None):
        """The items that may be seen from somewhere in the cell: all others are hidden from everywhere in it. With another
        cell, whether something of that one may be seen."""
        return self._set(0, cell, self.items) if other is None else self._known(other) in self.visible_cells(cell)

    def visible_cells(self, cell):
        """The cells of which something may be seen from somewhere in this one."""
        return self._set(self.cells, cell, self.cells)

    def _set(self, first, cell, size):
        changes, back = set(), 0
        for others in range(9):  # eight at most
            cell = self._known(cell) - back
            self._require(cell >= 0)
            back, *steps = self._numbers(first + cell)
            ends = list(accumulate(steps))
            self._require(len(ends) % 2 == 0 and all(end <= size for end in ends[-1:]))
            for end in ends:
                changes ^= {end}
            if back == 0:
                ends = iter(sorted(changes))
                return {i for begin, end in zip(ends, ends) for i in range(begin, end)}
        self._require(False)

    def _numbers(self, number):
        place, end = struct.unpack_from("<2Q", self.data, 64 + self.cells * 48 + number * 8)
        self._require(place < end <= len(self.data) and self.data[end - 1] < 128)
        value = shift = 0
        for byte in self.data[place:end]:
            value, shift = value | byte % 128 << shift, shift + 7
            self._require(shift <= 35)
            if byte < 128:
                yield value
                value = shift = 0

    def _known(self, cell):
        if not 0 <= cell < self.cells:
            raise IndexError("no such cell")
        return cell

    @staticmethod
    def _require(holds):
        if not holds:
            raise ValueError("no visible sets, or damaged")
