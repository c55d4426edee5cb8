package enlightenment.scene.json;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The keys of one part of a scene. The schema and {@code docs/guide/scene-format.md} say the same; tests hold them together.
 *
 * @param schemaName the part's name in the schema's {@code $defs}
 * @param noun the part's name in messages, with its article
 * @param required required keys
 * @param optional optional keys
 */
record Keys(String schemaName, String noun, List<String> required, List<String> optional) {
    /** The keys of a part, from words separated by blanks. */
    static Keys of(String schemaName, String noun, String required, String optional) {
        return new Keys(schemaName, noun, words(required), words(optional));
    }

    private static List<String> words(String text) {
        return text.isBlank() ? List.of() : Arrays.asList(text.trim().split("\\s+"));
    }

    List<String> all() {
        List<String> all = new ArrayList<>(required);
        all.addAll(optional);
        return all;
    }

    boolean has(String key) {
        return required.contains(key) || optional.contains(key);
    }
}
