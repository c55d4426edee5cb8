package enlightenment.status;

import enlightenment.image.Image;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Fast encoder of PNG files (third edition, 2023) with 8 bits per component. Pixels are those of written files, but files are larger, and their bytes
 * may depend on the platform: they are shown once and not kept.
 */
public final class QuickPng {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    private static final int TRUECOLOR = 2;

    /** The filter type Sub: each component is stored as the difference from the pixel on the left. */
    private static final int SUB = 1;

    private QuickPng() {}

    /** The bytes of a PNG file with the displayed colours of a picture. */
    public static byte[] of(Image image) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.write(SIGNATURE);
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        DataOutputStream fields = new DataOutputStream(header);
        fields.writeInt(image.width());
        fields.writeInt(image.height());
        // Bit depth 8, compression method 0, filter method 0, not interlaced.
        fields.write(new byte[] {8, TRUECOLOR, 0, 0, 0});
        chunk(out, "IHDR", header.toByteArray());
        chunk(out, "IDAT", deflated(image));
        chunk(out, "IEND", new byte[0]);
        return bytes.toByteArray();
    }

    private static byte[] deflated(Image image) throws IOException {
        Deflater deflater = new Deflater(Deflater.BEST_SPEED);
        try {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            DeflaterOutputStream out = new DeflaterOutputStream(bytes, deflater, 16 << 10);
            int width = image.width();
            int[] argb = image.toArgb();
            byte[] row = new byte[1 + 3 * width];
            row[0] = SUB;
            for (int start = 0; start < argb.length; start += width) {
                int left = 0;
                for (int x = 0; x < width; x++) {
                    int pixel = argb[start + x];
                    row[1 + 3 * x] = (byte) ((pixel >> 16) - (left >> 16));
                    row[2 + 3 * x] = (byte) ((pixel >> 8) - (left >> 8));
                    row[3 + 3 * x] = (byte) (pixel - left);
                    left = pixel;
                }
                out.write(row);
            }
            out.finish();
            return bytes.toByteArray();
        } finally {
            deflater.end();
        }
    }

    private static void chunk(DataOutputStream out, String type, byte[] data) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        out.writeInt(data.length);
        out.write(name);
        out.write(data);
        CRC32 crc = new CRC32();
        crc.update(name);
        crc.update(data);
        out.writeInt((int) crc.getValue());
    }
}
