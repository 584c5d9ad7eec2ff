# SPDX-License-Identifier: MIT
"""The size of a PNG of eight bits RGBA, or one of its pixels. Usage: png_pixels.py FILE [X Y]"""
import struct
import sys
import zlib

PIXEL = 4


def paeth(left, above, corner):
    guess = left + above - corner
    return min((left, above, corner), key=lambda value: abs(guess - value))


def rows_of(data, width):
    """The bytes of each row, as the PNG specification (third edition, 9.2) undoes the filters."""
    last = bytes(width * PIXEL)
    for at in range(0, len(data), width * PIXEL + 1):
        row = bytearray(data[at + 1:at + 1 + width * PIXEL])
        for i, value in enumerate(row):
            left, corner = (row[i - PIXEL], last[i - PIXEL]) if i >= PIXEL else (0, 0)
            guesses = (0, left, last[i], (left + last[i]) // 2, paeth(left, last[i], corner))
            row[i] = (value + guesses[data[at]]) % 256
        yield row
        last = row


def main(file, *place):
    with open(file, "rb") as f:
        data = f.read()
    at, pixels = 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        content = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, bits, colours = struct.unpack_from(">IIBB", content)
            assert (bits, colours) == (8, 6), "not eight bits RGBA"
        if kind == b"IDAT":
            pixels += content
        at += 12 + size
    if place:
        x, y = map(int, place)
        row = list(rows_of(zlib.decompress(pixels), width))[y]
        print(*row[PIXEL * x:PIXEL * (x + 1)])
    else:
        print(width, height)


main(*sys.argv[1:])
