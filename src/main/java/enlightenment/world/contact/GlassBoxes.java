package enlightenment.world.contact;

import enlightenment.frame.Bounds;
import enlightenment.world.parts.IntList;
import enlightenment.world.parts.PlaceTree;
import java.util.Arrays;
import java.util.function.IntFunction;

/** Boxes around the solids of glass of a scene, to find those that a ray leaving an opaque surface may start in. Immutable. */
public final class GlassBoxes {
    private final int[] solids;
    private final Bounds[] boxes;

    /** A tree over the boxes; null where testing them one by one is as fast. */
    private final PlaceTree tree;

    public GlassBoxes(int[] solids, IntFunction<Bounds> box) {
        this.solids = solids.clone();
        boxes = Arrays.stream(solids).mapToObj(box).toArray(Bounds[]::new);
        tree = solids.length <= PlaceTree.LEAF ? null : tree();
    }

    private PlaceTree tree() {
        Bounds all = boxes[0];
        for (Bounds box : boxes) {
            all = all.union(box);
        }
        double[] whole = new double[PlaceTree.BOX];
        put(all, whole, 0);
        return new PlaceTree(numbers(), whole);
    }

    private static void put(Bounds box, double[] out, int at) {
        for (int axis = 0; axis < 3; axis++) {
            out[at + axis] = box.min().component(axis);
            out[at + 3 + axis] = box.max().component(axis);
        }
    }

    /** Six numbers for each box: its least and its greatest coordinates. */
    public double[] numbers() {
        double[] all = new double[PlaceTree.BOX * boxes.length];
        for (int i = 0; i < boxes.length; i++) {
            put(boxes[i], all, PlaceTree.BOX * i);
        }
        return all;
    }

    /** A search, for one thread. */
    public Search search() {
        return new Search();
    }

    /** A search for the solids whose boxes contain a point. A mutable work object. */
    public final class Search {
        private final IntList found = new IntList();

        private Search() {}

        /** Finds the solids whose boxes contain a point, and returns their number; boxes are closed. */
        public int around(double x, double y, double z) {
            found.clear();
            if (tree == null) {
                for (int i = 0; i < boxes.length; i++) {
                    if (boxes[i].contains(x, y, z)) {
                        found.add(i);
                    }
                }
                return found.size();
            }
            tree.candidates(x, y, z, found);
            int kept = 0;
            for (int k = 0; k < found.size(); k++) {
                if (boxes[found.get(k)].contains(x, y, z)) {
                    found.set(kept++, found.get(k));
                }
            }
            found.shorten(kept);
            found.sort();
            return kept;
        }

        /** The id of the k-th solid that was found, counted from 0, in ascending order of ids. */
        public int solid(int k) {
            return solids[found.get(k)];
        }
    }
}
