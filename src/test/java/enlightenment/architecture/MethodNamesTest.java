package enlightenment.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The names of our methods stand in {@link BuiltInMethod} and nowhere else in the code. */
class MethodNamesTest {
    private static final Path SOURCES = Path.of("src/main/java");

    /** A string literal with an escape, or a comment, which may say what it likes. */
    private static final Pattern LITERAL_OR_COMMENT =
            Pattern.compile("(\"(?:[^\"\\\\\\n]|\\\\.)*\")|//[^\\n]*|/\\*(?s:.*?)\\*/|'(?:[^'\\\\\\n]|\\\\.)+'");

    /** Names that are words of any sentence about rendering: they are names where they follow the word "method". */
    private static final Set<Method> WORDS = Set.of(BuiltInMethod.LIGHT);

    private static final Pattern NAME =
            Pattern.compile("\\b(?:" + names(false) + ")\\b|\\bmethod\\W+(?:" + names(true) + ")\\b");

    private static String names(boolean areWords) {
        return BuiltInMethod.ALL.stream()
                .filter(m -> WORDS.contains(m) == areWords)
                .map(Method::word)
                .collect(Collectors.joining("|"));
    }

    private static List<String> literalsWithNames(String source) {
        List<String> found = new ArrayList<>();
        Matcher literal = LITERAL_OR_COMMENT.matcher(source);
        while (literal.find()) {
            if (literal.group(1) != null && NAME.matcher(literal.group(1)).find()) {
                found.add(literal.group(1));
            }
        }
        return found;
    }

    @Test
    void noNameOfAMethodStandsInALiteralOutsideTheRegistry() throws IOException {
        List<String> found = new ArrayList<>();
        List<Path> files;
        try (Stream<Path> all = Files.walk(SOURCES)) {
            files = all.filter(f -> f.toString().endsWith(".java")).sorted().toList();
        }
        Path registry = SOURCES.resolve("enlightenment/scene/BuiltInMethod.java");
        for (Path file : files) {
            for (String literal : literalsWithNames(Files.readString(file))) {
                if (!file.equals(registry)) {
                    found.add(SOURCES.relativize(file) + ": " + literal);
                }
            }
        }
        assertEquals(List.of(), found);
        String text = Files.readString(registry);
        assertEquals(
                BuiltInMethod.ALL.size() - WORDS.size(), literalsWithNames(text).size());
        for (Method word : WORDS) {
            assertEquals(2, text.split("\"" + word.word() + "\"", -1).length);
        }
    }

    @Test
    void theSearchFindsLiteralsAndPassesOverComments() {
        String name = BuiltInMethod.RAYTRACE.word();
        assertEquals(
                List.of("\"\\\"take " + name + "\""),
                literalsWithNames("/* \"" + name + "\" */ // \"" + name + "\"\nf('\"', \"\\\"take " + name + "\");"));
        assertEquals(
                List.of("\"--method light\""),
                literalsWithNames("f(\"--method light\", \"light\", \"the light of a lamp\")"));
        assertTrue(literalsWithNames("\"" + name + "s\" + " + name).isEmpty());
    }
}
