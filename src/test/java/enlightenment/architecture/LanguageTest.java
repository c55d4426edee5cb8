package enlightenment.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Sources and pages speak the English of the field. What a machine can hold of that: phrases of an older dialect may become fewer, never
 * more. The tables are debts: removing a phrase lowers its number here.
 */
class LanguageTest {
    private static final Path ROOT = Path.of(System.getProperty("project.directory"));

    /** By phrase: how often main sources have it. */
    private static final Map<String, Integer> IN_SOURCES = Map.ofEntries(
            Map.entry("so many", 0),
            Map.entry("for who", 0),
            Map.entry("whoever", 0),
            Map.entry("nobody", 0),
            Map.entry("nobodys", 0),
            Map.entry("business of", 0),
            Map.entry("left to chance", 0),
            Map.entry("is told", 0),
            Map.entry("are told", 0),
            Map.entry("tells that", 0),
            Map.entry("dear", 0),
            Map.entry("as likely as", 0),
            Map.entry("/\\*\\* (?:The same|As above)", 0));

    /** By phrase: how often pages have it, the list of changes aside. */
    private static final Map<String, Integer> IN_PAGES = Map.ofEntries(
            Map.entry("so many", 0),
            Map.entry("for who", 0),
            Map.entry("whoever", 0),
            Map.entry("nobody", 0),
            Map.entry("nobodys", 0),
            Map.entry("business of", 0),
            Map.entry("left to chance", 0),
            Map.entry("is told", 0),
            Map.entry("are told", 0),
            Map.entry("tells that", 0),
            Map.entry("dear", 0),
            Map.entry("as likely as", 0));

    private static String text(Path folder, String ending) throws IOException {
        StringBuilder all = new StringBuilder();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(f -> f.toString().endsWith(ending)
                            && !f.endsWith("changes.md")
                            && !f.toString().contains("decisions"))
                    .sorted()
                    .toList()) {
                all.append(Files.readString(file)).append('\n');
            }
        }
        return all.toString();
    }

    private static Map<String, Integer> count(Map<String, Integer> phrases, String text) {
        // Lines of comments are joined, so that a phrase is found wherever it is broken.
        String joined = text.replaceAll("\\s+(?:\\*\\s+)?", " ");
        Map<String, Integer> counts = new LinkedHashMap<>();
        for (String phrase : phrases.keySet()) {
            String bounds = phrase.startsWith("/") ? phrase : "\\b" + phrase + "\\b";
            counts.put(phrase, (int) Pattern.compile(bounds, Pattern.CASE_INSENSITIVE)
                    .matcher(joined)
                    .results()
                    .count());
        }
        return counts;
    }

    @Test
    void sourcesSpeakTheLanguageOfTheField() throws IOException {
        String sources = text(ROOT.resolve("src/main/java"), ".java");
        assertTrue(sources.length() > 1_000_000, "the sources were read");
        assertEquals(IN_SOURCES, count(IN_SOURCES, sources));
    }

    @Test
    void pagesSpeakTheLanguageOfTheField() throws IOException {
        String pages = text(ROOT.resolve("docs"), ".md")
                + Files.readString(ROOT.resolve("README.md"))
                + Files.readString(ROOT.resolve("CONTRIBUTING.md"));
        assertEquals(IN_PAGES, count(IN_PAGES, pages));
    }
}
