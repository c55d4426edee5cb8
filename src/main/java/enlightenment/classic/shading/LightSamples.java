package enlightenment.classic.shading;

import java.util.Arrays;

/** Light samples of one path, in the order in which they were taken: flat arrays that grow and are used again. */
public final class LightSamples {
    private static final int IDS = 3;

    private final int width;
    private int size;
    private int[] ids = new int[64 * IDS];
    private boolean[] blocked = new boolean[64];
    private double[] numbers;

    /** @param width how many numbers belong to a sample */
    LightSamples(int width) {
        this.width = width;
        numbers = new double[64 * width];
    }

    void clear() {
        size = 0;
    }

    /** Adds a sample; its numbers are to be {@link #set}. */
    void add(int surface, int light, int bounce, boolean isBlocked) {
        if (size == blocked.length) {
            ids = Arrays.copyOf(ids, 2 * ids.length);
            blocked = Arrays.copyOf(blocked, 2 * size);
            numbers = Arrays.copyOf(numbers, 2 * numbers.length);
        }
        int k = IDS * size;
        ids[k] = surface;
        ids[k + 1] = light;
        ids[k + 2] = bounce;
        blocked[size++] = isBlocked;
    }

    /** Sets three numbers of the sample added last. */
    void set(int first, double a, double b, double c) {
        int k = width * (size - 1) + first;
        numbers[k] = a;
        numbers[k + 1] = b;
        numbers[k + 2] = c;
    }

    /** How many there are. */
    public int size() {
        return size;
    }

    /** The id of the primitive that was shaded by sample k. */
    public int surface(int k) {
        return ids[IDS * k];
    }

    /** The index of the light. */
    public int light(int k) {
        return ids[IDS * k + 1];
    }

    /** The number of mirrors and glass surfaces before the surface on the path. */
    public int bounce(int k) {
        return ids[IDS * k + 2];
    }

    /** Whether the light point was occluded. */
    public boolean isBlocked(int k) {
        return blocked[k];
    }

    /** A number of sample k: {@link PathReport} says what it is. */
    public double number(int k, int which) {
        return numbers[width * k + which];
    }
}
