package enlightenment.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Holds CONTRIBUTING.md and the project together: what its lists of places name is there. */
class ContributingTest {
    private static final Path ROOT = Path.of(System.getProperty("project.directory", "."));
    private static final Pattern CODE = Pattern.compile("`([^`]+)`");
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]+)[^)]*\\)");

    private static String document;

    @BeforeAll
    static void read() throws IOException {
        document = Files.readString(ROOT.resolve("CONTRIBUTING.md"));
    }

    private static List<String> matches(Pattern pattern) {
        return pattern.matcher(document).results().map(r -> r.group(1)).toList();
    }

    @Test
    void everyFileThatIsNamedOrLinkedExists() {
        Set<String> missing = new TreeSet<>();
        int named = 0;
        for (String path : Stream.concat(
                        matches(CODE).stream().filter(c -> c.matches("(src|docs|scenes|\\.ci)/\\S+")),
                        matches(LINK).stream())
                .toList()) {
            named++;
            if (!Files.exists(ROOT.resolve(path))) {
                missing.add(path);
            }
        }
        assertEquals(Set.of(), missing);
        assertTrue(named > 50, named + " files");
    }

    @Test
    void everyTestThatIsNamedExists() throws IOException {
        Set<String> tests;
        try (Stream<Path> files = Files.walk(ROOT.resolve("src/test/java"))) {
            tests = files.map(f -> f.getFileName().toString().replace(".java", ""))
                    .collect(Collectors.toSet());
        }
        Set<String> named = new TreeSet<>(
                matches(CODE).stream().filter(c -> c.matches("[A-Z]\\w*Test")).toList());
        assertTrue(named.size() > 10, named.toString());
        named.removeAll(tests);
        assertEquals(Set.of(), named);
    }

    @Test
    void everySealedFamilyOfTheSceneFormatHasItsList() throws IOException {
        Set<String> readers = new TreeSet<>();
        Path json = ROOT.resolve("src/main/java/enlightenment/scene/json");
        try (Stream<Path> files = Files.list(json)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                if (Files.readString(file).contains("> FAMILY = new Family<")) {
                    readers.add("src/main/java/enlightenment/scene/json/" + file.getFileName());
                }
            }
        }
        assertEquals(6, readers.size(), readers.toString());
        Set<String> listed = new TreeSet<>(readers);
        listed.retainAll(matches(CODE));
        assertEquals(readers, listed);
    }

    @Test
    void everyProfileOfTheBuildIsListed() throws IOException {
        String pom = Files.readString(ROOT.resolve("pom.xml"));
        Set<String> profiles = new TreeSet<>();
        Matcher profile = Pattern.compile("<profile>(?:\\s|<!--(?s:.*?)-->)*<id>([^<]+)</id>")
                .matcher(pom);
        while (profile.find()) {
            profiles.add(profile.group(1));
        }
        assertTrue(profiles.contains("bench"), profiles.toString());
        String table = document.substring(document.indexOf("### Profiles"), document.indexOf("## House rules"));
        Set<String> listed = new TreeSet<>();
        table.lines().filter(l -> l.startsWith("| `")).forEach(l -> listed.add(l.split("`")[1]));
        assertEquals(profiles, listed);
    }
}
