# SPDX-License-Identifier: MIT
"""What must hold of every end of a command, whatever is put to it."""
import signal


def fault(code, seconds, errors, out=b""):
    """What is wrong with an end, or nothing. `code` is the exit code (negative: signal; None: no end within `seconds`)."""
    if code is None:
        return f"no end within {seconds} s"
    if code < 0:
        return f"ended by {signal.Signals(-code).name}"
    if code not in (0, 1, 2):
        return f"exit code {code}"
    if any(byte < 32 and byte != 10 or byte == 127 for byte in out + errors):
        return "control characters"
    if len(errors) > 10_000:
        return f"{len(errors)} bytes on stderr"
    return None
