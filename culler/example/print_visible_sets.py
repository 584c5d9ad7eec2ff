# SPDX-License-Identifier: MIT
"""What may be seen from an eye, by the visible sets of `occlude bake`. Usage: python3 print_visible_sets.py FILE X Y Z"""
import sys

from visible_sets import VisibleSets

try:
    file, *eye = sys.argv[1:]
    if len(eye) != 3:
        raise ValueError("expected FILE X Y Z")
    sets = VisibleSets(file)
    sets.check()
    cell = sets.cell_at([float(number) for number in eye])
    print("in no cell" if cell is None else f"cell {cell}")
    if cell is not None:
        print("items", *sorted(sets.visible(cell)))
        print("cells", *sorted(sets.visible_cells(cell)))
except (OSError, ValueError) as error:
    print(f"{' '.join(sys.argv[1:2])}: {error}", file=sys.stderr)
    sys.exit(2)
