#!/usr/bin/env python3
"""Writes odd and broken mesh files into a folder, and manifest.tsv: a file's name and what reading it must come to,
"error" or the number of its faces. The same bytes every time. Standard library only.

usage: make_bad_meshes.py FOLDER
"""
import math
import pathlib
import random
import struct
import sys

ERROR = "error"
CUBE = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
QUADS = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]

BAD_NUMBERS = ["nan", "-nan", "NaN(1)", "inf", "-Infinity", "1e400", "-1e999999999", "abc", "1,5", "0x10", "1.0f", "1e",
               "--1", "+-1", "1.2.3", "1e5e5", "\uff11", ".", "-", "1_000", "#1", "1/2", "\x000", "0\x00", "1d3"]
GOOD_NUMBERS = ["1e-400", "+1", ".5", "5.", "1E3", "-0", "1e39", "000001", "4.9e-324", "1e+2", "0." + "1" * 5000]
BAD_COUNTS = ["-1", "4000000000", "9223372036854775807", "9223372036854775808", "99999999999999999999999", "8.0", "8e0",
              "x", "", "nan", "0x8"]


class Corpus:
    def __init__(self, folder):
        self.folder, self.lines = pathlib.Path(folder), []
        self.folder.mkdir(parents=True, exist_ok=True)

    def add(self, name, content, expected):
        """`expected` is ERROR or the number of faces."""
        data = content if isinstance(content, bytes) else content.encode()
        extension = name.rsplit(".", 1)[1]
        name = f"{len(self.lines):03}-{name}"
        (self.folder / name).write_bytes(data)
        self.lines.append(f"{name}\t{expected}\n")
        assert extension in ("obj", "ply", "off", "stl")

    def finish(self):
        (self.folder / "manifest.tsv").write_text("".join(self.lines))
        print(f"{len(self.lines)} mesh files in {self.folder}")


def rows(values, form="{} {} {}\n"):
    return "".join(form.format(*v) for v in values)


def swapped(text, old, new):
    assert old in text, (old, text)
    return text.replace(old, new, 1)


