package enlightenment.engine;

import java.util.Arrays;
import java.util.Objects;

/** The units of many pictures in one row: those of the first, then those of the second, and so on. */
public final class FrameLayout {
    /** The first unit of each picture, and behind the last one the number of units. */
    private final int[] first;

    /**
     * @param units of each picture, at least 1
     * @throws ArithmeticException if there are more than an int can count
     */
    public FrameLayout(int[] units) {
        first = new int[units.length + 1];
        for (int i = 0; i < units.length; i++) {
            if (units[i] < 1) {
                throw new IllegalArgumentException("picture " + i + " has " + units[i] + " units");
            }
            first[i + 1] = Math.addExact(first[i], units[i]);
        }
    }

    /** Number of pictures. */
    public int frames() {
        return first.length - 1;
    }

    /** Number of units of all pictures. */
    public int units() {
        return first[frames()];
    }

    /** The picture that a unit belongs to. */
    public int frame(int unit) {
        int at = Arrays.binarySearch(first, Objects.checkIndex(unit, units()));
        return at >= 0 ? at : -at - 2;
    }

    /** The first unit of a picture; of the number of pictures: the number of units. */
    public int first(int frame) {
        return first[frame];
    }
}
