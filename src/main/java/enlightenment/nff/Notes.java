package enlightenment.nff;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Collects what is left out; the same thing in many places is one note. */
final class Notes {
    private static final int LINES_SHOWN = 3;

    private final Map<String, List<Integer>> linesByMessage = new LinkedHashMap<>();

    void add(NffToken at, String message) {
        linesByMessage.computeIfAbsent(message, m -> new ArrayList<>()).add(at.line());
    }

    /** In the order of their first lines. */
    List<String> list() {
        return linesByMessage.entrySet().stream()
                .sorted(Comparator.comparing(e -> e.getValue().get(0)))
                .map(e -> show(e.getValue()) + ": " + e.getKey())
                .toList();
    }

    private static String show(List<Integer> lines) {
        StringBuilder s = new StringBuilder(lines.size() == 1 ? "line " : "lines ");
        int shown = Math.min(lines.size(), LINES_SHOWN);
        for (int i = 0; i < shown; i++) {
            boolean lastOfAll = i > 0 && i == lines.size() - 1;
            s.append(i == 0 ? "" : lastOfAll ? " and " : ", ").append(lines.get(i));
        }
        if (lines.size() > shown) {
            s.append(" and ").append(lines.size() - shown).append(" more");
        }
        return s.toString();
    }
}
