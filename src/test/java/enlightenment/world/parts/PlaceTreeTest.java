package enlightenment.world.parts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which of many boxes hold a point. */
class PlaceTreeTest {
    private static final double[] EVERYTHING = {-9, -9, -9, 9, 9, 9};

    private static void set(double[] boxes, int i, double... box) {
        System.arraycopy(box, 0, boxes, PlaceTree.BOX * i, PlaceTree.BOX);
    }

    private static boolean holds(double[] boxes, int i, double... p) {
        boolean holds = true;
        for (int c = 0; c < 3; c++) {
            holds &= p[c] >= boxes[PlaceTree.BOX * i + c] && p[c] <= boxes[PlaceTree.BOX * i + 3 + c];
        }
        return holds;
    }

    private static List<Integer> candidates(PlaceTree tree, double x, double y, double z) {
        IntList out = new IntList();
        tree.candidates(x, y, z, out);
        List<Integer> list = new ArrayList<>();
        for (int k = 0; k < out.size(); k++) {
            list.add(out.get(k));
        }
        return list;
    }

    /** Some of the boxes are the same, some are points, some reach out of the bounds. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 16, 17, 33, 500})
    void noBoxThatHoldsThePointIsMissedAndNoneIsToldTwice(int n) {
        SplittableRandom random = new SplittableRandom(n);
        double[] boxes = new double[PlaceTree.BOX * n];
        for (int i = 0; i < n; i++) {
            double x = random.nextInt(-8, 9);
            double y = random.nextInt(-8, 9);
            double z = random.nextInt(-8, 9);
            int size = random.nextInt(6, 14);
            set(boxes, i, x, y, z, x + size, y + size, z + size);
        }
        PlaceTree tree = new PlaceTree(boxes, EVERYTHING);
        int held = 0;
        for (int k = 0; k < 300; k++) {
            double x = random.nextInt(-9, 10);
            double y = random.nextInt(-9, 10);
            double z = random.nextInt(-9, 10);
            List<Integer> found = candidates(tree, x, y, z);
            assertEquals(found.size(), new TreeSet<>(found).size());
            for (int i = 0; i < n; i++) {
                if (holds(boxes, i, x, y, z)) {
                    held++;
                    assertTrue(found.contains(i));
                }
            }
        }
        assertTrue(held > 0);
    }

    /** Towers of all heights on a grid of 64 × 64, asked on the floor: their heights tell nothing, and lie outside of the floor's box. */
    @Test
    void ofTowersOnAFloorFewLeavesAreLookedInto() {
        int side = 64;
        SplittableRandom random = new SplittableRandom(7);
        double[] boxes = new double[PlaceTree.BOX * side * side];
        for (int i = 0; i < side * side; i++) {
            double x = i % side;
            double z = i / side;
            set(boxes, i, x + 0.25, 0, z + 0.25, x + 0.75, 1000 * random.nextDouble(), z + 0.75);
        }
        PlaceTree tree = new PlaceTree(boxes, new double[] {0, 0, 0, side, 0, side});
        for (int i = 0; i < side * side; i++) {
            // A power of four in squares, halved along the longer side: a leaf is a square of 4 × 4.
            assertEquals(
                    PlaceTree.LEAF,
                    candidates(tree, i % side + 0.5, 0, i / side + 0.5).size());
        }
    }
}
