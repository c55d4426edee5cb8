package enlightenment.scene.json.tree;

import enlightenment.scene.SceneException.Problem;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Finds the lines of problems that were seen only when a scene was put together, by reading its text once more. */
public final class Places {
    private final Set<Integer> objects = new HashSet<>();

    private Places(List<Problem> problems) {
        for (Problem p : problems) {
            List<String> tokens = JsonPointer.parse(p.pointer());
            if (tokens != null && tokens.size() > 1 && tokens.get(0).equals("objects")) {
                // What is no number of an object leads to none.
                objects.add(tokens.get(1).matches("[0-9]{1,9}") ? Integer.parseInt(tokens.get(1)) : -1);
            }
        }
    }

    /**
     * The problems, each with line and column of its value. A problem that has a line or no pointer stays; a missing value gets its
     * parent's place.
     */
    public static List<Problem> find(List<Problem> problems, JsonTree.Source source) {
        if (problems.stream().allMatch(p -> p.line() > 0 || p.pointer().isEmpty())) {
            return problems;
        }
        JsonValue root = JsonTree.parse(source, new Problems("", ""), new Places(problems).sink());
        // A file that has changed meanwhile has other places, or none.
        return root == null
                ? problems
                : problems.stream().map(p -> located(p, root)).toList();
    }

    private static Problem located(Problem p, JsonValue root) {
        List<String> tokens = JsonPointer.parse(p.pointer());
        if (p.line() > 0 || tokens == null || tokens.isEmpty()) {
            return p;
        }
        JsonValue at = JsonPointer.nearest(root, tokens);
        return new Problem(p.file(), at.line, at.column, p.pointer(), p.message());
    }

    /** Keeps the objects with problems only: a scene may have millions. */
    private JsonTree.ObjectSink sink() {
        return new JsonTree.ObjectSink() {
            @Override
            public void begin(JsonValue.Obj before) {
                // All that is kept is in the tree.
            }

            @Override
            public JsonValue take(int index, JsonValue v) {
                return objects.contains(index) ? v : null;
            }
        };
    }
}
