package enlightenment.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The pages lead where they say: to files that are there, and to headings that are on them. */
class LinksTest {
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#+ +(.+)$");
    private static final Pattern CODE = Pattern.compile("(?s)```.*?```");
    private static final Pattern TEST = Pattern.compile("`([A-Z]\\w+(?:Test|IT))`");

    private static List<Path> pages() throws IOException {
        List<Path> pages = new ArrayList<>(List.of(Path.of("README.md")));
        try (Stream<Path> docs = Files.walk(Path.of("docs"))) {
            docs.filter(p -> p.toString().endsWith(".md")).sorted().forEach(pages::add);
        }
        return pages;
    }

    private static String text(Path page) throws IOException {
        return CODE.matcher(Files.readString(page)).replaceAll("");
    }

    /** As repository sites make them: lower case, spaces become hyphens, punctuation goes. */
    private static Set<String> anchors(Path page) throws IOException {
        Set<String> anchors = new HashSet<>();
        Matcher m = HEADING.matcher(text(page));
        while (m.find()) {
            String plain = m.group(1).toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N} _-]", "");
            anchors.add(plain.strip().replace(' ', '-'));
        }
        return anchors;
    }

    @Test
    void everyRelativeLinkLeadsSomewhere() throws IOException {
        List<String> broken = new ArrayList<>();
        int links = 0;
        for (Path page : pages()) {
            Matcher m = LINK.matcher(text(page));
            while (m.find()) {
                String link = m.group(1);
                if (!link.matches("[a-z]+:.*")) {
                    links++;
                    String file = link.replaceFirst("#.*", "");
                    Path target = file.isEmpty() ? page : page.resolveSibling(file);
                    String anchor = link.contains("#") ? link.substring(link.indexOf('#') + 1) : "";
                    if (!Files.exists(target)
                            || !anchor.isEmpty() && !anchors(target).contains(anchor)) {
                        broken.add(page + ": " + link);
                    }
                }
            }
        }
        assertTrue(links > 100, links + " links: the pattern finds no links any more");
        assertEquals(List.of(), broken);
    }

    @Test
    void everyTestThatAPageNamesIsThere() throws IOException {
        Set<String> tests = new HashSet<>();
        try (Stream<Path> sources = Files.walk(Path.of("src"))) {
            sources.map(p -> p.getFileName().toString())
                    .filter(n -> n.endsWith(".java"))
                    .forEach(n -> tests.add(n.replace(".java", "")));
        }
        List<String> missing = new ArrayList<>();
        int named = 0;
        for (Path page : pages()) {
            Matcher m = TEST.matcher(text(page));
            while (m.find()) {
                named++;
                if (!tests.contains(m.group(1))) {
                    missing.add(page + ": " + m.group(1));
                }
            }
        }
        assertTrue(named > 50, named + " tests named: the pattern finds them no more");
        assertEquals(List.of(), missing);
    }
}
