"""Writes a corpus of damaged and hostile image files, the same every time, and what may come of each.

Usage: make_bad_images.py FOLDER SEED...     SEED: good files, at least a.jpg, a.exr and a.hdr, of 16 x 12 pixels

FOLDER/expected.txt has a line for each file: `read`, `refuse` or `either`, the size that a picture must have where it
is given ("-" where a damaged header may state another), and the file's name.
"""
import os
import pathlib
import random
import struct
import sys
import zlib

W, H = 16, 12


def rgb(i):
    return bytes([i * 7 & 255, i * 13 & 255, i * 29 & 255])


PIXELS = b"".join(rgb(i) for i in range(W * H))


# ---- one good file of each format that can be written in a few lines -------------------------------------------------
def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width=W, height=H, bits=8, colour=2, data=None, before=b"", interlace=0, end=True):
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}.get(colour, 3)
    if data is None:
        row = (width * channels * bits + 7) // 8
        data = zlib.compress(b"".join(b"\0" + bytes((y * 31 + x) & 255 for x in range(row)) for y in range(height)))
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, interlace))
    return b"\x89PNG\r\n\x1a\n" + header + before + chunk(b"IDAT", data) + (chunk(b"IEND", b"") if end else b"")


def bmp(width=W, height=H, bits=24, compression=0, offset=54, size=40, colours=0, pixels=None, palette=b"", planes=1):
    if pixels is None:
        row = (abs(width) * bits + 31) // 32 * 4
        pixels = bytes((i * 11) & 255 for i in range(min(row * abs(height), 1 << 16)))
    header = struct.pack("<IiiHHIIiiII", size, width, height, planes, bits, compression, len(pixels), 2835, 2835,
                         colours, 0)
    body = header + palette + pixels
    return b"BM" + struct.pack("<IHHI", 14 + len(body), 0, 0, offset) + body


def tga(kind=2, width=W, height=H, bits=24, map_type=0, map_spec=(0, 0, 0), pixels=PIXELS, length=0):
    return struct.pack("<BBBHHBHHHHBB", length, map_type, kind, *map_spec, 0, 0, width, height, bits, 0x20) + pixels


def tiff(entries=None, order="<", pixels=PIXELS, **changed):
    """Baseline RGB; `changed` replaces an entry's value by its name."""
    names = dict(width=256, height=257, bits=258, compression=259, photometric=262, offset=273, samples=277, rows=278,
                 count=279, planar=284)
    values = dict(width=W, height=H, bits=8, compression=1, photometric=2, offset=8, samples=3, rows=H,
                  count=len(pixels), planar=1) | changed
    bits_at = 8 + len(pixels)
    entries = entries or []
    for name, tag in names.items():
        if name == "bits" and values["samples"] == 3:
            entries.append((tag, 3, 3, bits_at))
        elif values[name] is not None:
            entries.append((tag, 4, 1, values[name]))
    entries.sort()
    directory = struct.pack(order + "H", len(entries))
    directory += b"".join(struct.pack(order + "HHII", *e) for e in entries) + struct.pack(order + "I", 0)
    bits = struct.pack(order + "HHH", *[values["bits"]] * 3)
    mark = b"II" if order == "<" else b"MM"
    return mark + struct.pack(order + "HI", 42, bits_at + 6) + pixels + bits + directory