def write_obj(corpus):
    v = rows(CUBE, "v {} {} {}\n")
    cube = v + "".join("f " + " ".join(str(i + 1) for i in q) + "\n" for q in QUADS)
    add = lambda name, content, expected: corpus.add(name + ".obj", content, expected)
    add("good", cube, 6)
    for name, end in (("crlf", "\r\n"), ("cr", "\r"), ("blank-lines", "\n\n \n\t\n"), ("trailing-blanks", " \t\n")):
        add(name, cube.replace("\n", end), 6)
    for i, bad in enumerate(BAD_NUMBERS):
        add(f"bad-coordinate-{i}", cube + f"v 0 {bad} 0\n", ERROR)
    for i, bad in enumerate(BAD_NUMBERS[:12]):
        add(f"bad-vt-{i}", cube + f"vt 0 {bad}\n", ERROR)
        add(f"bad-vn-{i}", cube + f"vn 0 0 {bad}\n", ERROR)
    for i, good in enumerate(GOOD_NUMBERS):
        add(f"good-coordinate-{i}", cube + f"v 0 {good} 0\nf 1 2 9\n", 7)
    for i, numbers in enumerate(["", "0", "0 0", "0 0 0 1 2", "0 0 0 1 1 1 1 1"]):
        add(f"vertex-with-{len(numbers.split())}-numbers", cube + f"v {numbers}\n", ERROR)
    for i, numbers in enumerate(["0 0 0 1", "0 0 0 1 0 0", "0 0 0 1 0 0 1"]):
        add(f"vertex-with-{len(numbers.split())}-numbers", cube + f"v {numbers}\nf 1 2 9\n", 7)
    lists = cube + "vt 0 0\nvt 1 1\nvn 0 0 1\n"
    for i, bad in enumerate(["0", "9", "-9", "/1", "//1", "1/1/1/1", "a", "1.5", "99999999999999999999", "2147483648",
                             "-9223372036854775809", "4294967297", "1/x", "1//x", "1/3", "1//2", "1/-3", "1/0", "1//0",
                             "1\\2", "1;2", "+1", "\uff11", "1-", "-", "--1", "1/1/1x", "99999999/3", "-50000000//1",
                             "1/99999999999", "0/0/0", "18446744073709551617"]):
        add(f"bad-corner-{i}", lists + f"f 1/1/1 2/2/1 {bad}\n", ERROR)
        add(f"bad-first-corner-{i}", lists + f"f {bad} 1/1/1 2/2/1\n", ERROR)
    for i, good in enumerate(["3", "-8", "3/1", "3//1", "3/2/1", "3/-1/-1", "3/", "3//", "3/1/"]):
        add(f"good-corner-{i}", lists + f"f 1 2 {good}\n", 7)
    for n, corners in enumerate(["", "1", "1 2"]):
        add(f"face-with-{n}-corners", cube + f"f {corners}\n", ERROR)
    for i, key in enumerate([
            "ff", "F", "V", "vx", "f1 2 3", "v1 0 0", "?", "\x00", "\ufeff", "/* c */", "// c", "<html>", "usemat a"
        ]):
        add(f"unknown-statement-{i}", cube + key + "\n", ERROR)
    for i, line in enumerate([
            "s off", "s 1", "l 1 2", "p 1", "vp 0 0", "cstype bezier", "curv 0 1 1 2", "mg 0", "lod 1", "usemtl",
            "usemtl a b", "o", "g", "g a b", "mtllib", "mtllib nowhere.mtl", "# c", "   # c",
            "mtllib ../../../etc/passwd", "mtllib /dev/zero", "mtllib \\\\server\\share\\a.mtl", "o \x00", "# \\",
            "end"
        ]):
        add(f"statement-{i}", line + "\n" + cube, 6)
    add("no-faces", v, ERROR)
    add("empty", "", ERROR)
    add("only-comments", "# a\n\n# b\n", ERROR)
    add("only-a-mark", b"\xef\xbb\xbf", ERROR)
    add("utf-8-mark", b"\xef\xbb\xbf" + cube.encode(), 6)
    add("utf-16", cube.encode("utf-16"), ERROR)
    add("shift-jis-names", b"o \x95\x5c\nusemtl \x94\x5c\n" + cube.encode(), 6)
    add("no-last-line-end", cube[:-1], 6)
    add("cut-in-a-face", cube[:-5], ERROR)
    add("cut-in-a-vertex", cube[:43], ERROR)
    add("continued", cube + "f 1 \\\n2 \\\r\n 3\n", 7)
    add("continued-to-the-end", cube + "f 1 2 3 \\\n", 7)
    add("continued-by-nothing", cube + "f 1 2 3 \\", ERROR)
    add("continued-200000-times", " " * 1_000_000 + "\\\n" * 200_000 + cube, 6)
    add("faces-before-vertices", "f 1 2 3\nf 1 3 4\n" + v, 2)
    add("face-before-vertices-that-never-come", "f 1 2 3\nf 1 3 9\n" + v, ERROR)
    add("negative-before-vertices", "f -1 -2 -3\n" + v, ERROR)
    add("relative-blocks", v + "f -3 -2 -1\n" + v + "f -3 -2 -1\n", 2)
    add("repeated-corners", cube + "f 1 1 2\nf 3 3 3\nf 1 2 1 2\n", 9)
    add("the-same-face-twice", cube + "f 1 4 3 2\n", 7)
    add("three-faces-at-an-edge", cube + "f 1 2 7\nf 2 1 7\nf 1 2 8\n", 9)
    add("zero-area", cube + "v 2 2 2\nf 1 7 9\n", 7)
    add("concave", "v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\nf 1 2 3 4\nf 3 4 1 2\n", 2)
    add("bow-tie", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", 1)
    for exponent in (-320, -40, -20, 20, 38, 300, 307):
        add(f"size-1e{exponent}",
            "".join("v " + " ".join(f"{c}e{exponent}" for c in p) + "\n" for p in CUBE) + cube[len(v):], 6)
    ring = lambda n, r: "".join(f"v {r(i) * math.cos(i * math.tau / n):.9f} {r(i) * math.sin(i * math.tau / n):.9f} 0\n"
                                for i in range(n)) + "f " + " ".join(str(i + 1) for i in range(n)) + "\n"
    add("polygon-of-100000", ring(100000, lambda i: 1), 1)
    add("star-of-20000", ring(20000, lambda i: 1 + i % 2), 1)
    add("comment-of-10-million", "# " + "x" * 10_000_000 + "\n" + cube, 6)
    add("word-of-a-million", cube + "v 0 0 " + "9" * 1_000_000 + "\n", ERROR)
    add("many-groups", cube + "".join(f"g {i}\nf 1 2 3\n" for i in range(5000)), 5006)
    add("too-many-groups", cube + "".join(f"g {i}\nf 1 2 3\n" for i in range(20000)), ERROR)
    add("many-line-ends", "\r" * 1_000_000 + cube, 6)
    add("a-jpeg", b"\xff\xd8\xff\xe0\x00\x10JFIF\x00" + random.randbytes(3000), ERROR)
    add("random", random.randbytes(100_000), ERROR)
    add("a-ply", "ply\nformat ascii 1.0\n", ERROR)


def ply(nv=8, nf=6, form="ascii", vertex="", face="", indices="uchar int"):
    return (f"ply\nformat {form} 1.0\n"
            f"element vertex {nv}\nproperty float x\nproperty float y\nproperty float z\n{vertex}"
            f"element face {nf}\nproperty list {indices} vertex_indices\n{face}end_header\n")


def write_ply_text(corpus):
    v, f = rows(CUBE), rows(QUADS, "4 {} {} {} {}\n")
    good = ply() + v + f
    add = lambda name, content, expected: corpus.add(name + ".ply", content, expected)
    add("good", good, 6)
    for name, end in (("crlf", "\r\n"), ("cr", "\r"), ("blank-lines", "\n\n")):
        add(name, good.replace("\n", end), 6)
    for i, bad in enumerate(BAD_NUMBERS):
        add(f"bad-coordinate-{i}", swapped(good, "\n1 -1 -1", f"\n1 {bad} -1"), ERROR)
    for i, number in enumerate(GOOD_NUMBERS):
        add(f"good-coordinate-{i}", swapped(good, "\n1 -1 -1", f"\n1 {number} -1"), 6)
    for i, bad in enumerate(BAD_COUNTS):
        add(f"bad-vertex-count-{i}", ply(nv=bad) + v + f, ERROR)
        add(f"bad-face-count-{i}", ply(nf=bad) + v + f, ERROR)
    for i, (nv, nf) in enumerate([(7, 6), (9, 6), (8, 5), (8, 7), (0, 6), (8, 0), (0, 0), (1000000, 6), (8, 1000000)]):
        add(f"wrong-counts-{i}", ply(nv=nv, nf=nf) + v + f, ERROR)
    for i, bad in enumerate([
            "4 0 1 2 8", "4 0 1 2 -1", "4 0 1 2", "3 0 1 2 3", "-1 0 1 2", "4000000000 0 1 2", "0", "1 0", "2 0 1",
            "x 0 1 2", "3 0 1 1.5", "3 0 1 nan", "3 0 1 4294967296", "3 0 1 18446744073709551616", "3.0 0 1 2", "",
            "4 0 1 2 3 # c"
        ]):
        add(f"bad-face-{i}", swapped(good, "4 0 3 2 1", bad), ERROR)
    for i, n in enumerate(range(1, len(good), 37)):
        add(f"cut-{i}", good[:n], ERROR)
    for i, types in enumerate([
            "uchar int", "uint8 int32", "char char", "short short", "ushort uint", "int32 uint32", "uint uchar"
        ]):
        add(f"list-types-{i}", ply(indices=types) + v + f, 6)
    for i, types in enumerate([
            "float int", "uchar float", "double double", "uchar", "list int", "uchar long", "int64 int"
        ]):
        add(f"bad-list-types-{i}", ply(indices=types) + v + f, ERROR)
    for i, (old, new) in enumerate([
            ("ply\n", "PLY\n"), ("ply\n", "ply ply\n"), ("ply\n", ""), ("format ascii 1.0\n", ""),
            ("ascii", "ebcdic"), ("1.0", "2.0"), ("ascii 1.0", "ascii"), ("element vertex 8\n", ""),
            ("element face 6\n", ""), ("property float y\n", ""), ("property float y", "property float x"),
            ("float y", "real y"), ("float y", "list uchar float y"), ("float y", "float"),
            ("element face", "element vertex"), ("element face", "element faces"), ("vertex_indices", "indices"),
            ("end_header\n", ""), ("end_header", "end_headers"), ("element vertex", "elements vertex"),
            ("property float x", "float x"), ("element vertex 8", "element vertex 8 8"),
            ("property float x", "property float x y"), ("ply\n", "ply\ncomment c\n" * 2)
        ]):
        add(f"bad-header-{i}", swapped(good, old, new), ERROR)
    many = "".join(f"property float p{i}\n" for i in range(2000))
    add("too-many-properties", ply(vertex=many) + v + f, ERROR)
    add("too-many-elements",
        swapped(good, "end_header", "".join(f"element e{i} 0\n" for i in range(100)) + "end_header"), ERROR)
    add("no-end-of-comments", "ply\n" + "comment c\n" * 200_000, ERROR)
    add("element-without-properties", swapped(good, "end_header", "element nothing 99999999999\nend_header"), 6)
    add("obj-info", swapped(good, "element", "obj_info made by element vertex 99999999\nelement"), 6)
    add("colours",
        ply(vertex="property uchar red\nproperty uchar green\nproperty uchar blue\n") +
        rows(CUBE, "{} {} {} 1 2 3\n") + f, 6)
    add("corner-uv", ply(face="property list uchar float texcoord\n") + v + f.replace("\n", " 8 0 0 1 0 1 1 0 1\n"), 6)
    add("corner-uv-odd",
        ply(face="property list uchar float texcoord\n") + v + f.replace("\n", " 7 0 0 1 0 1 1 0\n"), ERROR)
    add("corner-uv-nan",
        ply(face="property list uchar float texcoord\n") + v + f.replace("\n", " 8 0 0 1 0 1 1 0 nan\n"), ERROR)
    add("normal-nan",
        ply(vertex="property float nx\nproperty float ny\nproperty float nz\n") +
        rows(CUBE, "{} {} {} 0 0 nan\n") + f, ERROR)
    add("other-nan", ply(vertex="property float quality\n") + rows(CUBE, "{} {} {} nan\n") + f, 6)
    add("two-vertices-on-a-line", swapped(good, "-1 -1 -1\n", "-1 -1 -1 "), ERROR)
    add("random", random.randbytes(50_000), ERROR)


def write_ply_bytes(corpus):
    for order, name in (("<", "little"), (">", "big")):
        head = lambda **changes: ply(form=f"binary_{name}_endian", **changes).encode()
        v = b"".join(struct.pack(order + "3f", *p) for p in CUBE)
        f = b"".join(struct.pack(order + "B4i", 4, *q) for q in QUADS)
        good = head() + v + f
        add = lambda what, content, expected: corpus.add(f"{name}-{what}.ply", content, expected)
        add("good", good, 6)
        for i, n in enumerate(range(len(head()) - 5, len(good), 13)):
            add(f"cut-{i}", good[:n], ERROR)
        for i, bad in enumerate([math.nan, math.inf, -math.inf]):
            add(f"bad-coordinate-{i}", head() + v[:40] + struct.pack(order + "f", bad) + v[44:] + f, ERROR)
        for i, bad in enumerate([8, -1, 2**31 - 1, -2**31]):
            add(f"bad-index-{i}", head() + v + struct.pack(order + "B4i", 4, 0, 1, 2, bad) + f[17:], ERROR)
        for i, count in enumerate([0, 1, 2, 255]):
            add(f"bad-length-{i}", head(nf=1) + v + struct.pack(order + "B", count) + f[1:17], ERROR)
        for i, (nv, nf) in enumerate([(7, 6), (9, 6), (8, 5), (8, 7), (4000000000, 6), (8, 4000000000)]):
            add(f"wrong-counts-{i}", head(nv=nv, nf=nf) + v + f, ERROR)
        add("length-of-2-billion", head(nf=1, indices="int int") + v + struct.pack(order + "i", 2**31 - 1) + f, ERROR)
        add("negative-length", head(nf=1, indices="int int") + v + struct.pack(order + "i", -3) + f, ERROR)
        add("skipped-list-of-2-billion",
            head(vertex="property list uint double more\n") + (v[:12] + b"\x7f" * 4) * 8 + f, ERROR)
        add("line-end-behind", good + b"\r\n", 6)
        add("bytes-behind", good + b"\0", ERROR)
        add("the-other-order",
            swapped(good.decode("latin-1"), name, "little" if name == "big" else "big").encode("latin-1"), ERROR)
        add("called-text", swapped(good.decode("latin-1"), f"binary_{name}_endian", "ascii").encode("latin-1"), ERROR)
        add("random", head(nv=1000, nf=1000) + b"\xff" * 20_000, ERROR)


def write_off(corpus):
    v, f = rows(CUBE), rows(QUADS, "4 {} {} {} {}\n")
    good = "OFF\n8 6 12\n" + v + f
    add = lambda name, content, expected: corpus.add(name + ".off", content, expected)
    add("good", good, 6)
    for name, end in (("crlf", "\r\n"), ("cr", "\r"), ("comments", " # c\n# 1 2 3\n\n")):
        add(name, good.replace("\n", end), 6)
    for i, first in enumerate(["OFF 8 6 12\n", "OFF8 6 12\n", "OFF\n8 6\n", "# c\nOFF\n8 6 0\n"]):
        add(f"first-lines-{i}", first + v + f, 6)
    for i, bad in enumerate(BAD_NUMBERS):
        add(f"bad-coordinate-{i}", swapped(good, "\n1 -1 -1", f"\n1 {bad} -1"), ERROR)
    for i, bad in enumerate(BAD_COUNTS):
        add(f"bad-vertex-count-{i}", f"OFF\n{bad} 6 12\n" + v + f, ERROR)
        add(f"bad-face-count-{i}", f"OFF\n8 {bad} 12\n" + v + f, ERROR)
    for i, counts in enumerate(["7 6", "9 6", "8 5", "8 7", "0 6", "8 0", "0 0", "8", "8 6 12 1"]):
        add(f"wrong-counts-{i}", f"OFF\n{counts}\n" + v + f, ERROR)
    for i, word in enumerate(["", "off", "OF", "4OFF", "nOFF", "OFF BINARY", "XOFF", "NCOFF", "OFFF", "{ OFF", "ply"]):
        add(f"bad-keyword-{i}", swapped(good, "OFF", word), ERROR)
    for i, (word, more) in enumerate([
            ("NOFF", " 0 0 1"), ("COFF", " 1 0 0"), ("COFF", " 255 0 0 255"), ("STOFF", " 0 1"),
            ("CNOFF", " 0 0 1 1 0 0 1"), ("STCNOFF", " 0 0 1 1 0 0 1 0 1")
        ]):
        text = word + "\n8 6 12\n" + v.replace("\n", more + "\n") + f
        add(f"keyword-{i}", text, 6)
        add(f"keyword-without-values-{i}", swapped(good, "OFF", word), ERROR)
        add(f"values-without-keyword-{i}", swapped(text, word, "OFF"), ERROR)
    for i, bad in enumerate(["4 0 1 2 8", "4 0 1 2 -1", "4 0 1 2", "-1 0 1 2", "4000000000 0 1 2", "0", "1 0", "2 0 1",
                             "x 0 1 2", "3 0 1 1.5", "3 0 1 2 255 0", "3 0 1 2 1 2 3 4 5", "3 0 1 2 red"]):
        add(f"bad-face-{i}", swapped(good, "4 0 3 2 1", bad), ERROR)
    for i, colour in enumerate(["7", "255 0 0", "1 0 0 .5"]):
        add(f"face-colour-{i}", swapped(good, "4 0 3 2 1", "4 0 3 2 1 " + colour), 6)
    for i, n in enumerate(range(0, len(good), 11)):
        add(f"cut-{i}", good[:n], ERROR)
    add("random", b"OFF\n" + random.randbytes(50_000), ERROR)
    add("binary", b"OFF BINARY\n" + struct.pack(">3I", 0xffffffff, 0xffffffff, 0), ERROR)


def write_stl(corpus):
    triangles = [[CUBE[q[i]] for i in t] for q in QUADS for t in ((0, 1, 2), (0, 2, 3))]
    facet = lambda t: struct.pack("<12fH", 0, 0, 0, *t[0], *t[1], *t[2], 0)
    body = b"".join(facet(t) for t in triangles)
    binary = lambda n=12, head=b"binary": head.ljust(80) + struct.pack("<I", n) + body
    text_facet = lambda t: "facet normal 0 0 0\nouter loop\n" + rows(t, "vertex {} {} {}\n") + "endloop\nendfacet\n"
    text = "solid cube\n" + "".join(text_facet(t) for t in triangles) + "endsolid cube\n"
    add = lambda name, content, expected: corpus.add(name + ".stl", content, expected)
    add("binary", binary(), 12)
    add("binary-that-begins-with-solid", binary(head=b"solid exported"), 12)
    add("binary-with-a-tail", binary() + b"\0" * 7, 12)
    for i, n in enumerate([0, 1, 11, 13, 1000000, 2**31, 2**32 - 1]):
        add(f"binary-wrong-count-{i}", binary(n), ERROR)
    for i, n in enumerate([0, 1, 79, 80, 83, 84, 100, 134, 600, 683]):
        add(f"binary-cut-{i}", binary()[:n], ERROR)
    for i, bad in enumerate([math.nan, math.inf, -math.inf]):
        data = bytearray(binary())
        struct.pack_into("<f", data, 84 + 50 * 5 + 12 + 4 * i, bad)
        add(f"binary-bad-coordinate-{i}", bytes(data), ERROR)
    add("binary-all-at-one-place", b"x" * 80 + struct.pack("<I", 10) + bytes(500), 10)
    add("text", text, 12)
    for name, changed in (
            ("crlf", text.replace("\n", "\r\n")), ("cr", text.replace("\n", "\r")), ("upper", text.upper()),
            ("indented", text.replace("\n", "\n\t  ")), ("unnamed", text.replace(" cube", "")),
            ("blank-lines", text.replace("\n", "\n\n"))
        ):
        add("text-" + name, changed, 12)
    add("text-two-solids", text + text, 24)
    add("text-nan-normal", text.replace("normal 0 0 0", "normal nan nan nan"), 12)
    for i, bad in enumerate(BAD_NUMBERS):
        add(f"text-bad-coordinate-{i}", swapped(text, "vertex -1 1 -1", f"vertex -1 {bad} -1"), ERROR)
    for i, number in enumerate(GOOD_NUMBERS):
        add(f"text-good-coordinate-{i}", swapped(text, "vertex -1 1 -1", f"vertex -1 {number} -1"), 12)
    for i, (old, new) in enumerate([
            ("vertex -1 1 -1\n", ""), ("outer loop\n", ""), ("endloop\n", ""), ("endfacet\n", ""),
            ("endsolid cube\n", ""), ("facet normal 0 0 0\n", ""), ("facet normal 0 0 0", "facet"),
            ("normal 0 0 0", "normal 0 0"), ("normal 0 0 0", "normal 0 0 0 0"), ("vertex -1 1 -1", "vertex -1 1"),
            ("vertex -1 1 -1", "vertex -1 1 -1 1"), ("vertex -1 1 -1\n", "vertex -1 1 -1\n" * 2), ("solid", "sold"),
            ("endfacet", "end facet"), ("outer loop", "outer"), ("endsolid", "endsold")
        ]):
        add(f"text-bad-{i}", swapped(text, old, new), ERROR)
    for i, n in enumerate(range(5, len(text) - 15, 101)):
        add(f"text-cut-{i}", text[:n], ERROR)
    add("text-no-facet", "solid a\nendsolid a\n", ERROR)
    add("random", random.randbytes(100_000), ERROR)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    random.seed(1)
    corpus = Corpus(sys.argv[1])
    for write in (write_obj, write_ply_text, write_ply_bytes, write_off, write_stl):
        write(corpus)
    corpus.finish()


if __name__ == "__main__":
    main()
