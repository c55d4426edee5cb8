package enlightenment.image;

import enlightenment.check.Check;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * How a PNG file is written.
 *
 * @param depth bits per component: 8 or 16
 * @param text comments, keyword to text, written in the map's order. A keyword has 1..79 printable Latin-1 characters and
 *     no space at its ends nor two in a row (PNG specification, 11.3.4.2); a text has no NUL character
 */
public record PngOptions(int depth, Map<String, String> text) {
    /** 8 bits per component, no comments. */
    public static final PngOptions DEFAULT = new PngOptions(8, Map.of());

    /** @throws IllegalArgumentException if the depth, a keyword or a text is not allowed */
    public PngOptions {
        Check.that(depth == 8 || depth == 16, "depth", "must be 8 or 16 bits per component, not " + depth);
        text = Collections.unmodifiableMap(new LinkedHashMap<>(text));
        text.forEach(PngOptions::check);
    }

    /** These options with another depth. */
    public PngOptions withDepth(int newDepth) {
        return new PngOptions(newDepth, text);
    }

    /** These options with one more comment at the end, or another text for a keyword that is there. */
    public PngOptions withText(String keyword, String value) {
        Map<String, String> extended = new LinkedHashMap<>(text);
        extended.put(keyword, value);
        return new PngOptions(depth, extended);
    }

    private static void check(String keyword, String value) {
        boolean printable = keyword.chars().allMatch(c -> c >= 32 && c <= 126 || c >= 161 && c <= 255);
        if (!printable || keyword.isEmpty() || keyword.length() > 79) {
            throw new IllegalArgumentException(
                    "the keyword of a PNG comment has 1 to 79 printable Latin-1 characters, unlike \"" + keyword
                            + "\"");
        }
        if (keyword.startsWith(" ") || keyword.endsWith(" ") || keyword.contains("  ")) {
            throw new IllegalArgumentException(
                    "the keyword of a PNG comment has single spaces only between words, unlike \"" + keyword + "\"");
        }
        if (value.indexOf('\0') >= 0) {
            throw new IllegalArgumentException("the PNG comment \"" + keyword + "\" contains a NUL character");
        }
    }
}
