# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Usage: list_contents.py VERSION DATE [LIBRARY...]

Prints what a program built from these sources contains, as an SPDX 2.3 document (JSON): Balcony, the
libraries that NOTICE names, and the Debian packages of further libraries that travel with it. Their
versions are those of the packages that are installed. DATE is in seconds since 1970.
"""

import datetime
import json
import re
import subprocess
import sys
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent


def rows_of_notice():
    """Package and licence of each row; those of tests are not part of any program."""
    for line in (REPOSITORY / "NOTICE").read_text().splitlines():
        row = re.fullmatch(r"  \S.*?  +(lib\S+|nlohmann\S+) +([A-Za-z]\S+?)(, parts (\S+))?( .*)?", line)
        if row and "(tests only)" not in line:
            yield row[1], f"{row[2]} AND {row[4]}" if row[4] else row[2]


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


def main():
    version, date, libraries = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    licences = dict(rows_of_notice())
    others = packages_of(libraries) - set(licences)
    balcony = {"SPDXID": "SPDXRef-balcony", "name": "balcony", "versionInfo": version,
               "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
               "licenseConcluded": "Apache-2.0", "licenseDeclared": "Apache-2.0",
               "copyrightText": "NOASSERTION"}
    parts = ([described(name, licence) for name, licence in licences.items()]
             + [described(name, "NOASSERTION") for name in sorted(others)])
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
