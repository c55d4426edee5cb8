package enlightenment.surroundings;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Pictures of all directions, as PFM files. */
public final class Pictures {
    private Pictures() {}

    /** What a texel shows. */
    @FunctionalInterface
    public interface Texel {
        /** @param y counted from the top */
        double[] at(int x, int y);
    }

    /** The file of a picture. */
    public static byte[] pfm(int width, int height, Texel texels) {
        byte[] head = ("PF\n" + width + " " + height + "\n-1\n").getBytes(StandardCharsets.US_ASCII);
        ByteBuffer file = ByteBuffer.allocate(head.length + 12 * width * height).order(ByteOrder.LITTLE_ENDIAN);
        file.put(head);
        for (int y = height - 1; y >= 0; y--) {
            for (int x = 0; x < width; x++) {
                for (double value : texels.at(x, y)) {
                    file.putFloat((float) value);
                }
            }
        }
        return file.array();
    }

    /** The same number in all bands. */
    public static double[] grey(double value) {
        return new double[] {value, value, value};
    }
}
