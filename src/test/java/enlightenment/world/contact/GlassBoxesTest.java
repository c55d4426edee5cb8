package enlightenment.world.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GlassBoxesTest {
    /** On a coarse grid, where points lie on faces and corners of boxes, and boxes in each other; a search is used again. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 16, 17, 40, 700})
    void thoseAroundAPointAreFoundInTheOrderOfTheSolids(int n) {
        SplittableRandom random = new SplittableRandom(n);
        // Ids that are no indices.
        int[] solids = IntStream.range(0, n).map(i -> 3 * i + 5).toArray();
        Bounds[] boxes = new Bounds[n];
        for (int i = 0; i < n; i++) {
            Vec3 corner = new Vec3(random.nextInt(-8, 9), random.nextInt(-8, 9), random.nextInt(-8, 9));
            double side = random.nextInt(0, 7);
            boxes[i] = new Bounds(corner, corner.plus(new Vec3(side, side, side)));
        }
        GlassBoxes.Search search = new GlassBoxes(solids, solid -> boxes[(solid - 5) / 3]).search();
        int found = 0;
        for (int round = 0; round < 500; round++) {
            Vec3 p = new Vec3(random.nextInt(-9, 15), random.nextInt(-9, 15), random.nextInt(-9, 15));
            List<Integer> expected = new ArrayList<>();
            for (int i = 0; i < n; i++) {
                if (boxes[i].contains(p)) {
                    expected.add(solids[i]);
                }
            }
            int count = search.around(p.x(), p.y(), p.z());
            assertEquals(
                    expected, IntStream.range(0, count).mapToObj(search::solid).toList());
            found += count;
        }
        assertTrue(n < 16 || found > n, found + " found");
    }
}
