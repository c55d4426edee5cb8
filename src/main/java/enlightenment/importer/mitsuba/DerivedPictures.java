package enlightenment.importer.mitsuba;

import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.material.Texture;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** Pictures that are made of those of a scene, as PNG files of 16 bits that hold linear numbers. Each is made once. */
final class DerivedPictures {
    /** Columns and rows of a projection of one colour: neighbouring intensities differ by less than 2 % up to 100 degrees across. */
    private static final int PLAIN_SIZE = 256;

    private final ExtractedFiles files;
    private final Map<Object, Texture.File> roots = new HashMap<>();

    DerivedPictures(ExtractedFiles files) {
        this.files = files;
    }

    /**
     * A picture whose largest component is 1.
     *
     * @param brightest by what its components are to be multiplied; 0 if it is black
     */
    record Scaled(Texture.File picture, double brightest) {}

    private record Root(Path file, Texture.Encoding encoding, boolean isGray) {}

    /**
     * The root of each linear component.
     *
     * @param isGray whether it is that of the components' mean
     * @throws IOException if the picture cannot be read, or the new one not written
     */
    Texture.File root(Texture.File of, boolean isGray) throws IOException {
        Root key = new Root(of.file(), of.encoding(), isGray);
        Texture.File known = roots.get(key);
        if (known == null) {
            Image source = ImageFiles.read(of.file());
            float[] rgb = linear(source, of.encoding());
            for (int i = 0; i < rgb.length; i += 3) {
                float mean = (rgb[i] + rgb[i + 1] + rgb[i + 2]) / 3;
                for (int c = 0; c < 3; c++) {
                    rgb[i + c] = (float) StrictMath.sqrt(StrictMath.min(isGray ? mean : rgb[i + c], 1));
                }
            }
            known = written(new Image(source.width(), source.height(), rgb), of.filter());
            roots.put(key, known);
        }
        return new Texture.File(known.file(), of.filter(), Texture.Encoding.LINEAR);
    }

    /**
     * A picture that is projected such that a plane across the axis is lit by it evenly. Its half width on the plane at distance 1 is given.
     *
     * @param source what the texture's file holds
     */
    Scaled projection(Texture.File of, Image source, double halfWidth, boolean isMirrored) throws IOException {
        return projection(
                source.width(), source.height(), linear(source, of.encoding()), halfWidth, isMirrored, of.filter());
    }

    /** Such a projection of a white square whose half width on the plane at distance 1 is given. */
    Scaled plain(double halfWidth) throws IOException {
        float[] white = new float[3 * PLAIN_SIZE * PLAIN_SIZE];
        Arrays.fill(white, 1);
        return projection(PLAIN_SIZE, PLAIN_SIZE, white, halfWidth, false, Texture.Filter.BILINEAR);
    }

    /** Intensity of a point light that lights a plane evenly is 1 / cos³ of the angle to the axis. */
    private Scaled projection(
            int width, int height, float[] rgb, double halfWidth, boolean isMirrored, Texture.Filter filter)
            throws IOException {
        double[] intensity = new double[rgb.length];
        double brightest = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double dx = halfWidth * (2 * x + 1 - width) / width;
                double dy = halfWidth * (2 * y + 1 - height) / width;
                double square = 1 + dx * dx + dy * dy;
                int to = 3 * (y * width + (isMirrored ? width - 1 - x : x));
                for (int c = 0; c < 3; c++) {
                    intensity[to + c] = rgb[3 * (y * width + x) + c] * square * StrictMath.sqrt(square);
                    brightest = StrictMath.max(brightest, intensity[to + c]);
                }
            }
        }
        return scaled(width, height, intensity, brightest, filter);
    }

    private Scaled scaled(int width, int height, double[] rgb, double brightest, Texture.Filter filter)
            throws IOException {
        float[] scaled = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            scaled[i] = brightest > 0 ? (float) (rgb[i] / brightest) : 0;
        }
        return new Scaled(written(new Image(width, height, scaled), filter), brightest);
    }

    /**
     * A picture of light, divided by its largest component.
     *
     * @throws IOException if the picture cannot be read, or the new one not written
     */
    Scaled scaled(Texture.File of) throws IOException {
        Image source = ImageFiles.read(of.file());
        float[] linear = linear(source, of.encoding());
        double[] rgb = new double[linear.length];
        double brightest = 0;
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = linear[i];
            brightest = StrictMath.max(brightest, rgb[i]);
        }
        return scaled(source.width(), source.height(), rgb, brightest, of.filter());
    }

    private Texture.File written(Image image, Texture.Filter filter) throws IOException {
        return new Texture.File(files.picture(image), filter, Texture.Encoding.LINEAR);
    }

    private static float[] linear(Image image, Texture.Encoding encoding) {
        float[] rgb = new float[3 * image.width() * image.height()];
        for (int i = 0; i < rgb.length; i++) {
            int pixel = i / 3;
            double v = image.component(pixel % image.width(), pixel / image.width(), i % 3);
            double decoded = encoding == Texture.Encoding.SRGB ? TransferCurve.decode(v) : v;
            rgb[i] = decoded > 0 ? (float) StrictMath.min(decoded, Float.MAX_VALUE) : 0;
        }
        return rgb;
    }
}
