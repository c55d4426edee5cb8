"""Writes the pictures of this folder by the OpenEXR library: python3 make.py FOLDER (pip install OpenEXR numpy; made with 3.5.3)

Files of one beginning hold the same numbers; "pxr24" of floats holds 24 bits of them.
"""
import sys

import numpy as np
import OpenEXR as exr

CODES = {"piz": exr.PIZ_COMPRESSION, "zip": exr.ZIP_COMPRESSION, "pxr24": exr.PXR24_COMPRESSION}


def write(kind, codes, channels):
    for code in codes:
        header = {"compression": CODES[code], "type": exr.scanlineimage}
        with exr.File(header, channels) as file:
            file.write(f"{sys.argv[1]}/{kind}-{code}.exr")


# Odd sizes; the words of a chunk are few and near to each other, or PIZ would be longer than the numbers themselves.
y, x = np.mgrid[0:53, 0:37]
half = np.stack([1 + (x // 6 + y // 5) % 7 / 4, np.where(x > y, 1.5, 0.25 * (1 + y // 9)), (8 + x * y // 64) / 8], -1)
half = half.astype(np.float16)
steps = np.stack([(x // 4 + y // 5) % 7 * 11, np.where(x > y, 3, y // 9), x * y // 8], -1).astype(np.uint32)
single = (steps + 0x3F800000).view(np.float32)
write("half", CODES, {"RGB": half})
write("float", CODES, {"RGB": single})
number = (x // 5 * 7 + y // 4 * 100).astype(np.uint32)
write("mixed", CODES, {"R": half[..., 0].copy(), "G": single[..., 1].copy(), "B": half[..., 2].copy(), "Id": number})

# More than 2^14 different words in a chunk: the wavelet transform modulo 2^16.
y, x = np.mgrid[0:33, 0:540]
many = 0x0400 + 540 * y + x
many[5:9, 100:140] ^= 3
write("many", ["piz", "zip"], {"Y": many.astype(np.uint16).view(np.float16)})
