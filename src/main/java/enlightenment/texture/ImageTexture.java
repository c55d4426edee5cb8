package enlightenment.texture;

import enlightenment.codec.Raster;
import enlightenment.codec.RasterFiles;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.ImageFormat;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.zip.CRC32C;

/**
 * A picture to look colours up in, by texture coordinates: u to the right, v downwards, the whole picture in 0..1, repeated
 * beyond. The colours are display-referred components 0..1. Immutable.
 *
 * <p>0 and 1 are the picture's two edges, not the same place: at u = 1 the last column is seen, not the first one again.
 */
public final class ImageTexture {
    private final int width;
    private final int height;
    /** Texels of 8-bit components as 0xRRGGBB, or null. */
    private final int[] packed;
    /** The display-referred value of each 8-bit component. */
    private final double[] values;
    /** Three display-referred components per texel, or null. */
    private final float[] deep;

    private ImageTexture(Raster raster, boolean linear) throws IOException {
        width = raster.width();
        height = raster.height();
        packed = raster.packed();
        if (packed != null) {
            values = new double[256];
            for (int i = 0; i < values.length; i++) {
                values[i] = displayed(i / 255.0, linear);
            }
            deep = null;
        } else {
            values = null;
            deep = Raster.allocate(width, height, 12, () -> new float[raster.deep().length]);
            for (int i = 0; i < deep.length; i++) {
                deep[i] = (float) displayed(raster.deep()[i] / 65535.0, linear);
            }
        }
    }

    private ImageTexture(ImageTexture displayed) {
        width = displayed.width;
        height = displayed.height;
        packed = displayed.packed;
        values = displayed.values == null ? null : displayed.values.clone();
        deep = displayed.deep == null ? null : displayed.deep.clone();
        for (int i = 0; values != null && i < values.length; i++) {
            values[i] = TransferCurve.decode(values[i]);
        }
        for (int i = 0; deep != null && i < deep.length; i++) {
            deep[i] = (float) TransferCurve.decode(deep[i]);
        }
    }

    /** This texture as linear light: each texel is decoded before anything is interpolated. */
    public ImageTexture decoded() {
        return new ImageTexture(this);
    }

    /** A number that depends on the size and all texels, and on nothing else. */
    public long fingerprint() {
        CRC32C crc = new CRC32C();
        ByteBuffer row = ByteBuffer.allocate(3 * Float.BYTES * width);
        for (int y = 0; y < height; y++) {
            row.clear();
            for (int x = 0; x < width; x++) {
                for (int c = 0; packed == null && c < 3; c++) {
                    row.putFloat(deep[3 * (y * width + x) + c]);
                }
                if (packed != null) {
                    row.putInt(packed[y * width + x]);
                }
            }
            crc.update(row.flip());
        }
        return ((long) width << 48 ^ (long) height << 32) + crc.getValue();
    }

    private static double displayed(double value, boolean linear) {
        return linear && value < 1 ? TransferCurve.encode(value) : value; // rounding would leave white just below 1
    }

    /**
     * Reads a PNG, JPEG or BMP file of at most 2^28 pixels whose numbers are display-referred, as those of photographs and
     * paintings are. Transparency, gamma and colour profiles are not applied.
     *
     * @throws IOException with a message that names the file and the reason
     */
    public static ImageTexture read(Path file) throws IOException {
        return RasterFiles.read(file, bytes -> of(bytes, false));
    }

    /**
     * As {@link #read}, but for a file whose numbers are proportional to light. They are converted when the file is read;
     * {@link #bilinear} weights the converted values.
     *
     * @throws IOException with a message that names the file and the reason
     */
    public static ImageTexture readLinear(Path file) throws IOException {
        return RasterFiles.read(file, bytes -> of(bytes, true));
    }

    /**
     * As {@link #read} and {@link #readLinear}, of the bytes of such a file.
     *
     * @param linear whether the numbers are proportional to light
     * @throws IOException with a message that says what is wrong with the bytes
     */
    public static ImageTexture of(byte[] file, boolean linear) throws IOException {
        Raster raster = RasterFiles.decode(file);
        if (raster.floats() != null) {
            throw new IOException("a file of floats cannot be used here; "
                    + ImageFormat.names(ImageFormat.textures(), "and") + " can");
        }
        return new ImageTexture(raster, linear);
    }

    /** Columns of texels. */
    public int width() {
        return width;
    }

    /** Rows of texels. */
    public int height() {
        return height;
    }

    /** Its texels as 0xRRGGBB, row by row, where components have 8 bits, to be looked up in {@link #values}; else null. Not to be changed. */
    public int[] packed() {
        return packed;
    }

    /** The component that each of 256 bytes stands for, where texels are {@link #packed}; else null. Not to be changed. */
    public double[] values() {
        return values;
    }

    /** Three components for each texel, row by row, where they are not {@link #packed}; else null. Not to be changed. */
    public float[] components() {
        return deep;
    }

