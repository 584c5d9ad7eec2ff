# SPDX-License-Identifier: MIT
"""The stubs say what the modules have: the same names, and of each function the same parameters, defaults and types."""
import ast
import pathlib
import re
import unittest

import occlude
from occlude import _occlude

try:
    from occlude import _oracle
except ImportError:
    _oracle = None

FOLDER = pathlib.Path(occlude.__file__).parent
SPECIAL = {"__init__", "__len__"}  # all others are those of every object, or repr()


def public(names):
    return {name for name in names if not name.startswith("_") or name in SPECIAL}


def signatures(name, text):
    """What pybind11 writes into the documentation of a function: a signature, or one for each overload."""
    lines = re.findall(rf"^(?:\d+\. )?({name}\(.*\) -> .*)$", text or "", re.MULTILINE)
    return [ast.parse(f"def {line}: ...").body[0] for line in lines if "*args" not in line]


def parameters(function):
    """Name, whether it is for keywords alone, type and default of each, but for self."""
    a = function.args
    defaults = [None] * (len(a.args) - len(a.defaults)) + a.defaults
    pairs = [(arg, False, default) for arg, default in zip(a.args, defaults)]
    pairs += [(arg, True, default) for arg, default in zip(a.kwonlyargs, a.kw_defaults)]
    return [(arg.arg, keyword, arg.annotation, default) for arg, keyword, default in pairs if arg.arg != "self"]


def alternatives(annotation):
    """The types of a union but None; of literals, that of their values."""
    if isinstance(annotation, ast.Subscript) and ast.unparse(annotation.value) in ("Union", "Optional"):
        of = annotation.slice
        return set().union(*map(alternatives, of.elts if isinstance(of, ast.Tuple) else [of]))
    if isinstance(annotation, ast.Subscript) and ast.unparse(annotation.value) == "Literal":
        of = annotation.slice
        values = [e.value for e in (of.elts if isinstance(of, ast.Tuple) else [of])]
        return {type(value).__name__ for value in values if value is not None}
    text = ast.unparse(annotation).replace("occlude._occlude.", "").replace("numpy.ndarray[numpy.", "NDArray[np.")
    return set() if text == "None" else {text.replace("Tuple[", "tuple[").replace("List[", "list[")}


# What a stub may say of these types.
WIDER = {
    "NDArray[np.float64]": {"ArrayLike"},
    "int": {"ObjectId", "OccluderId"},
    "Camera": {"AnyCamera"},
    "MatrixCamera": {"AnyCamera"},
    "ModelFrame": {"AnyFrame"},
    "HeldFrame": {"AnyFrame"},
}


def agree(stub, made):
    of_stub, of_made = alternatives(stub), alternatives(made)
    wider = set().union(*(WIDER.get(type, set()) for type in of_made))
    return of_made == {"object"} or of_stub == of_made or (bool(of_stub) and of_stub <= wider)


class Stubs(unittest.TestCase):
    def check_function(self, stub, name, text):
        made = signatures(name, text)
        self.assertTrue(made, f"{name} has no signature")
        for signature in made:
            ours, theirs = parameters(stub), parameters(signature)
            self.assertEqual([p[:2] for p in ours], [p[:2] for p in theirs], name)
            self.assertTrue(agree(stub.returns, signature.returns), f"what {name} returns")
            for (parameter, _, annotation, default), (_, _, type, value) in zip(ours, theirs):
                what = f"{parameter} of {name}"
                self.assertTrue(agree(annotation, type), what)
                self.assertEqual(default is None, value is None, what)
                if default is not None and ast.unparse(default) != "...":
                    self.assertEqual(ast.literal_eval(default), ast.literal_eval(value), what)

    def check_class(self, stub, made):
        members = {node.name: node for node in stub.body if isinstance(node, ast.FunctionDef)}
        there = public(vars(made))
        if not signatures("__init__", made.__init__.__doc__):
            there.discard("__init__")  # nothing makes it but the library
        self.assertEqual(set(members), there, stub.name)
        for name, member in members.items():
            value = vars(made)[name]
            is_property = any(ast.unparse(d) == "property" for d in member.decorator_list)
            self.assertEqual(is_property, isinstance(value, property), name)
            if not is_property:
                self.check_function(member, name, getattr(made, name).__doc__)
            elif "::" not in value.fget.__doc__:
                returned = ast.parse(value.fget.__doc__.split("->")[1].strip(), mode="eval").body
                types = alternatives(returned)
                self.assertTrue(types <= {"object", "list", "dict"} or alternatives(member.returns) == types, name)

    def check_module(self, module):
        stub = ast.parse((FOLDER / (module.__name__.split(".")[-1] + ".pyi")).read_text())
        nodes = {n.name: n for n in stub.body if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(set(nodes), public(vars(module)))
        for name, node in nodes.items():
            if isinstance(node, ast.ClassDef):
                self.check_class(node, getattr(module, name))
            else:
                self.check_function(node, name, getattr(module, name).__doc__)

    def test_the_module(self):
        self.check_module(_occlude)

    @unittest.skipUnless(_oracle, "the oracle was not built")
    def test_the_oracle(self):
        self.check_module(_oracle)

    def test_the_package(self):
        self.assertTrue((FOLDER / "py.typed").exists())
        self.assertLessEqual(public(vars(_occlude)), set(occlude.__all__))
        for name in occlude.__all__:
            self.assertTrue(hasattr(occlude, name), name)

    def test_that_it_would_notice(self):
        stub = ast.parse("def f(a: int, *, b: float = 1.0, c: ArrayLike = ...) -> None: ...").body[0]
        made = "f(a: int, *, b: float = 1.0, c: numpy.ndarray[numpy.float64] = [0.0]) -> None"
        self.check_function(stub, "f", made)
        for right, wrong in (("a: int", "z: int"), ("a: int", "a: str"), ("*, ", ""), ("= 1.0", "= 2.0"), (": float = 1.0", ": float"),
                             ("-> None", "-> int"), ("*, ", "*, d: int, ")):
            with self.assertRaises(AssertionError, msg=wrong):
                self.check_function(stub, "f", made.replace(right, wrong, 1))


if __name__ == "__main__":
    unittest.main()
