package enlightenment.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class NeighbourhoodTest {
    private static final float NONE = Float.NaN;

    @Test
    void aMeanIsThatOfThePixelsAround() {
        float[] values = {1, 2, 3, 10, 4, 5, 6, 10, 7, 8, 9, 10};
        assertEquals(5, Neighbourhood.mean(values, 4, 3, 1, 1), 1e-12);
        assertEquals(3, Neighbourhood.mean(values, 4, 3, 0, 0), 1e-12);
        assertEquals(35 / 4.0, Neighbourhood.mean(values, 4, 3, 3, 2), 1e-12);
    }

    @Test
    void pixelsWithoutANumberDoNotCount() {
        assertEquals(4, Neighbourhood.mean(new float[] {NONE, 3, 5, NONE}, 2, 2, 0, 0), 1e-12);
        assertEquals(Double.POSITIVE_INFINITY, Neighbourhood.mean(new float[] {NONE, NONE}, 1, 2, 0, 1));
    }
}
