package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class WarpTest {
    @Test
    void theDiskMapKeepsAreas() {
        // Rings of equal area and sectors of equal angle must each get their share of a fine grid.
        int n = 600;
        int[] ring = new int[8];
        int[] sector = new int[8];
        double[] out = new double[3];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                Warp.toDisk((i + 0.5) / n, (j + 0.5) / n, out);
                assertEquals(out[0] * out[0] + out[1] * out[1], out[2], 4e-16);
                ring[(int) Math.min(8 * out[2], 7)]++;
                double angle = StrictMath.atan2(out[1], out[0]) / (2 * Math.PI) + 1;
                sector[(int) (8 * (angle - Math.floor(angle)))]++;
            }
        }
        double share = n * (double) n / 8;
        for (int k = 0; k < 8; k++) {
            assertEquals(share, ring[k], 0.02 * share);
            assertEquals(share, sector[k], 0.02 * share);
        }
    }
}
