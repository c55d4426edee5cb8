package enlightenment.packaged;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;

/** The application names everything that is inside it, with its licence, and carries the texts. */
class LicencesIT {
    private static final Path TEXTS = Packages.PROJECT.resolve("src/app/licenses");

    /** What the list says: artifacts as group/artifact/version, and the texts of each. */
    private static Map<String, List<String>> list() throws IOException {
        Map<String, List<String>> list = new TreeMap<>();
        for (String line : Files.readAllLines(TEXTS.resolve("THIRD-PARTY.md"))) {
            String[] cells = line.split("\\|");
            if (cells.length == 5 && cells[1].contains("`")) {
                String[] names = cells[1].replace("`", "").strip().split(":");
                list.put(
                        names[0].replace('.', '/') + "/" + names[1] + "/" + cells[2].strip(),
                        Arrays.asList(cells[4].strip().split(", ")));
            }
        }
        return list;
    }

    @Test
    void theListNamesWhatIsInTheApplicationAndNothingElse() throws IOException {
        Set<String> inside = new TreeSet<>();
        Set<String> unknown = new TreeSet<>();
        Map<String, Set<String>> origins = origins();
        try (JarFile application = new JarFile(Packages.APPLICATION.toFile())) {
            application.stream()
                    .map(JarEntry::getName)
                    .filter(name -> name.endsWith(".class") && !name.startsWith("enlightenment/"))
                    .forEach(name -> {
                        Set<String> found = origins.getOrDefault(name, Set.of());
                        inside.addAll(found);
                        if (found.isEmpty()) {
                            unknown.add(name);
                        }
                    });
        }
        assertEquals(Set.of(), unknown);
        assertEquals(list().keySet(), inside);
    }

    /** The artifacts that hold a file of this name, for all files in the jars of dependencies. */
    private static Map<String, Set<String>> origins() throws IOException {
        Map<String, Set<String>> origins = new HashMap<>();
        Set<String> listed = list().keySet();
        for (Path jar : Packages.dependencies()) {
            // A repository's folders: the list's names, or the whole path of a jar that the list does not know.
            String folder = jar.getParent().toString().replace('\\', '/');
            String artifact = listed.stream()
                    .filter(name -> folder.endsWith("/" + name))
                    .findFirst()
                    .orElse(folder);
            try (JarFile file = new JarFile(jar.toFile())) {
                file.stream().map(JarEntry::getName).forEach(name -> origins.computeIfAbsent(name, n -> new TreeSet<>())
                        .add(artifact));
            }
        }
        return origins;
    }

    @Test
    void everyTextIsThereAndNamed() throws IOException {
        Set<String> named =
                list().values().stream().flatMap(List::stream).collect(Collectors.toCollection(TreeSet::new));
        named.add("THIRD-PARTY.md");
        Set<String> inJar = new TreeSet<>();
        Set<String> inZip = new TreeSet<>();
        try (JarFile jar = new JarFile(Packages.APPLICATION.toFile())) {
            jar.stream()
                    .map(JarEntry::getName)
                    .filter(n -> n.startsWith("META-INF/licenses/") && !n.endsWith("/"))
                    .forEach(n -> inJar.add(n.substring("META-INF/licenses/".length())));
            byte[] licence =
                    jar.getInputStream(jar.getEntry("META-INF/LICENSE")).readAllBytes();
            assertArrayEquals(Files.readAllBytes(Packages.PROJECT.resolve("LICENSE")), licence);
        }
        String inner = "enlightenment-" + Packages.VERSION + "/licenses/";
        try (ZipFile zip = new ZipFile(Packages.ZIP.toFile())) {
            zip.stream()
                    .filter(e -> e.getName().startsWith(inner) && !e.isDirectory())
                    .forEach(e -> inZip.add(e.getName().substring(inner.length())));
        }
        assertEquals(named, inJar);
        assertEquals(named, inZip);
    }

    /** A new version of a dependency may come with other terms: then its text here is not its text. */
    @Test
    void textsAreThoseThatTheJarsCarry() throws IOException {
        Path core = Packages.dependency("jackson-core-3");
        assertSame("Apache-2.0.txt", core, "META-INF/LICENSE");
        assertSame("jackson-core-NOTICE.txt", core, "META-INF/NOTICE");
        assertSame("FastDoubleParser-LICENSE.txt", core, "META-INF/FastDoubleParser-LICENSE");
        assertSame("FastDoubleParser-ThirdParty-LICENSE.txt", core, "META-INF/FastDoubleParser-ThirdParty-LICENSE");
        assertSame("Schubfach-LICENSE.txt", core, "META-INF/Schubfach-LICENSE");
        Path cbor = Packages.dependency("jackson-dataformat-cbor-");
        assertSame("jackson-dataformat-cbor-NOTICE.txt", cbor, "META-INF/NOTICE");
        List<Path> batik = Packages.dependencies().stream()
                .filter(jar -> jar.getFileName().toString().startsWith("batik-"))
                .toList();
        assertFalse(batik.isEmpty());
        for (Path jar : batik) {
            assertSame("batik-NOTICE.txt", jar, "META-INF/NOTICE");
        }
    }

    /** Names of licences and notices in the jars that the application holds, and that the list knows. */
    @Test
    void noJarCarriesATextThatIsMissingHere() throws IOException {
        Set<String> known = Set.of(
                "META-INF/LICENSE",
                "META-INF/NOTICE",
                "META-INF/FastDoubleParser-LICENSE",
                "META-INF/FastDoubleParser-ThirdParty-LICENSE",
                "META-INF/Schubfach-LICENSE");
        Set<String> artifacts = list().keySet();
        for (Path jar : Packages.dependencies()) {
            String place = jar.toString().replace('\\', '/');
            if (artifacts.stream().noneMatch(place::contains)) {
                continue;
            }
            try (JarFile file = new JarFile(jar.toFile())) {
                List<String> texts = file.stream()
                        .map(JarEntry::getName)
                        .filter(n -> n.matches("(?i)(.*/)?[^/]*(licen[cs]e|notice|copying)[^/]*"))
                        .filter(n -> !n.endsWith(".class") && !known.contains(n))
                        .toList();
                assertEquals(List.of(), texts, jar.toString());
            }
        }
    }

    private static void assertSame(String text, Path jar, String entry) throws IOException {
        try (JarFile file = new JarFile(jar.toFile())) {
            byte[] there = file.getInputStream(file.getEntry(entry)).readAllBytes();
            assertArrayEquals(there, Files.readAllBytes(TEXTS.resolve(text)), text + " is not " + entry + " of " + jar);
        }
    }
}