    /** Gives the red, green and blue of each texel, in an array that is used for the next one again. */
    public void forEachTexel(Consumer<double[]> consumer) {
        double[] rgb = new double[3];
        for (int texel = 0; texel < width * height; texel++) {
            texel(texel, rgb);
            consumer.accept(rgb);
        }
    }

    /**
     * Gives the texels that places in a box of texture coordinates may see, interpolated or not: one column and row more on each side.
     *
     * @param u0 with v0, u1 and v1 the box, in 0..1
     */
    public void forEachTexel(double u0, double v0, double u1, double v1, Consumer<double[]> consumer) {
        double[] rgb = new double[3];
        int left = (int) (u0 * width) - 1;
        int right = (int) (u1 * width) + 1;
        int top = Math.max((int) (v0 * height) - 1, 0);
        int bottom = Math.min((int) (v1 * height) + 1, height - 1);
        for (int y = top; y <= bottom; y++) {
            for (int x = left; x <= right; x++) {
                // Around a sphere, and on meshes, the last column is a neighbour of the first one.
                texel(y * width + Math.floorMod(x, width), rgb);
                consumer.accept(rgb);
            }
        }
    }

    /**
     * The texel that a place lies in.
     *
     * @param rgb receives red, green and blue
     */
    public void nearest(double u, double v, double[] rgb) {
        int x = Math.min((int) (repeat(u) * width), width - 1);
        int y = Math.min((int) (repeat(v) * height), height - 1);
        texel(y * width + x, rgb);
    }

    private void texel(int texel, double[] rgb) {
        if (packed != null) {
            int p = packed[texel];
            rgb[0] = values[p >>> 16];
            rgb[1] = values[p >>> 8 & 255];
            rgb[2] = values[p & 255];
        } else {
            rgb[0] = deep[3 * texel];
            rgb[1] = deep[3 * texel + 1];
            rgb[2] = deep[3 * texel + 2];
        }
    }

    /**
     * Weighted between the centres of the four texels around a place; texel i has its centre at (i + 0.5) / width.
     *
     * @param wrapU whether the last column is a neighbour of the first one, as it is around a sphere; otherwise, and always
     *     for rows, the half texel outside the outermost centres has the outermost texel's colour
     * @param rgb receives red, green and blue
     */
    public void bilinear(double u, double v, boolean wrapU, double[] rgb) {
        double x = repeat(u) * width - 0.5;
        double y = repeat(v) * height - 0.5;
        double left = Math.floor(x);
        double top = Math.floor(y);
        double fx = x - left;
        double fy = y - top;
        int x0 = (int) left;
        int x1 = x0 + 1;
        if (x0 < 0) {
            x0 = wrapU ? width - 1 : 0;
        }
        if (x1 >= width) {
            x1 = wrapU ? 0 : width - 1;
        }
        int row0 = Math.max((int) top, 0) * width;
        int row1 = Math.min((int) top + 1, height - 1) * width;
        if (packed != null) {
            mix(packed[row0 + x0], packed[row0 + x1], packed[row1 + x0], packed[row1 + x1], fx, fy, rgb);
        } else {
            mixDeep(3 * (row0 + x0), 3 * (row0 + x1), 3 * (row1 + x0), 3 * (row1 + x1), fx, fy, rgb);
        }
    }

    private void mix(int p00, int p10, int p01, int p11, double fx, double fy, double[] rgb) {
        double[] t = values;
        rgb[0] = mix(t[p00 >>> 16], t[p10 >>> 16], t[p01 >>> 16], t[p11 >>> 16], fx, fy);
        rgb[1] = mix(t[p00 >>> 8 & 255], t[p10 >>> 8 & 255], t[p01 >>> 8 & 255], t[p11 >>> 8 & 255], fx, fy);
        rgb[2] = mix(t[p00 & 255], t[p10 & 255], t[p01 & 255], t[p11 & 255], fx, fy);
    }

    private void mixDeep(int i00, int i10, int i01, int i11, double fx, double fy, double[] rgb) {
        for (int c = 0; c < 3; c++) {
            rgb[c] = mix(deep[i00 + c], deep[i10 + c], deep[i01 + c], deep[i11 + c], fx, fy);
        }
    }

    /** In this form four equal values give just this value, whatever the weights. */
    private static double mix(double v00, double v10, double v01, double v11, double fx, double fy) {
        double above = v00 + fx * (v10 - v00);
        double below = v01 + fx * (v11 - v01);
        return above + fy * (below - above);
    }

    /** The place in 0..1 that repeats here; 0 for what is no finite number. */
    private static double repeat(double t) {
        if (t >= 0 && t <= 1) {
            return t;
        }
        double fraction = t - Math.floor(t); // floor is exact, and so the same everywhere
        return fraction >= 0 ? fraction : 0;
    }
}
