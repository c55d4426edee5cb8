package enlightenment.cli;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import picocli.CommandLine.ITypeConverter;

/** An option's values where there are only a few, each with a word: converts the words, and lists them for completion. */
abstract class WordOption<T> implements ITypeConverter<T>, Iterable<String> {
    private final List<T> values;

    WordOption(List<T> values) {
        this.values = values;
    }

    /** The word for a value. */
    String word(T value) {
        return value.toString();
    }

    final List<String> words() {
        List<String> words = new ArrayList<>();
        for (T value : values) {
            words.add(word(value));
        }
        return words;
    }

    @Override
    public final T convert(String text) {
        for (T value : values) {
            if (word(value).equals(text)) {
                return value;
            }
        }
        throw BadValue.expected("one of " + String.join(", ", words()), text);
    }

    @Override
    public final Iterator<String> iterator() {
        return words().iterator();
    }
}
