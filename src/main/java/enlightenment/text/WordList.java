package enlightenment.text;

import java.util.List;
import java.util.stream.Collectors;

/** Lists of words in sentences. */
public final class WordList {
    private WordList() {}

    /**
     * {@code a}, {@code a or b}, {@code a, b or c}.
     *
     * @param words at least one
     * @param conjunction what stands before the last one
     */
    public static String join(List<String> words, String conjunction) {
        String last = words.get(words.size() - 1);
        String others = words.stream().limit(words.size() - 1L).collect(Collectors.joining(", "));
        return others.isEmpty() ? last : others + " " + conjunction + " " + last;
    }
}
