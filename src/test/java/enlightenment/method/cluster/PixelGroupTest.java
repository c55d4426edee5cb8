package enlightenment.method.cluster;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.method.Block;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class PixelGroupTest {
    private static final int SIDE = PhysicalClusterMethod.BLOCK_SIDE;

    /** The group of each pixel of a block, by rows. */
    private static int[] groups(Block block) {
        int[] of = new int[block.width() * block.height()];
        Arrays.fill(of, -1);
        PixelGroup group = new PixelGroup();
        for (int number = 0; number < PixelGroup.COUNT; number++) {
            group.gather(block, number);
            for (int m = 0; m < group.members; m++) {
                int at = block.width() * group.row[m] + group.column[m];
                assertEquals(-1, of[at], "in two groups");
                assertEquals(group.field, (group.row[m] + group.column[m]) % 2, "the colour of the field");
                of[at] = number;
            }
        }
        return of;
    }

    @Test
    void everyPixelIsInOneGroupAlsoWhereThePictureCutsItsBlock() {
        for (int width = 1; width <= SIDE; width++) {
            for (int height = 1; height <= SIDE; height++) {
                int[] of = groups(new Block(3 * SIDE, 5 * SIDE, width, height));
                assertTrue(Arrays.stream(of).allMatch(number -> number >= 0));
            }
        }
    }

    @Test
    void twoByTwoPixelsHaveOneOfEachGroup() {
        int[] of = groups(new Block(7 * SIDE, 0, SIDE, SIDE));
        for (int j = 0; j < SIDE; j += 2) {
            for (int i = 0; i < SIDE; i += 2) {
                int at = SIDE * j + i;
                int[] four = {of[at], of[at + 1], of[at + SIDE], of[at + SIDE + 1]};
                Arrays.sort(four);
                assertArrayEquals(new int[] {0, 1, 2, 3}, four);
            }
        }
    }

    /** A group's pattern in 2 × 2 pixels is like that in the next ones beside and below in about half of the cases: no lattice. */
    @Test
    void groupsMakeNoLattice() {
        int[] same = new int[2];
        int pairs = 0;
        for (int block = 0; block < 64; block++) {
            int[] of = groups(new Block(block * SIDE, 2 * block * SIDE, SIDE, SIDE));
            for (int j = 0; j < SIDE - 2; j += 2) {
                for (int i = 0; i < SIDE - 2; i += 2) {
                    int at = SIDE * j + i;
                    same[0] += of[at] == of[at + 2] ? 1 : 0;
                    same[1] += of[at] == of[at + 2 * SIDE] ? 1 : 0;
                    pairs++;
                }
            }
        }
        // Of 3,136 fair coins the mean is half of them, the standard deviation 28.
        for (int count : same) {
            assertEquals(pairs / 2.0, count, 4 * Math.sqrt(pairs / 4.0));
        }
    }
}
