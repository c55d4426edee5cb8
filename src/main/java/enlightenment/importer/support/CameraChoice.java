package enlightenment.importer.support;

import enlightenment.text.Plain;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * Finds a camera of a file by its number, from 0, or else by its name.
 *
 * @param wanted the number or the name; empty for the first camera
 */
public record CameraChoice(Optional<String> wanted) {
    private static final int MOST_LISTED = 10;

    /**
     * The number of the camera that is wanted.
     *
     * @param names the names of the file's cameras in its order, "" for those without
     * @return 0 where none is wanted
     * @throws IOException naming the cameras that there are, if there is no such one
     */
    public int index(List<String> names) throws IOException {
        if (wanted.isEmpty()) {
            return 0;
        }
        String text = wanted.get();
        int index = text.matches("[0-9]{1,9}") ? Integer.parseInt(text) : names.indexOf(text);
        if (index < 0 || index >= names.size()) {
            throw new IOException("has no camera " + Plain.quoted(text) + "; " + listed(names));
        }
        return index;
    }

    /** The choice in a file of a format that has one camera at most. */
    public void requireIn(Optional<?> camera) throws IOException {
        index(Collections.nCopies(camera.isPresent() ? 1 : 0, ""));
    }

    private static String listed(List<String> names) {
        if (names.isEmpty()) {
            return "it has none";
        }
        List<String> all = new ArrayList<>();
        for (int i = 0; i < Math.min(names.size(), MOST_LISTED); i++) {
            all.add(i + (names.get(i).isEmpty() ? "" : " " + Plain.quoted(names.get(i))));
        }
        return "its cameras are " + String.join(", ", all)
                + (names.size() > MOST_LISTED ? " and " + (names.size() - MOST_LISTED) + " more" : "");
    }
}
