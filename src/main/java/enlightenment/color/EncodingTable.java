package enlightenment.color;

import enlightenment.colorimetry.TransferCurve;

/**
 * The sRGB curve as a table over the root of the light, straight between its entries: above the curve's straight piece its second
 * derivative there is at most 4.3, so with 4096 steps it errs by at most 4.3/(8 · 4096²) &lt; 4e-8; in the step that begins on the straight
 * piece by 6e-7. Made when the first picture of linear
 * light needs it.
 */
final class EncodingTable {
    private static final int STEPS = 4096;

    /** Below this the curve is a straight line, {@link TransferCurve#encode}. */
    private static final double STRAIGHT = 0.0031308;

    private static final double[] TABLE = table();

    private EncodingTable() {}

    private static double[] table() {
        double[] table = new double[STEPS + 2];
        for (int i = 0; i < table.length; i++) {
            double root = Math.min(i / (double) STEPS, 1);
            table[i] = TransferCurve.encode(root * root);
        }
        return table;
    }

    /** The encoded value of light in 0..1. */
    static double encode(double light) {
        if (light <= STRAIGHT) {
            return TransferCurve.encode(light);
        }
        double at = STEPS * Math.sqrt(light);
        int k = (int) at;
        double lower = TABLE[k];
        return lower + (at - k) * (TABLE[k + 1] - lower);
    }
}
