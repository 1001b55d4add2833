#!/usr/bin/env python3
"""Prints a page of the manual about the library, as Markdown.

Usage: manual_reference.py cpp HEADER…    what the public headers declare, with their comments
       manual_reference.py python STUB    the module's classes and functions (its .pyi)
"""
import ast
import re
import sys
from pathlib import Path


def entities(lines):
    """Yields (comment lines, code lines) of everything that stands in the namespace itself."""
    comment, code, depth = [], [], 0
    for line in lines:
        text = line.strip()
        if not code and text.startswith("///") and not text.startswith("///<"):
            comment.append(text[3:].strip())
            continue
        if not code and (not text or text == "}" or text.startswith(("#", "//", "namespace", "}   // namespace"))):
            comment = [] if not text else comment
            continue
        code.append(line.rstrip())
        bare = text.split("//")[0].rstrip()
        depth += bare.count("{") - bare.count("}")
        if depth == 0 and bare.endswith((";", "}")):
            yield comment, code
            comment, code = [], []


def name_of(code):
    """The heading of a declaration: its type's or function's name."""
    head = " ".join(code)
    kind = re.match(r"\s*(?:template <[^>]*> )?(struct|class|enum class|enum) (?:ANGIOPOSE_EXPORT )?(\w+)", head)
    if kind:
        return kind.group(2)
    call = re.search(r"(operator\S+|\w+)\s*\(", head.replace("ANGIOPOSE_EXPORT ", ""))
    alias = re.match(r"\s*using (\w+)", head)
    return alias.group(1) if alias else call.group(1) if call else None


def cpp_page(headers):
    out = ["# C++ reference", "",
           "What `#include <angiopose/angiopose.h>` declares, header by header. Lengths are mm or px, as names and comments"
           " say; angles are degrees; frames and conventions stand in [Coordinates](coordinates.md).", ""]
    for header in sorted(headers):
        found = [(comment, code) for comment, code in entities(Path(header).read_text().splitlines())
                 if not re.fullmatch(r"\s*(struct|class) (?:ANGIOPOSE_EXPORT )?\w+;", " ".join(code))]
        if not found:
            continue
        out += [f"## angiopose/{Path(header).name}", ""]
        for comment, code in found:
            out += [f"### {name_of(code)}", ""]
            out += [" ".join(comment), ""] if comment else []
            out += ["```cpp", *[line.replace("ANGIOPOSE_EXPORT ", "") for line in code], "```", ""]
    return out


def signature(function):
    arguments = ast.unparse(function.args)
    result = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    return f"def {function.name}({arguments}){result}"


def class_lines(node):
    lines = [f"class {node.name}" + (f"({', '.join(ast.unparse(base) for base in node.bases)})" if node.bases else "")
             + ":"]
    for part in node.body:
        if isinstance(part, ast.FunctionDef):
            is_property = any(ast.unparse(mark) == "property" for mark in part.decorator_list)
            is_setter = any(ast.unparse(mark).endswith(".setter") for mark in part.decorator_list)
            if is_property:
                lines.append(f"    {part.name}: {ast.unparse(part.returns)}")
            elif not is_setter:
                lines.append("    " + signature(part))
        elif isinstance(part, ast.AnnAssign):
            lines.append(f"    {ast.unparse(part)}")
    return lines if len(lines) > 1 else [lines[0] + " ..."]


def python_page(stub):
    tree = ast.parse(Path(stub).read_text())
    out = ["# Python reference", "",
           "`import angiopose`. Names are those of [C++](cpp.md), letter for letter, and mean the same; what C++ asks with"
           " `name()` and sets with `setName(value)` is an attribute. `help(angiopose)` shows the same in Python.", "",
           "## Functions", ""]
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    out += ["```python", *[signature(node) for node in functions], "```", "", "## Classes", ""]
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            out += [f"### {node.name}", "", "```python", *class_lines(node), "```", ""]
    return out


def main(arguments):
    if len(arguments) < 2 or arguments[0] not in ("cpp", "python"):
        sys.exit(__doc__)
    page = cpp_page(arguments[1:]) if arguments[0] == "cpp" else python_page(arguments[1])
    print("\n".join(page))


main(sys.argv[1:])
