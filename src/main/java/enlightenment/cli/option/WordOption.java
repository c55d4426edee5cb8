package enlightenment.cli.option;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.ITypeConverter;

/** An option's values where there are only a few, each with a word: converts the words, and lists them for completion. */
public abstract class WordOption<T> implements ITypeConverter<T>, Iterable<String> {
    private final List<T> values;

    protected WordOption(List<T> values) {
        this.values = values;
    }

    /** The values, in order. */
    protected List<T> all() {
        return values;
    }

    /** The value of a word; empty if there is none. */
    protected Optional<T> find(String word) {
        for (T value : all()) {
            if (word(value).equals(word)) {
                return Optional.of(value);
            }
        }
        return Optional.empty();
    }

    /** The word for a value. */
    protected String word(T value) {
        return value.toString();
    }

    final List<String> words() {
        List<String> words = new ArrayList<>();
        for (T value : all()) {
            words.add(word(value));
        }
        return words;
    }

    @Override
    public final T convert(String text) {
        Optional<T> value = find(text);
        if (value.isEmpty()) {
            throw BadValue.expected("one of " + String.join(", ", words()), text);
        }
        return value.get();
    }

    @Override
    public final Iterator<String> iterator() {
        return words().iterator();
    }
}
