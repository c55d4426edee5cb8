#!/bin/sh
# Makes the site in target/site from the pages of the repository and the Javadoc, and checks its links.
#
#   src/site/build.sh [OPTIONS OF MAVEN]
#
# Needs Python 3.9 or newer with its module venv, a JDK 17 or newer and Maven. The generator is installed into target/site-tools.
set -eu
cd "$(dirname "$0")/../.."

tools=target/site-tools
if ! cmp -s src/site/requirements.txt "$tools/installed.txt"; then
    rm -rf "$tools"
    python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check --requirement src/site/requirements.txt
    cp src/site/requirements.txt "$tools/installed.txt"
fi

mvn -B -q "$@" -Dspotless.check.skip compile javadoc:javadoc
"$tools/bin/python" src/site/stage.py target/site-source target/reports/apidocs
# Not quiet: that would silence the warnings by which it ends.
NO_MKDOCS_2_WARNING=1 "$tools/bin/mkdocs" build --strict --clean --config-file target/site-source/mkdocs.yml
"$tools/bin/python" src/site/check.py target/site
du -sh target/site
