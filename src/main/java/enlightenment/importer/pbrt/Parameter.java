package enlightenment.importer.pbrt;

import java.util.List;

/**
 * A parameter: {@code "type name" [values]}.
 *
 * @param type its type as it is written, such as {@code rgb}
 * @param name its name
 * @param numbers its values, if they are numbers
 * @param words its values, if they are strings or bare words
 * @param place where it stands
 */
record Parameter(String type, String name, double[] numbers, List<String> words, Place place) {
    int size() {
        return numbers.length + words.size();
    }
}
