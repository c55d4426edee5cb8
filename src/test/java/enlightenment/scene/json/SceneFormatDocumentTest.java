package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.Method;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Holds {@code docs/scene-format.md} and the reader together. */
class SceneFormatDocumentTest {
    private static String document() throws IOException {
        return Files.readString(Documents.projectFolder().resolve("docs/scene-format.md"));
    }

    @Test
    void theExampleIsAScene() throws IOException {
        String document = document();
        int start = document.indexOf("```jsonc\n") + "```jsonc\n".length();
        String example = document.substring(start, document.indexOf("```", start));
        assertEquals(3, Documents.read(example, Path.of("")).objects().size());
    }

    @Test
    void everyKeyTypeAndWordIsExplained() throws IOException {
        String document = document();
        Stream<String> keys = Vocabulary.all().stream().flatMap(k -> k.all().stream());
        Stream<String> words = Stream.of(
                        Vocabulary.CAMERAS.keySet(),
                        Vocabulary.OBJECTS.keySet(),
                        Vocabulary.MATERIALS.keySet(),
                        Vocabulary.LIGHTS.keySet(),
                        Vocabulary.TEXTURES.keySet(),
                        Vocabulary.PLANNED_OBJECTS,
                        Vocabulary.PLANNED_MATERIALS,
                        Vocabulary.PLANNED_LIGHT_KEYS,
                        Vocabulary.PLANNED_SHADING_KEYS)
                .flatMap(w -> w.stream());
        List<String> missing = Stream.concat(keys, words)
                .distinct()
                .filter(w -> !document.contains("`" + w + "`") && !document.contains("\"" + w + "\": "))
                .toList();
        assertEquals(List.of(), missing);
        Stream.of(Method.words(), Vocabulary.FILTERS, Vocabulary.ENCODINGS)
                .flatMap(List::stream)
                .forEach(w -> assertTrue(document.contains("`\"" + w + "\"`"), w));
    }
}
