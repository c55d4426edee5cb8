package enlightenment.importer.support;

import enlightenment.text.Plain;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * Finds one of several entries of a file by its number, from 0, or else by its name.
 *
 * @param kind what they are called, such as {@code "camera"}
 * @param wanted the number or the name; empty for the first one
 */
public record NamedChoice(String kind, Optional<String> wanted) {
    private static final int MOST_LISTED = 10;

    /** The choice of a camera. */
    public static NamedChoice camera(Optional<String> wanted) {
        return new NamedChoice("camera", wanted);
    }

    /** The choice of an animation. */
    public static NamedChoice animation(Optional<String> wanted) {
        return new NamedChoice("animation", wanted);
    }

    /**
     * The number of the entry that is wanted.
     *
     * @param names the names in the order of the file, "" for entries without
     * @return 0 where none is wanted
     * @throws IOException listing the entries that there are, if there is no such one
     */
    public int index(List<String> names) throws IOException {
        if (wanted.isEmpty()) {
            return 0;
        }
        String text = wanted.get();
        int index = text.matches("[0-9]{1,9}") ? Integer.parseInt(text) : names.indexOf(text);
        if (index < 0 || index >= names.size()) {
            throw new IOException("has no " + kind + " " + Plain.quoted(text) + "; " + listed(names));
        }
        return index;
    }

    /** The choice in a file of a format that has one such entry at most. */
    public void requireIn(Optional<?> only) throws IOException {
        index(Collections.nCopies(only.isPresent() ? 1 : 0, ""));
    }

    private String listed(List<String> names) {
        if (names.isEmpty()) {
            return "it has none";
        }
        List<String> all = new ArrayList<>();
        for (int i = 0; i < Math.min(names.size(), MOST_LISTED); i++) {
            all.add(shown(names, i));
        }
        return "its " + kind + "s are " + String.join(", ", all)
                + (names.size() > MOST_LISTED ? " and " + (names.size() - MOST_LISTED) + " more" : "");
    }

    /** A number with the name that belongs to it, if there is one. */
    public static String shown(List<String> names, int index) {
        return index + (names.get(index).isEmpty() ? "" : " " + Plain.quoted(names.get(index)));
    }
}