def hdr(width=W, height=H, pixels=None, head=b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", sizes=None):
    if pixels is None:
        pixels = b"".join(rgb(i) + b"\x80" for i in range(W * H))
    return head + b"\n" + (sizes or b"-Y %d +X %d\n" % (height, width)) + pixels


def pnm(kind="P6", width=W, height=H, most="255", pixels=PIXELS, gap=" "):
    return f"{kind}{gap}{width}{gap}{height}{gap}{most}\n".encode() + pixels


def pfm(width=W, height=H, scale="-1.0", values=None, kind="PF"):
    values = values or [i / 100 for i in range(W * H * 3)]
    return f"{kind}\n{width} {height}\n{scale}\n".encode() + struct.pack(f"<{len(values)}f", *values)


GOOD = {"png": png(), "bmp": bmp(), "tga": tga(), "tif": tiff(), "hdr": hdr(), "ppm": pnm(), "pfm": pfm(),
        "pgm": pnm("P5", pixels=PIXELS[:W * H])}
NAN, INF = float("nan"), float("inf")
BIG, HALF = 2**31 - 1, W * H * 3 // 2

# ---- hostile files: expectation, size of what is read (None: any), name, bytes -----------------------------------
SIZE = (W, H)
TABLE = [
    ("read", SIZE, "good.png", png()),
    ("read", SIZE, "grey.png", png(colour=0)),
    ("read", SIZE, "grey16.png", png(bits=16, colour=0)),
    ("read", SIZE, "alpha.png", png(colour=6)),
    ("read", SIZE, "grey_alpha.png", png(colour=4)),
    ("read", SIZE, "rgb16.png", png(bits=16)),
    ("read", (1, 1), "one.png", png(1, 1)),
    ("read", (33, 17), "odd.png", png(33, 17)),
    ("read", (65536, 1), "wide.png", png(65536, 1)),
    ("read", (1, 65536), "tall.png", png(1, 65536)),
    ("read", SIZE, "bits1.png", png(bits=1, colour=0)),
    ("refuse", None, "zero.png", png(0, 0, data=b"")),
    ("refuse", None, "zero_width.png", png(0, H)),
    ("refuse", None, "zero_height.png", png(W, 0)),
    ("refuse", None, "bomb_65535.png", png(65535, 65535, 8, 6, b"")),
    ("refuse", None, "bomb_million.png", png(10**6, 10**6, data=b"")),
    ("refuse", None, "bomb_2g.png", png(BIG, BIG, 16, 6, b"")),
    ("refuse", None, "bomb_wide.png", png(BIG, 1, data=b"")),
    ("refuse", None, "bomb_17000.png", png(17000, 17000, 8, 0, b"")),
    ("refuse", None, "just_over_512MB.png", png(13400, 13400, data=b"")),
    ("refuse", None, "empty_data.png", png(data=b"")),
    ("refuse", None, "zlib_junk.png", png(data=b"\x78\x9cjunkjunk")),
    ("either", SIZE, "short_data.png", png(data=zlib.compress(b"\0" * 40))),
    ("either", SIZE, "long_data.png", png(data=zlib.compress(b"\0" * 10**6))),
    ("either", SIZE, "zip_bomb.png", png(data=zlib.compress(b"\0" * 3 * 10**7, 9))),
    ("either", SIZE, "no_end.png", png(end=False)),
    ("refuse", None, "header_crc.png", png().replace(png()[29:33], b"\1\2\3\4", 1)),
    ("either", SIZE, "bits3.png", png(bits=3)),
    ("refuse", None, "bits_colour.png", png(bits=1, colour=6)),
    ("refuse", None, "colour7.png", png(colour=7)),
    ("refuse", None, "palette_none.png", png(colour=3)),
    ("either", SIZE, "palette_short.png", png(colour=3, before=chunk(b"PLTE", b"\1\2\3"))),
    ("either", SIZE, "palette_odd.png", png(colour=3, before=chunk(b"PLTE", b"\1\2\3\4"))),
    ("refuse", None, "filter9.png", png(data=zlib.compress(b"\x09" * 588))),
    ("read", SIZE, "two_headers.png", png() + png()),
    ("either", SIZE, "interlaced.png", png(interlace=1)),
    ("refuse", None, "interlace9.png", png(interlace=9)),
    ("either", SIZE, "gamma0.png", png(before=chunk(b"gAMA", b"\0\0\0\0"))),
    ("either", SIZE, "profile_junk.png", png(before=chunk(b"iCCP", b"x\0\0junk"))),
    ("either", SIZE, "text_huge.png", png(before=chunk(b"zTXt", b"k\0\0" + zlib.compress(b"t" * 10**7)))),
    ("either", SIZE, "trns_long.png", png(before=chunk(b"tRNS", b"\1" * 300))),
    ("either", SIZE, "unknown_critical.png", png(before=chunk(b"ABCD", b"x"))),
    ("refuse", None, "chunk_length.png", png()[:33] + b"\xff\xff\xff\xff" + png()[37:]),
    ("read", SIZE, "good.bmp", bmp()),
    ("read", SIZE, "bits32.bmp", bmp(bits=32)),
    ("read", (16, 12), "top_down.bmp", bmp(height=-H)),
    ("refuse", None, "width_0.bmp", bmp(width=0)),
    ("refuse", None, "width_huge.bmp", bmp(width=BIG, pixels=b"x")),
    ("refuse", None, "width_negative.bmp", bmp(width=-5)),
    ("refuse", None, "height_min.bmp", bmp(height=-2**31, pixels=b"x")),
    ("refuse", None, "height_huge.bmp", bmp(height=10**6, width=10**6, pixels=b"x")),
    ("either", SIZE, "offset_huge.bmp", bmp(offset=BIG)),
    ("either", SIZE, "offset_0.bmp", bmp(offset=0)),
    ("either", None, "bits0.bmp", bmp(bits=0)),
    ("either", None, "bits7.bmp", bmp(bits=7)),
    ("either", SIZE, "palette_missing.bmp", bmp(bits=8)),
    ("either", SIZE, "colours_huge.bmp", bmp(bits=8, colours=BIG)),
    ("either", SIZE, "colours_small.bmp", bmp(bits=8, colours=1, palette=b"\1\2\3\0", offset=58)),
    ("either", SIZE, "rle8.bmp", bmp(bits=8, compression=1, pixels=b"\xff\1" * 400)),
    ("either", SIZE, "rle8_delta.bmp", bmp(bits=8, compression=1, pixels=b"\0\2\xff\xff" * 100)),
    ("either", SIZE, "rle4.bmp", bmp(bits=4, compression=2, pixels=b"\xff\x12" * 99)),
    ("either", SIZE, "bitfields.bmp", bmp(bits=16, compression=3)),
    ("either", None, "header_size.bmp", bmp(size=3)),
    ("either", None, "header_huge.bmp", bmp(size=BIG)),
    ("either", SIZE, "planes.bmp", bmp(planes=9)),
    ("refuse", None, "short.bmp", bmp()[:40]),
    ("either", SIZE, "os2.bmp", b"BM" + struct.pack("<IHHIIHHHH", 26 + 576, 0, 0, 26, 12, W, H, 1, 24) + PIXELS),
    ("read", SIZE, "good.tga", tga()),
    ("read", SIZE, "bits32.tga", tga(bits=32, pixels=PIXELS + PIXELS[:192])),
    ("read", SIZE, "grey.tga", tga(3, bits=8)),
    ("read", SIZE, "rle.tga", tga(10, pixels=b"".join(b"\x8f" + rgb(y) for y in range(H)))),
    ("refuse", None, "64k.tga", tga(width=65535, height=65535)),
    ("refuse", None, "zero.tga", tga(width=0)),
    ("refuse", None, "palette.tga", tga(1, bits=8, map_type=1, map_spec=(0, 256, 24))),
    ("refuse", None, "palette_lie.tga", tga(9, bits=8, map_type=1, map_spec=(60000, 5, 24))),
    ("refuse", None, "map_unused.tga", tga(2, map_type=1, map_spec=(0, 9, 24))),
    ("either", SIZE, "name_long.tga", tga(length=255)),
    ("refuse", None, "short.tga", tga(pixels=PIXELS[:HALF])),
    ("either", SIZE, "rle_over.tga", tga(10, pixels=b"\xff\1\2\3" * 99)),
    ("refuse", None, "rle_short.tga", tga(10, pixels=b"\xff\1\2\3")),
    ("either", SIZE, "rle_raw.tga", tga(10, pixels=b"\x7f" + PIXELS)),
    ("either", SIZE, "bits15.tga", tga(bits=15)),
    ("refuse", None, "bits17.tga", tga(bits=17)),
    ("refuse", None, "kind33.tga", tga(33)),
    ("either", SIZE, "footer.tga", tga() + struct.pack("<II", BIG, BIG) + b"TRUEVISION-XFILE.\0"),
    ("read", SIZE, "good.tif", tiff()),
    ("refuse", None, "huge.tif", tiff(width=10**6, height=10**6)),
    ("refuse", None, "wide.tif", tiff(width=BIG)),
    ("refuse", None, "zero.tif", tiff(width=0)),
    ("refuse", None, "tall.tif", tiff(height=2**32 - 1)),
    ("refuse", None, "offset.tif", tiff(offset=BIG)),
    ("either", SIZE, "count.tif", tiff(count=2**32 - 1)),
    ("either", SIZE, "count0.tif", tiff(count=0)),
    ("either", None, "bits33.tif", tiff(bits=33)),
    ("either", None, "samples0.tif", tiff(samples=0)),
    ("refuse", None, "samples.tif", tiff(samples=60000)),
    ("refuse", None, "compression.tif", tiff(compression=12345)),
    ("refuse", None, "lzw_junk.tif", tiff(compression=5)),
    ("refuse", None, "deflate_junk.tif", tiff(compression=8)),
    ("read", SIZE, "deflate.tif", tiff(compression=8, pixels=zlib.compress(PIXELS))),
    ("refuse", None, "deflate_cut.tif", tiff(compression=8, pixels=zlib.compress(PIXELS)[:200])),
    ("refuse", None, "deflate_one_row.tif", tiff(compression=8, height=1, rows=1, pixels=b"12345678")),
    ("refuse", None, "jpeg_junk.tif", tiff(compression=7)),
    ("either", SIZE, "packbits.tif", tiff(compression=32773)),
    ("either", SIZE, "fax.tif", tiff(compression=4)),
    ("refuse", None, "cmyk.tif", tiff(photometric=5, samples=4)),
    ("either", None, "photometric.tif", tiff(photometric=777)),
    ("either", None, "ycbcr.tif", tiff(photometric=6)),
    ("either", SIZE, "planar.tif", tiff(planar=2)),
    ("either", SIZE, "rows0.tif", tiff(rows=0)),
    ("refuse", None, "tiles.tif", tiff([(322, 4, 1, 16), (323, 4, 1, 16)])),
    ("refuse", None, "directory.tif", tiff()[:4] + b"\xff\xff\xff\x7f" + tiff()[8:]),
    ("refuse", None, "no_width.tif", tiff(width=None)),
    ("either", SIZE, "volume.tif", tiff([(32997, 4, 1, 9)])),
    ("either", None, "directory_loop.tif", tiff()[:-4] + struct.pack("<I", 8 + 576 + 6)),
    ("either", SIZE, "big_endian_mark.tif", b"MM\0*" + tiff()[4:]),
    ("read", SIZE, "good.hdr", hdr()),
    ("refuse", None, "huge.hdr", hdr(10**5, 10**5)),
    ("refuse", None, "negative.hdr", hdr(-5, -5)),
    ("refuse", None, "zero.hdr", hdr(0, 0)),
    ("refuse", None, "overflow.hdr", hdr(sizes=b"-Y 99999999999 +X 99999999999\n")),
    ("refuse", None, "no_size.hdr", hdr(sizes=b"hello\n")),
    ("either", SIZE, "rle_lie.hdr", hdr(pixels=b"\x02\x02\x00\x10" + b"\xff\x01" * 400)),
    ("refuse", None, "rle_short.hdr", hdr(pixels=b"\x02\x02\x00\x10\xff")),
    ("read", (2, 1), "exponent255.hdr", hdr(2, 1, b"\xff" * 8)),
    ("either", SIZE, "rle_width.hdr", hdr(pixels=b"\x02\x02\x7f\xff" + b"\x81\x01" * 400)),
    ("either", SIZE, "old_rle.hdr", hdr(pixels=b"\1\1\1\xff" * 900)),
    ("either", SIZE, "line_long.hdr", hdr(head=b"#?RADIANCE\nX=" + b"a" * 10**6 + b"\nFORMAT=32-bit_rle_rgbe\n")),
    ("either", SIZE, "exposure.hdr", hdr(head=b"#?RADIANCE\nEXPOSURE=1e400\nFORMAT=32-bit_rle_rgbe\n")),
    ("read", SIZE, "good.ppm", pnm()),
    ("read", SIZE, "comment.ppm", b"P6 # \xe6\x97\xa5\n16 12\n255\n" + PIXELS),
    ("read", (2, 1), "ascii.ppm", b"P3\n2 1\n255\n255 0 0\n0 255 0\n"),
    ("refuse", None, "huge.ppm", pnm(width=10**6, height=10**6)),
    ("refuse", None, "negative.ppm", pnm(width=-5)),
    ("refuse", None, "zero.ppm", pnm(width=0)),
    ("refuse", None, "overflow.ppm", pnm(width=2**32 + 16)),
    ("either", SIZE, "most0.ppm", pnm(most="0")),
    ("either", SIZE, "most_negative.ppm", pnm(most="-1")),
    ("either", SIZE, "most_huge.ppm", pnm(most="99999999999")),
    ("refuse", None, "short.ppm", pnm(pixels=PIXELS[:HALF])),
    ("refuse", None, "no_pixels.ppm", pnm(pixels=b"")),
    ("refuse", None, "half_header.ppm", b"P6\n16"),
    ("either", (2, 2), "text.ppm", b"P3\n2 2\n255\nabc def\n"),
    ("either", (2, 1), "ascii_over.ppm", b"P3\n2 1\n255\n999 0 0\n0 -5 0\n"),
    ("either", (9, 9), "bits_short.pbm", b"P4\n9 9\n\xff"),
    ("read", (8, 2), "bits.pbm", b"P4\n8 2\n\xaa\x55"),
    ("either", SIZE, "sixteen.ppm", pnm(most="65535", pixels=PIXELS * 2)),
    ("read", SIZE, "good.pfm", pfm()),
    ("read", SIZE, "nan.pfm", pfm(values=[NAN, INF, -INF, 1e38, -1e38, 1e-40] * (W * H // 2))),
    ("either", SIZE, "scale0.pfm", pfm(scale="0")),
    ("either", SIZE, "scale_nan.pfm", pfm(scale="nan")),
    ("either", SIZE, "scale_text.pfm", pfm(scale="x")),
    ("refuse", None, "huge.pfm", pfm(10**6, 10**6)),
    ("refuse", None, "short.pfm", pfm(values=[1.0] * 9)),
    ("refuse", None, "negative.pfm", pfm(-2, 2)),
    ("refuse", None, "text.png", b"hello world\n" * 50),
    ("refuse", None, "picture.gif", b"GIF89a\x10\0\x0c\0\0\0\0;"),
    ("refuse", None, "picture.webp", b"RIFF\x10\0\0\0WEBPVP8 "),
    ("refuse", None, "picture.psd", b"8BPS\0\1" + b"\0" * 60),
    ("refuse", None, "picture.ico", b"\0\0\1\0\1\0" + b"\0" * 60),
    ("refuse", None, "picture.dpx", b"SDPX" + b"\0" * 2000),
    ("refuse", None, "picture.sgi", b"\x01\xda\1\1" + b"\0" * 600),
    ("refuse", None, "zeros.tga", b"\0" * 1000),
    ("refuse", None, "picture.svg", b"<svg/>"),
]


def damaged(good, extension):
    """What happens to files of any format: cut, mixed up, misnamed, a byte changed."""
    noise = random.Random(extension)
    n = len(good)
    yield "refuse", "empty", b""
    for cut in (1, 2, 4, 8, 16, 24, 40):
        yield "refuse", f"first_{cut}", good[:cut]
    for part in (2, 3, 5, 9):
        yield "either", f"first_{part}_tenths", good[:n * part // 10]
    yield "either", "cut_1", good[:-1]
    yield "either", "cut_20", good[:-20]
    yield "either", "tail", good + b"tail" * 1000
    yield "either", "twice", good + good
    yield "either", "zero_middle", good[:n // 3] + bytes(n // 3) + good[n // 3 * 2:]
    yield "either", "noise_after_header", good[:64] + noise.randbytes(max(n - 64, 0))
    yield "refuse", "noise", b"\xfe" + noise.randbytes(4095)
    yield "refuse", "shifted", b" " + good
    for i in range(16):
        at = noise.randrange(min(n, 128))
        changed = bytes([good[at] ^ noise.choice([1, 0x80, 0xff])])
        yield "either", f"changed_{at}_{i}", good[:at] + changed + good[at + 1:]


def exr_files(good):
    yield "refuse", "tiled", good[:5] + b"\x02" + good[6:]
    yield "refuse", "deep", good[:5] + b"\x08" + good[6:]
    yield "refuse", "parts", good[:5] + b"\x10" + good[6:]
    window = good.find(b"dataWindow\0box2i\0") + 21
    for name, box in {"huge": (0, 0, 10**6, 10**6), "negative": (5, 5, 0, 0), "limits": (-2**31, -2**31, BIG, BIG),
                      "wide": (0, 0, BIG, 0)}.items():
        yield "refuse", "window_" + name, good[:window] + struct.pack("<4i", *box) + good[window + 16:]
    compression = b"compression\0compression\0\1\0\0\0"
    yield "refuse", "compression", good.replace(compression + b"\3", compression + b"\x77", 1)
    yield "refuse", "type", good.replace(b"channels\0chlist\0", b"channels\0chlisX\0", 1)
    yield "either", "line_order", good.replace(b"lineOrder\0", b"lineXrder\0", 1)


def main(folder, seeds):
    folder = pathlib.Path(folder)
    os.makedirs(folder, exist_ok=True)
    expected = []

    def write(expectation, size, name, data):
        (folder / name).write_bytes(data)
        expected.append(f"{expectation} {f'{size[0]} {size[1]}' if size else '- -'} {name}\n")

    for row in TABLE:
        write(*row)
    good = dict(GOOD)
    for seed in seeds:
        path = pathlib.Path(seed)
        good[path.suffix[1:] + ("" if path.suffix[1:] not in GOOD else "_seed")] = path.read_bytes()
    for name, data in good.items():
        extension = name.split("_")[0]
        for expectation, kind, changed in damaged(data, name):
            write(expectation, None, f"{name}_{kind}.{extension}", changed)
    for expectation, kind, changed in exr_files(good["exr"]):
        write(expectation, None, f"exr_{kind}.exr", changed)
    (folder / "expected.txt").write_text("".join(expected), encoding="utf-8")
    print(f"{len(expected)} files")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
