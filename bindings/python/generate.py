# SPDX-License-Identifier: MIT OR Apache-2.0
"""Makes medax/_ffi.py of include/medax.h: `python generate.py` writes it, `python generate.py --check` compares.

The header is regular, since cbindgen makes it, so that a few patterns read it. What none of them
knows is an error, not left out.
"""

import argparse
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
HEADER = HERE.parent.parent / "include" / "medax.h"
MODULE = HERE / "medax" / "_ffi.py"

SCALARS = {
    "double": "f64",
    "float": "f32",
    "uint8_t": "u8",
    "uint32_t": "u32",
    "int32_t": "i32",
    "uint64_t": "u64",
    "int64_t": "i64",
    "size_t": "usize",
    "bool": "boolean",
    "char": "char",
    "medax_status": "i32",
}

HEAD = '''\
# SPDX-License-Identifier: MIT OR Apache-2.0
# Made by generate.py from include/medax.h: do not edit.
"""What medax.h declares, for ctypes.

Pointers to handles and to sized structs keep their types, so that one cannot be passed for another;
arrays are addresses. Every other name is as in the header; enumerations are classes.
"""

import ctypes

from ._choice import Choice

f64, f32 = ctypes.c_double, ctypes.c_float
u8, u32, i32 = ctypes.c_uint8, ctypes.c_uint32, ctypes.c_int32
u64, i64 = ctypes.c_uint64, ctypes.c_int64
usize, boolean, char = ctypes.c_size_t, ctypes.c_bool, ctypes.c_char
text, address = ctypes.c_char_p, ctypes.c_void_p
P = ctypes.POINTER
'''


class Header:
    """The declarations of the header, in its order."""

    def __init__(self, text):
        self.version = tuple(
            int(re.search(rf"#define MEDAX_VERSION_{part} (\d+)", text)[1]) for part in ("MAJOR", "MINOR", "PATCH")
        )
        # Enumerations keep the text above them.
        self.told = {
            name: " ".join(re.sub(r"^\s*\* ?", "", said, flags=re.M).split())
            for said, name in re.findall(r"/\*\*((?:(?!\*/).)*)\*/\s*enum (medax_\w+)", text, flags=re.S)
        }
        text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
        text = re.sub(r"#define MEDAX_VERSION \\\n(.*\\\n)*.*\n", "", text)
        text = re.sub(r"^\s*#.*$", "", text, flags=re.M)
        text = re.sub(r'extern "C" \{|^\}\s*$(?!.*;)', "", text, flags=re.M)
        self.enums, self.handles, self.structs, self.callbacks, self.functions = {}, [], {}, {}, {}

        def enum(match):
            values = re.findall(r"(\w+) = (-?\d+)", match[2])
            self.enums[match[1]] = [(name, int(value)) for name, value in values]
            return ""

        def struct(match):
            fields = [field.strip() for field in match[1].split(";") if field.strip()]
            self.structs[match[2]] = [self.declared(field) for field in fields]
            return ""

        def handle(match):
            self.handles.append(match[1])
            return ""

        def callback(match):
            self.callbacks[match[2]] = (match[1], [self.declared(p) for p in match[3].split(",")])
            return ""

        def function(match):
            parameters = [] if match[3].strip() == "void" else match[3].split(",")
            self.functions[match[2]] = (" ".join(match[1].split()), [self.declared(p) for p in parameters])
            return ""

        text = re.sub(r"enum (medax_\w+)\s*(?::\s*u?int32_t)?\s*\{(.*?)\};", enum, text, flags=re.S)
        text = re.sub(r"typedef (?:enum )?\w+ medax_\w+;", lambda m: "" if "struct" not in m[0] else m[0], text)
        text = re.sub(r"typedef struct \{(.*?)\} (medax_\w+);", struct, text, flags=re.S)
        text = re.sub(r"typedef struct (medax_\w+) \1;", handle, text)
        text = re.sub(r"typedef (\w+) \(\*(medax_\w+)\)\((.*?)\);", callback, text, flags=re.S)
        text = re.sub(r"MEDAX_API\s+([\w\s]+?[\s*]+)(medax_\w+)\((.*?)\);", function, text, flags=re.S)
        rest = text.replace("}", "").split()
        if rest:
            raise SystemExit(f"generate.py: cannot read {' '.join(rest[:12])!r} of the header")

    @staticmethod
    def declared(text):
        """The name, the type and the length of an array, if it is one, of `const double *name` or `double name[3]`."""
        match = re.fullmatch(r"\s*(?:const )?(\w+)\s+(\**)(\w+)(?:\[(\d+)\])?\s*", text)
        if not match:
            raise SystemExit(f"generate.py: cannot read {text!r} of the header")
        base, stars, name, length = match.groups()
        return name, base + stars, length

    def is_sized(self, name):
        return name in self.structs and self.structs[name][0][0] == "struct_size"

    def type(self, name):
        """The ctypes type of a type of C."""
        if name == "char*":
            return "text"
        if name.endswith("*"):
            inner = name[:-1]
            if inner in self.handles or self.is_sized(inner):
                return f"P({inner})"
            if inner.endswith("*") and inner[:-1] in self.handles:
                return f"P(P({inner[:-1]}))"
            return "address"
        if name in SCALARS:
            return SCALARS[name]
        if name in self.structs or name in self.callbacks:
            return name
        raise SystemExit(f"generate.py: no type of ctypes for {name!r}")


def camel(name):
    return "".join(part.capitalize() for part in name.removeprefix("medax_").split("_"))


def generated(header_text):
    header = Header(header_text)
    lines = [HEAD, f"VERSION = {header.version}", "NONE = 0xFFFFFFFF", ""]
    for name, values in header.enums.items():
        lines += ["", f"class {camel(name)}(Choice):", f'    """{header.told[name]}"""', ""]
        prefix = name.upper() + "_"
        lines += [f"    {value.removeprefix(prefix)} = {number}" for value, number in values] + [""]
    for name in header.handles:
        lines += ["", f"class {name}(ctypes.Structure):", "    pass", ""]
    for name, (result, parameters) in header.callbacks.items():
        kinds = ", ".join(header.type(kind) for _, kind, _ in parameters)
        lines += ["", f"{name} = ctypes.CFUNCTYPE({header.type(result)}, {kinds})", ""]
    for name, fields in header.structs.items():
        lines += ["", f"class {name}(ctypes.Structure):", "    _fields_ = ["]
        for field, kind, length in fields:
            type_ = header.type(kind) + (f" * {length}" if length else "")
            lines.append(f'        ("{field}", {type_}),')
        lines += ["    ]", ""]
    lines += ["", "FUNCTIONS = {"]
    for name, (result, parameters) in header.functions.items():
        restype = "None" if result == "void" else header.type(result.removeprefix("const ").replace(" ", ""))
        kinds = "".join(header.type(kind) + ", " for _, kind, _ in parameters)
        kinds = f"({kinds[:-1]})" if len(parameters) == 1 else f"({kinds[:-2]})"
        lines.append(f'    "{name}": ({restype}, {kinds}),')
    lines += ["}", ""]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    text = generated(HEADER.read_text(encoding="utf-8"))
    if not parser.parse_args().check:
        MODULE.write_text(text, encoding="utf-8")
    elif MODULE.read_text(encoding="utf-8") != text:
        sys.exit("medax/_ffi.py is not that of include/medax.h: run python bindings/python/generate.py")


if __name__ == "__main__":
    main()
