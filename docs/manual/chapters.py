"""Turns the chapters of medax.h into topics of Doxygen, and the comment above macros into that of each; line for line, so that warnings name the right lines.

usage: chapters.py HEADER"""

import re
import sys

BEGIN = re.compile(r"/\* ---- (\d+)\. (.+?) -+$")
PLAIN = re.compile(r"/\* (.+) \*/$")


def main():
    in_topic = in_title = in_macro = False
    about_macros = ""
    for line in open(sys.argv[1], encoding="utf-8"):
        line = line.rstrip("\n")
        if found := BEGIN.match(line):
            line = f"/** \\defgroup chapter_{int(found[1]):02} {found[1]}. {found[2]}"
            if in_topic:
                line = "/** \\} */ " + line
            in_topic = in_title = True
        elif in_title and line == " */":
            line = " * \\{ */"
            in_title = False
        elif found := PLAIN.match(line):
            about_macros = found[1]
        elif line.startswith("#define MEDAX_") and about_macros or in_macro:
            in_macro = line.endswith("\\")
            if not in_macro:
                line += f" /**< {about_macros} */"
        elif not line.startswith("#"):
            about_macros = ""
        print(line)
    if in_topic:
        print("/** \\} */")


if __name__ == "__main__":
    main()
