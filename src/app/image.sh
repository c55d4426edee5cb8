#!/bin/sh
# Makes an image of the application, which needs no Java on the machine: target/enlightenment-VERSION-SYSTEM-PROCESSOR.tar.gz.
#
#   mvn -q -B -DskipTests package && src/app/image.sh
#
# It holds what the application's zip holds, the parts of a JDK that it uses, made by jlink, and from Java 19 on an archive of classes to start
# from. The JDK is that of JAVA_HOME, or else of the PATH; the image is for the system and the processor that it is made on.
set -eu
cd "$(dirname "$0")/../.."

fail() {
    printf 'image.sh: %s\n' "$1" >&2
    exit 1
}

set -- target/enlightenment-*-app.zip
[ -r "$1" ] && [ $# -eq 1 ] || fail "there must be one target/enlightenment-VERSION-app.zip: run 'mvn -q -B -DskipTests clean package'"
name=$(basename "$1" -app.zip)
zip=$PWD/$1
if [ -n "${JAVA_HOME:-}" ]; then
    tools=$JAVA_HOME/bin/
else
    tools=
fi
for tool in java jar jlink; do
    command -v "$tools$tool" > /dev/null || fail "there is no $tools$tool: JAVA_HOME must name a JDK 17 or newer"
done

rm -rf target/image
mkdir -p target/image
(cd target/image && "${tools}jar" --extract --file "$zip")
home=$PWD/target/image/$name
chmod +x "$home/bin/enlightenment"

# What jdeps finds in the jar, and what it cannot see: elliptic curves of TLS, letters of other locales, and drivers of databases.
"${tools}jlink" --output "$home/runtime" --strip-java-debug-attributes --no-header-files --no-man-pages \
    --add-modules java.base,java.desktop,java.sql,java.naming,jdk.jfr,jdk.management,jdk.crypto.ec,jdk.charsets,jdk.unsupported

version=$("$home/runtime/bin/java" -XshowSettings:properties -version 2>&1 | sed -n 's/^ *java\.specification\.version = //p')
if [ "$version" -ge 19 ]; then
    archive=$home/lib/enlightenment.jsa
    [ "$version" -lt 25 ] || archive=$home/lib/enlightenment.aot
    # The archive stands on one of Java's own classes, which jlink leaves out.
    "$home/runtime/bin/java" -Xshare:dump -Xlog:disable
    "$home/runtime/bin/java" -Xlog:disable "-Denlightenment.archive=$archive" -cp "$home/lib/enlightenment.jar" enlightenment.cli.Main setup > /dev/null
fi

file=target/$name-$(uname -s | tr '[:upper:]' '[:lower:]')-$(uname -m).tar.gz
tar -C target/image -cf - "$name" | gzip -9 > "$file.part"
mv "$file.part" "$file"
echo "$file"
