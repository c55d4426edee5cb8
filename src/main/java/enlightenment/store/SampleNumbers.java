package enlightenment.store;

import enlightenment.engine.WorkUnits;
import enlightenment.film.SampleBlock;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Numbers the samples of each pixel from 0 on, in their order: through all passes over its tile, which are units of their own with
 * consecutive numbers. Where units are missing the numbers close up.
 */
final class SampleNumbers {
    /** Passes are over tiles with fewer pixels; of what a store says there may be any number. */
    private static final int MOST_PIXELS = 1 << 16;

    private final int batches;
    private final int passes;

    /** By pixel of this tile, the number of samples so far, without those of the current pixel. */
    private final Map<Integer, Integer> before = new HashMap<>();

    private long tile = -1;
    private int pixel = -1;
    private int next;

    /** @param units those of the plan, if it can be read */
    SampleNumbers(Optional<WorkUnits> units) {
        batches = units.map(WorkUnits::batches).orElse(0);
        passes = units.map(WorkUnits::passes).orElse(1);
    }

    /** The numbers of a block's samples. Blocks must come in the order of their units and pieces. */
    int[] of(int unit, SampleBlock block) {
        long current = Math.floorDiv((long) unit - batches, passes);
        if (current != tile) {
            tile = current;
            pixel = -1;
            before.clear();
        }
        int[] numbers = new int[block.size()];
        for (int i = 0; i < numbers.length; i++) {
            if (block.pixel(i) != pixel) {
                turnTo(block.pixel(i));
            }
            numbers[i] = next++;
        }
        return numbers;
    }

    private void turnTo(int other) {
        if (passes > 1 && before.size() < MOST_PIXELS) {
            before.put(pixel, next);
        }
        pixel = other;
        next = before.getOrDefault(other, 0);
    }
}
