package enlightenment.scene.json;

import java.util.Locale;

/** What a misspelt name may have been meant to be. */
final class Suggestions {
    private Suggestions() {}

    /** The name with the least edit distance to {@code found}, or null where none is near. */
    static String nearest(String found, Iterable<String> names) {
        String nearest = null;
        int least = Integer.MAX_VALUE;
        String a = found.toLowerCase(Locale.ROOT);
        for (String name : names) {
            String b = name.toLowerCase(Locale.ROOT);
            // Two letters in five may differ: "rotate" still finds "rotation", "size" does not find "type".
            int allowed = Math.max(1, Math.max(a.length(), b.length()) * 2 / 5);
            if (a.length() > 100 || Math.abs(a.length() - b.length()) > Math.min(allowed, least - 1)) {
                continue;
            }
            int distance = distance(a, b);
            if (distance <= allowed && distance < least) {
                least = distance;
                nearest = name;
            }
        }
        return nearest;
    }

    /** How many letters must be inserted, removed or replaced to turn one word into the other (Levenshtein). */
    static int distance(String a, String b) {
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(replaced, Math.min(row[j], row[j - 1]) + 1);
            }
        }
        return row[b.length()];
    }
}
