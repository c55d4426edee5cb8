package enlightenment.importer.support;

import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Collects what a reader leaves out or approximates. The same thing in many places is one note. */
public final class ImportNotes {
    private static final int PLACES_SHOWN = 3;
    private static final int MOST_NOTES = 1000;

    /** Places of a note: the first ones, and how many there are. */
    private static final class Places {
        final List<String> shown = new ArrayList<>();
        int count;
    }

    private final Map<String, Places> placesByMessage = new LinkedHashMap<>();

    /** No notes yet. */
    public ImportNotes() {}

    /**
     * Adds a note; beyond 1,000 different ones they are dropped.
     *
     * @param place where it is in the file, such as {@code "line 12"} or {@code "nodes/3"}; "" for the file as a whole
     * @param message what is left out, or what it became instead; names from the file are made harmless here
     */
    public void add(String place, String message) {
        String text = Plain.lines(message);
        if (placesByMessage.size() >= MOST_NOTES && !placesByMessage.containsKey(text)) {
            return;
        }
        Places places = placesByMessage.computeIfAbsent(text, m -> new Places());
        places.count++;
        if (places.shown.size() < PLACES_SHOWN && !place.isEmpty()) {
            places.shown.add(Plain.lines(place));
        }
    }

    /** The notes, in the order in which they were first made, each beginning with its places. */
    public List<String> list() {
        return placesByMessage.entrySet().stream()
                .map(e -> shown(e.getValue()) + e.getKey())
                .toList();
    }

    private static String shown(Places places) {
        if (places.shown.isEmpty()) {
            return "";
        }
        int more = places.count - places.shown.size();
        return String.join(", ", places.shown) + (more > 0 ? " and " + more + " more" : "") + ": ";
    }
}
