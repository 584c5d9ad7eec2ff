# SPDX-License-Identifier: MIT
"""Prints the reference of the Python module as Markdown, made of its docstrings.
Usage: PYTHONPATH=FOLDER_OF_THE_MODULE python3 python_reference.py
"""
import enum
import inspect
import re

import occlude


SIGNATURE = re.compile(r"^(?:\d+\. )?(\w+\(.*\)(?: -> .*)?)$", re.MULTILINE)


def text_of(thing):
    """The docstring, with the signatures that pybind11 writes into it as code."""
    text = inspect.cleandoc(thing.__doc__ or "").replace("occlude._occlude.", "")
    text = re.sub(r"^\w+\(\*args, \*\*kwargs\)\nOverloaded function\.\n", "", text)
    text = re.sub(r"__init__\(self: (\w+)(, )?", r"\1(", text)
    text = re.sub(r"\(self: \w+(, )?", "(", text)
    return SIGNATURE.sub(r"```text\n\1\n```", text)


def names_of(thing):
    made = "__init__" if "self: " in (thing.__init__.__doc__ or "") else None  # else Python cannot make one
    return [name for name in thing.__dict__ if not name.startswith("_") or name == made]


def is_enumeration(thing):
    return inspect.isclass(thing) and (issubclass(thing, enum.Enum) or hasattr(thing, "__members__"))


def print_class(name, thing):
    print(f"## {name}\n\n{text_of(thing)}\n")
    if is_enumeration(thing):
        print("\n".join(f"- `{member}`" for member in thing.__members__), "\n")
        return
    for member in names_of(thing):
        value = thing.__dict__[member]
        if callable(value) or isinstance(value, (property, staticmethod, classmethod)):
            title = f"{name}()" if member == "__init__" else f"{name}.{member}"
            print(f"### {title}\n\n{text_of(getattr(thing, member))}\n")


def main():
    print("# Python\n\nThe module `occlude`. [The guide](python.md) shows it at work.\n")
    public = {name: getattr(occlude, name) for name in dir(occlude) if not name.startswith("_")}
    public = {name: thing for name, thing in public.items() if getattr(thing, "__module__", "").startswith("occlude")}
    for name, thing in sorted(public.items(), key=lambda item: (not inspect.isclass(item[1]), item[0])):
        if inspect.isclass(thing):
            print_class(name, thing)
        elif callable(thing):
            print(f"## {name}()\n\n{text_of(thing)}\n")


main()
