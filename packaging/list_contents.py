# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Usage: list_contents.py [--page LICENCES | --python] VERSION DATE [LIBRARY...]

Prints what the command, or the module of Python, contains, as an SPDX 2.3 document (JSON): Balcony, the
libraries that NOTICE names for it, the Debian packages of further libraries that travel with it, and, with
licences.txt of the pages, the packages of npm that it names. The versions of Debian's are
those that are installed. DATE is in seconds since 1970.
"""

import argparse
import datetime
import json
import re
import subprocess
import sys
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent


def rows_of_notice(part):
    """Package and licence of each row that is for all, or for this part of Balcony."""
    for line in (REPOSITORY / "NOTICE").read_text().splitlines():
        row = re.fullmatch(r"  \S.*?  +([a-z]\S+-dev) +([A-Za-z]\S+?)(?:(?:, parts| and) (\S+))?( .*)?", line)
        if row and (" only)" not in line or f"({part} only)" in line):
            yield row[1], f"{row[2]} AND {row[3]}" if row[3] else row[2]


def output_of(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


def packages_of(libraries):
    """The names of the packages that the files of libraries belong to."""
    names = set()
    for library in libraries:
        # Where /lib is a link to /usr/lib, a file is known under one of both names.
        path = str(Path(library).resolve())
        found = subprocess.run(["dpkg", "--search", path, path.removeprefix("/usr")],
                               capture_output=True, text=True, check=False).stdout
        if not found:
            sys.exit(f"{library} belongs to no Debian package")
        names.add(found.split(":")[0])
    return names


def described(name, licence):
    """A Debian package as SPDX has it."""
    version, source, source_version, home = output_of(
        "dpkg-query", "-W", "-f",
        r"${Version}\n${source:Package}\n${source:Version}\n${Homepage}\n", name).splitlines()[:4]
    return {"SPDXID": f"SPDXRef-{re.sub('[^A-Za-z0-9.]', '-', name)}", "name": name,
            "versionInfo": version, "supplier": "Organization: Debian",
            "downloadLocation": f"https://snapshot.debian.org/package/{source}/{source_version}/",
            "homepage": home or "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": licence, "licenseDeclared": licence,
            "licenseComments": f"/usr/share/doc/{name}/copyright", "copyrightText": "NOASSERTION"}


def packages_of_page(licences):
    """The packages of npm in the pages, as SPDX has them."""
    found = re.findall(r"^(@?[a-z0-9/_.-]+) (\d+\.\d\S*): (\S+)$", Path(licences).read_text(), re.MULTILINE)
    for name, version, licence in dict.fromkeys(found):  # Pages may share packages.
        archive = f"{name.split('/')[-1]}-{version}.tgz"
        yield {"SPDXID": f"SPDXRef-npm{re.sub('[^A-Za-z0-9.]', '-', f'-{name}')}", "name": name,
               "versionInfo": version, "supplier": "NOASSERTION",
               "downloadLocation": f"https://registry.npmjs.org/{name}/-/{archive}",
               "filesAnalyzed": False, "licenseConcluded": licence, "licenseDeclared": licence,
               "copyrightText": "NOASSERTION"}


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--page")
    options.add_argument("--python", action="store_true")
    options.add_argument("version")
    options.add_argument("date", type=int)
    options.add_argument("libraries", nargs="*")
    given = options.parse_args()
    version, date = given.version, given.date
    licences = dict(rows_of_notice("the module of Python" if given.python else "the command"))
    others = packages_of(given.libraries) - set(licences)
    balcony = {"SPDXID": "SPDXRef-balcony", "name": "balcony", "versionInfo": version,
               "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
               "licenseConcluded": "Apache-2.0", "licenseDeclared": "Apache-2.0",
               "copyrightText": "NOASSERTION"}
    parts = ([described(name, licence) for name, licence in licences.items()]
             + [described(name, "NOASSERTION") for name in sorted(others)]
             + list(packages_of_page(given.page) if given.page else ()))
    made = datetime.datetime.fromtimestamp(date, datetime.timezone.utc)
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES",
                  "relatedSpdxElement": "SPDXRef-balcony"}]
    relations += [{"spdxElementId": "SPDXRef-balcony", "relationshipType": "DEPENDS_ON",
                   "relatedSpdxElement": part["SPDXID"]} for part in parts]
    print(json.dumps({
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"balcony-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/balcony-{version}-{date}",
        "creationInfo": {"created": made.strftime("%Y-%m-%dT%H:%M:%SZ"),
                         "creators": ["Tool: packaging/list_contents.py"]},
        "packages": [balcony, *parts], "relationships": relations}, indent=1))


if __name__ == "__main__":
    main()
