# SPDX-License-Identifier: MIT
"""What may be seen from an eye, by the visible sets of `occlude bake` (docs/bake.md).

Usage: python3 visible_sets.py FILE X Y Z
"""
import mmap
import struct
import sys
from bisect import bisect_left


class VisibleSets:
    """A file, mapped. Sets are sets of numbers."""

    HEADER, BOX = 64, 48

    def __init__(self, file):
        with open(file, "rb") as f:
            self.data = mmap.mmap(f.fileno(), 0, access=mmap.ACCESS_READ)
        size = len(self.data)
        if size < self.HEADER or self.data[:8] != b"OCCLPVS1":
            raise ValueError(f"{file}: no visible sets")
        said, self.model, self.cells, self.items, self.widest = struct.unpack_from("<QQIId", self.data, 8)
        if said != size:
            raise ValueError(f"{file}: cut off")

    def box(self, cell):
        return struct.unpack_from("<6d", self.data, self.HEADER + cell * self.BOX)

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

    def visible(self, cell):
        """The items that may be seen from somewhere in the cell: all others are hidden from everywhere in it."""
        return self._set(cell)

    def visible_cells(self, cell):
        """The cells of which something may be seen from somewhere in this one."""
        return self._set(self.cells + cell)

    def _set(self, number):
        changes = set()
        back = 1
        while back:
            back, *steps = self._numbers(number)
            at = 0
            for step in steps:
                at += step
                changes ^= {at}
            number -= back
        ends = iter(sorted(changes))
        return {i for begin, end in zip(ends, ends) for i in range(begin, end)}

    def _numbers(self, number):
        place, end = struct.unpack_from("<2Q", self.data, self.HEADER + self.cells * self.BOX + number * 8)
        value = shift = 0
        for byte in self.data[place:end]:
            value |= byte % 128 << shift
            shift += 7
            if byte < 128:
                yield value
                value = shift = 0


if __name__ == "__main__":
    sets = VisibleSets(sys.argv[1])
    cell = sets.cell_at([float(number) for number in sys.argv[2:5]])
    if cell is None:
        print("in no cell")
    else:
        print("cell", cell)
        print("items", *sorted(sets.visible(cell)))
        print("cells", *sorted(sets.visible_cells(cell)))
