package enlightenment.scene.json.tree;

import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Collects what is wrong with a file, so that one exception reports all of it. */
public final class Problems {
    /** More than anybody reads; keeps a wrong file of a million objects from filling the memory with messages. */
    public static final int MOST_KEPT = 1000;

    private final String file;
    private final String remark;
    private final List<Problem> kept = new ArrayList<>();
    private int count;

    /**
     * @param file name for messages
     * @param remark appended to each message: what else is to be known, such as the frame, or ""
     */
    public Problems(String file, String remark) {
        this.file = file;
        this.remark = remark;
    }

    /** An empty collection for a part of the same file, to be {@linkplain #add(Problems) added} in its turn. */
    public Problems ofPart() {
        return new Problems(file, remark);
    }

    /** Adds what was found in a part. */
    public void add(Problems part) {
        for (Problem p : part.kept) {
            if (kept.size() < MOST_KEPT) {
                kept.add(p);
            }
        }
        count += part.count;
    }

    /** The number of problems so far. If it stays equal, the calls in between found none. */
    public int count() {
        return count;
    }

    public void add(JsonValue at, JsonPointer place, String message) {
        add(at.line, at.column, place.toString(), message);
    }

    public void add(int line, int column, String pointer, String message) {
        if (count++ < MOST_KEPT) {
            kept.add(new Problem(file, line, column, pointer, message + remark));
        }
    }

    /** Fails if anything was wrong. */
    public void throwIfAny() {
        if (count == 0) {
            return;
        }
        List<Problem> sorted = new ArrayList<>(kept);
        sorted.sort(Comparator.comparingInt(Problem::line).thenComparingInt(Problem::column));
        if (count > MOST_KEPT) {
            sorted.add(new Problem(file, 0, 0, "", "and " + (count - MOST_KEPT) + " more problems"));
        }
        throw new SceneException(sorted);
    }
}
