# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Usage: make_wheel.py FOLDER VERSION DATE NUMPY

Makes a wheel of all files of FOLDER, which are those of the folder of modules in which it is to be
installed: the package `balcony` and, with notices, balcony-VERSION.dist-info, to which METADATA, WHEEL
and RECORD are added. Prints its path, which is beside FOLDER. DATE is in seconds since 1970; the
same files, date and zlib make the same bytes. NUMPY is what the wheel requires, as "numpy<2".

The name tells for which Python the wheel is, by that of the module of C++, and that it needs the C
library of this machine or a newer one.
"""

import base64
import hashlib
import os
import re
import sys
import time
import zipfile
from pathlib import Path

METADATA = """\
Metadata-Version: 2.1
Name: balcony
Version: {version}
Summary: Rendering through extended cameras
License: Apache-2.0; licenses/ has the licences of the libraries inside
Requires-Python: >=3.11
Requires-Dist: {numpy}
Description-Content-Type: text/plain

Cameras that are any function from a point of the picture to a ray: their rays, where they show
points, exact derivatives by parameters, and pictures of 3D scenes with layers, as arrays of NumPy.
"""
WHEEL = """\
Wheel-Version: 1.0
Generator: balcony {version}
Root-Is-Purelib: false
Tag: {tag}
"""
# What the format of zip files can tell.
EARLIEST = time.struct_time((1980, 1, 1, 0, 0, 0, 0, 1, 0))


def tag_of(package):
    """For which Python, ABI and system the module in a package is."""
    modules = [path.name for path in package.glob("_balcony.*.so")]
    names = [re.fullmatch(r"_balcony\.cpython-(\d+)-(\w+)-linux-gnu\.so", name) for name in modules]
    if len(names) != 1 or not names[0]:
        sys.exit(f"'{package}' has {modules or 'no module'}: one of C++ for CPython on Linux is needed")
    python, machine = names[0].groups()
    library, number = os.confstr("CS_GNU_LIBC_VERSION").split()
    if library != "glibc":
        sys.exit(f"the C library of this machine is {library}: a wheel needs one made with glibc")
    return f"cp{python}-cp{python}-manylinux_{number.replace('.', '_')}_{machine}"


def row_of_record(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def write_wheel(path, files, record, date):
    """Writes files, which are pairs of a name and a path or bytes, and after them their record."""
    moment = max(time.gmtime(date), EARLIEST)[:6]
    with zipfile.ZipFile(path, "w") as archive:

        def add(name, data):
            entry = zipfile.ZipInfo(name, moment)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o100644 << 16
            archive.writestr(entry, data)

        rows = []
        for name, content in files:
            data = content if isinstance(content, bytes) else content.read_bytes()
            rows.append(row_of_record(name, data))
            add(name, data)
        add(record, "".join(rows) + f"{record},,\n")


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    folder, version, date, numpy = Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), sys.argv[4]
    tag = tag_of(folder / "balcony")
    about = f"balcony-{version}.dist-info"
    files = {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}
    files[f"{about}/METADATA"] = METADATA.format(version=version, numpy=numpy).encode()
    files[f"{about}/WHEEL"] = WHEEL.format(version=version, tag=tag).encode()
    # Readers find what tells of the wheel at its end.
    in_order = sorted(files.items(), key=lambda file: (file[0].startswith(about), file[0]))
    wheel = folder.parent / f"balcony-{version}-{tag}.whl"
    write_wheel(wheel, in_order, f"{about}/RECORD", date)
    print(wheel)


if __name__ == "__main__":
    main()
