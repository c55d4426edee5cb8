package enlightenment.text;

import java.util.Collection;
import java.util.Locale;
import java.util.stream.Collectors;

/** Guesses what somebody meant to write. */
public final class Suggestion {
    private static final int MOST_LISTED = 20;

    private Suggestion() {}

    /**
     * A half sentence about what could have been written: {@code ; did you mean "radius"?}, or the list of what there
     * is, beginning with {@code introduction}.
     */
    public static String of(String written, Collection<String> valid, String introduction) {
        String best = nearest(written, valid);
        if (best != null) {
            return "; did you mean \"" + best + "\"?";
        }
        return valid.isEmpty() ? "" : "; " + introduction + " " + list(valid);
    }

    /** Names in quotes, separated by commas, cut where there are many. */
    public static String list(Collection<String> names) {
        String shown = names.stream().limit(MOST_LISTED).map(Plain::quoted).collect(Collectors.joining(", "));
        return names.size() > MOST_LISTED ? shown + " and " + (names.size() - MOST_LISTED) + " more" : shown;
    }

    /**
     * The valid word for what other renderers call so, or the nearest one; null if there is none: at most a third of the letters may differ.
     */
    public static String nearest(String written, Collection<String> valid) {
        String synonym = Synonyms.of(written, valid);
        return synonym == null ? nearestSpelling(written, valid) : synonym;
    }

    private static String nearestSpelling(String written, Collection<String> valid) {
        String a = written.toLowerCase(Locale.ROOT);
        String best = null;
        int least = Integer.MAX_VALUE;
        for (String candidate : valid) {
            String b = candidate.toLowerCase(Locale.ROOT);
            int longer = Math.max(a.length(), b.length());
            int allowed = longer < 3 ? 0 : Math.max(1, longer / 3);
            if (Math.abs(a.length() - b.length()) > allowed || a.length() > 200) {
                continue;
            }
            int d = distance(a, b);
            if (d <= allowed && d < least) {
                least = d;
                best = candidate;
            }
        }
        return best;
    }

    /** Edit distance: insertions, deletions, substitutions and swaps of neighbours (optimal string alignment). */
    static int distance(String a, String b) {
        int[] before = new int[b.length() + 1];
        int[] last = new int[b.length() + 1];
        int[] now = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            last[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            now[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int same = a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1;
                int d = Math.min(Math.min(now[j - 1], last[j]) + 1, last[j - 1] + same);
                boolean swapped =
                        i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1);
                now[j] = swapped ? Math.min(d, before[j - 2] + 1) : d;
            }
            int[] free = before;
            before = last;
            last = now;
            now = free;
        }
        return last[b.length()];
    }
}
