package enlightenment.method.cluster;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.method.Block;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PixelGroupTest {
    /** The group of each pixel of a block, by rows. */
    private static int[] groups(int side, Block block) {
        int[] of = new int[block.width() * block.height()];
        Arrays.fill(of, -1);
        PixelGroup group = new PixelGroup(side);
        for (int number = 0; number < group.count; number++) {
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

    @ParameterizedTest
    @ValueSource(ints = {16, 32, 64})
    void everyPixelIsInOneGroupAlsoWhereThePictureCutsItsBlock(int side) {
        for (int width = 1; width <= side; width += side / 16) {
            for (int height = 1; height <= side; height += side / 16) {
                int[] of = groups(side, new Block(3 * side, 5 * side, width, height));
                assertTrue(Arrays.stream(of).allMatch(number -> number >= 0));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {16, 32, 64})
    void cellsHaveOneOfEachGroup(int side) {
        int[] of = groups(side, new Block(7 * side, 0, side, side));
        int cell = side / 8;
        for (int j = 0; j < side; j += cell) {
            for (int i = 0; i < side; i += cell) {
                int first = side * j + i;
                int[] found = IntStream.range(0, cell * cell)
                        .map(k -> of[first + side * (k / cell) + k % cell])
                        .sorted()
                        .toArray();
                assertArrayEquals(IntStream.range(0, cell * cell).toArray(), found);
            }
        }
    }

    /** Of pixels that are a cell apart, the share that a random order gives have the same group: one in those of their colour. */
    @ParameterizedTest
    @ValueSource(ints = {16, 32, 64})
    void groupsMakeNoLattice(int side) {
        int[] same = new int[2];
        int pairs = 0;
        int cell = side / 8;
        for (int block = 0; block < 64; block++) {
            int[] of = groups(side, new Block(block * side, 2 * block * side, side, side));
            for (int j = 0; j < side - cell; j += cell) {
                for (int i = 0; i < side - cell; i += cell) {
                    int at = side * j + i;
                    same[0] += of[at] == of[at + cell] ? 1 : 0;
                    same[1] += of[at] == of[at + side * cell] ? 1 : 0;
                    pairs++;
                }
            }
        }
        double chance = 2.0 / (cell * cell);
        for (int count : same) {
            assertEquals(chance * pairs, count, 4 * Math.sqrt(pairs * chance * (1 - chance)));
        }
    }

    @Test
    void theOrderInACellIsUniform() {
        int[] counts = new int[8];
        int cells = 64 * 64;
        for (int block = 0; block < 64; block++) {
            PixelGroup group = new PixelGroup(32);
            group.gather(new Block(32 * block, 64 * block, 32, 32), 0);
            for (int m = 0; m < group.members; m++) {
                counts[(group.row[m] % 4 * 4 + group.column[m] % 4) / 2]++;
            }
        }
        for (int count : counts) {
            assertEquals(cells / 8.0, count, 4 * Math.sqrt(cells * 7 / 64.0));
        }
    }
}
