package enlightenment.scene;

import java.util.List;
import java.util.Objects;

/** Lists of descriptions that programs make: an exception names the entry that is missing. */
final class Present {
    private Present() {}

    /**
     * An immutable copy.
     *
     * @param key what the list is called
     * @param what what one of its entries is called
     * @throws NullPointerException if it or one of its entries is missing; the message says which, counted from 0
     */
    static <T> List<T> list(String key, String what, List<T> entries) {
        Objects.requireNonNull(entries, key);
        int index = 0;
        for (T entry : entries) {
            if (entry == null) {
                throw new NullPointerException("the " + what + " " + index);
            }
            index++;
        }
        return List.copyOf(entries);
    }
}
