"""The type stubs say what the module has: the same names, and of each function the same arguments."""

import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys

import pytest

import angiopose

stub = pathlib.Path(angiopose.__file__).with_suffix(".pyi")
examples = sorted((pathlib.Path(os.environ["ANGIOPOSE_ROOT"]) / "resources" / "examples" / "python").glob("*.py"))


def split(arguments):
    """At the commas that are in no brackets or quotes."""
    depth, quoted, parts = 0, False, [""]
    for letter in arguments:
        quoted ^= letter in "'\""
        depth += (letter in "([{<") - (letter in ")]}>")
        if letter == "," and depth == 0 and not quoted:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def documented(doc, name):
    """Of every overload that pybind11 documents: arguments as (name, has a default)."""
    found = []
    for arguments in re.findall(rf"^(?:\d+\. )?{name}\((.*)\) -> ", doc, re.MULTILINE):
        parts = [part for part in split(arguments) if part not in ("*", "/") and not part.startswith("self:")]
        found.append([(part.split(":")[0].lstrip("*"), "=" in part) for part in parts])
    return found


def stubbed(node):
    arguments = node.args
    positional = arguments.posonlyargs + arguments.args
    first = len(positional) - len(arguments.defaults)
    listed = [(each.arg, i >= first) for i, each in enumerate(positional) if each.arg != "self"]
    listed += [(each.arg, value is not None) for each, value in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    if arguments.kwarg:
        listed.append(("kwargs", False))
    return listed


def definitions():
    """(what to ask for its doc, its name, all definitions of it in the stub)"""
    tree = ast.parse(stub.read_text())
    groups = {}
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            groups.setdefault((None, node.name), []).append(node)
        if isinstance(node, ast.ClassDef):
            for member in node.body:
                isMethod = isinstance(member, ast.FunctionDef) and not member.decorator_list
                if isMethod and (not member.name.startswith("__") or member.name == "__init__"):
                    groups.setdefault((node.name, member.name), []).append(member)
    return groups


def test_arguments_are_those_of_the_module():
    checked = 0
    for (owner, name), nodes in definitions().items():
        holder = getattr(angiopose, owner) if owner else angiopose
        doc = getattr(holder, name).__doc__ or ""
        module = documented(doc, name)
        assert module, f"{owner or ''}.{name}: no signature in\n{doc}"
        assert module == [stubbed(node) for node in nodes], f"{owner or ''}.{name}"
        checked += 1
    assert checked > 40


def test_names_are_those_of_the_module():
    tree = ast.parse(stub.read_text())
    public = {name for name in dir(angiopose) if not name.startswith("_")}
    known = {node.name for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert known == public
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and node.name not in ("Error", "Stopped"):
            members = {m.name for m in node.body if isinstance(m, ast.FunctionDef)}
            members |= {m.target.id for m in node.body if isinstance(m, ast.AnnAssign)}
            has = {name for name in vars(getattr(angiopose, node.name)) if not name.startswith("__")}
            assert {name for name in members if not name.startswith("__")} == has, node.name


def test_everything_public_is_documented():
    undocumented = [
        name for name, value in vars(angiopose).items()
        if not name.startswith("_") and not inspect.ismodule(value) and not (value.__doc__ or "").strip()
    ]
    for name, kind in vars(angiopose).items():
        if inspect.isclass(kind) and not name.startswith("_") and not hasattr(kind, "__members__"):
            undocumented += [
                f"{name}.{member}" for member, value in vars(kind).items()
                if isinstance(value, property) and not (value.__doc__ or "").strip()
            ]
    assert undocumented == []


@pytest.mark.parametrize("example", examples, ids=lambda path: path.stem)
def test_the_stubs_know_what_the_examples_use(example, tmp_path):
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path), str(example)],
        capture_output=True, text=True, env={**os.environ, "MYPYPATH": str(stub.parent.parent)},
    )
    assert done.returncode == 0, done.stdout + done.stderr
