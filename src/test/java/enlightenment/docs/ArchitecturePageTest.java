package enlightenment.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The table of packages in docs/architecture.md is that of the sources, in an order in which each uses only those above it. */
class ArchitecturePageTest {
    private static final Path SOURCES = Path.of("src/main/java/enlightenment");
    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/");
    private static final Pattern USE = Pattern.compile("\\benlightenment\\.([a-z]+(?:\\.[a-z]+)*)\\.[A-Z]");

    /** Packages with a number for their row, which increases. */
    private static Map<String, Integer> rows() throws IOException {
        Map<String, Integer> rows = new TreeMap<>();
        for (PackageTable.Row row : PackageTable.rows(Path.of(""))) {
            int number = rows.size() + 1;
            row.names().forEach(name -> rows.put(name, number));
        }
        return rows;
    }

    private static Map<String, Set<String>> uses() throws IOException {
        Map<String, Set<String>> uses = new TreeMap<>();
        try (Stream<Path> files = Files.walk(SOURCES)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
                String name = SOURCES.relativize(file.getParent())
                        .toString()
                        .replace('\\', '.')
                        .replace('/', '.');
                Set<String> used = uses.computeIfAbsent(name, n -> new TreeSet<>());
                Matcher m = USE.matcher(COMMENT.matcher(Files.readString(file)).replaceAll(""));
                while (m.find()) {
                    used.add(m.group(1));
                }
                used.remove(name);
            }
        }
        return uses;
    }

    @Test
    void theTableNamesEveryPackageAndNoOther() throws IOException {
        assertEquals(uses().keySet(), rows().keySet());
    }

    @Test
    void aPackageUsesOnlyPackagesAboveIt() throws IOException {
        Map<String, Integer> rows = rows();
        List<String> upwards = new ArrayList<>();
        int compared = 0;
        for (Map.Entry<String, Set<String>> e : uses().entrySet()) {
            for (String used : e.getValue()) {
                compared++;
                if (rows.getOrDefault(used, 0) >= rows.getOrDefault(e.getKey(), 0)) {
                    upwards.add(e.getKey() + " uses " + used);
                }
            }
        }
        assertEquals(List.of(), upwards);
        assertTrue(compared > 100, compared + " uses found");
    }
}
