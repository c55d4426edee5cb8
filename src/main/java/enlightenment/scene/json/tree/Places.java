package enlightenment.scene.json.tree;

import enlightenment.scene.SceneException.Problem;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Finds the lines of problems that were detected after parsing, by parsing the text once more. */
public final class Places {
    private final Set<Integer> objects = new HashSet<>();

    private Places(List<Problem> problems) {
        for (Problem p : problems) {
            List<String> tokens = JsonPointer.parse(p.pointer());
            if (tokens != null && tokens.size() > 1 && tokens.get(0).equals("objects")) {
                // −1 matches no object: the pointer has no valid index.
                objects.add(tokens.get(1).matches("[0-9]{1,9}") ? Integer.parseInt(tokens.get(1)) : -1);
            }
        }
    }

    /**
     * The problems with line and column of their values. A problem that has a line or no pointer is unchanged; a missing value has the place of its
     * parent.
     */
    public static List<Problem> find(List<Problem> problems, JsonTree.Source source) {
        if (problems.stream().allMatch(p -> p.line() > 0 || p.pointer().isEmpty())) {
            return problems;
        }
        JsonValue root = JsonTree.parse(source, new Problems("", ""), new Places(problems).sink());
        // If the file has changed meanwhile, places may be wrong or missing.
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

    /** A sink that keeps only objects with problems, as a scene may have millions. */
    private JsonTree.ObjectSink sink() {
        return new JsonTree.ObjectSink() {
            @Override
            public void begin(JsonValue.Obj before) {
                // Nothing to do: kept objects stay in the tree.
            }

            @Override
            public JsonValue take(int index, JsonValue v) {
                return objects.contains(index) ? v : null;
            }
        };
    }
}
