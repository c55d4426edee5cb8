package enlightenment.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The pages of the guide, and the blocks of code on them. */
public final class GuidePages {
    private GuidePages() {}

    /** All pages of the guide, the README of the project among them. */
    public static List<Path> all() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("docs/guide"))) {
            return Stream.concat(
                            Stream.of(Path.of("README.md")),
                            files.filter(f -> f.toString().endsWith(".md")).sorted())
                    .toList();
        }
    }

    /** The text of the blocks of a language on a page, in their order. */
    public static List<String> blocks(Path page, String language) throws IOException {
        return Pattern.compile("(?ms)^```" + language + "\n(.*?)^```$")
                .matcher(Files.readString(page))
                .results()
                .map(m -> m.group(1))
                .toList();
    }
}
