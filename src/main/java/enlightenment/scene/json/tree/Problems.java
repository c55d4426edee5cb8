package enlightenment.scene.json.tree;

import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Collector of the problems of a file, which one exception reports together. */
public final class Problems {
    /** The most problems kept, so that a wrong file of a million objects does not fill the memory with messages. */
    public static final int MOST_KEPT = 1000;

    private final String file;
    private final String remark;
    private final List<Problem> kept = new ArrayList<>();
    private int count;

    /**
     * @param file name of the file in messages
     * @param remark text appended to each message, such as the frame; may be ""
     */
    public Problems(String file, String remark) {
        this.file = file;
        this.remark = remark;
    }

    /** An empty collector for a part of the same file, to be {@linkplain #add(Problems) added} later. */
    public Problems ofPart() {
        return new Problems(file, remark);
    }

    /** Adds the problems of a part. */
    public void add(Problems part) {
        for (Problem p : part.kept) {
            if (kept.size() < MOST_KEPT) {
                kept.add(p);
            }
        }
        count += part.count;
    }

    /** The number of problems so far, those not kept included. */
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

    /** Throws a {@link enlightenment.scene.SceneException} with all problems, in the order of the text, if there are any. */
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
