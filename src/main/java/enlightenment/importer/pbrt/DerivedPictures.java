package enlightenment.importer.pbrt;

import enlightenment.color.Color;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.material.Texture;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;

/** Pictures that are made of the scene's, where our textures have no word for what is done with them: PNG files of 16 bits, linear, each made once. */
final class DerivedPictures {
    private final ExtractedFiles extracted;
    private final Map<String, Texture.File> made = new HashMap<>();

    /** What becomes of a pixel. */
    interface Change {
        /** @param rgb linear components, at least 0; replaced by the new ones, of which those beyond 0..1 are clamped */
        void apply(double[] rgb);
    }

    DerivedPictures(ExtractedFiles extracted) {
        this.extracted = extracted;
    }

    /** Whether a file's name says that it holds linear floats. */
    static boolean isOfFloats(Path file) {
        return ImageFormat.ofExtension(file).filter(ImageFormat::holdsFloats).isPresent();
    }

    /**
     * A texture by another one.
     *
     * @param what the change, such that equal changes of equal textures have equal words
     * @param place what a failure blames
     */
    Texture.File of(Texture.File source, String what, Change change, Place place) {
        String key = source + " " + what;
        Texture.File known = made.get(key);
        if (known == null) {
            Image linear = linear(source, place);
            float[] components = linear.toArray();
            double[] rgb = new double[3];
            for (int i = 0; i < components.length; i += 3) {
                for (int c = 0; c < 3; c++) {
                    rgb[c] = components[i + c];
                }
                change.apply(rgb);
                for (int c = 0; c < 3; c++) {
                    components[i + c] = (float) Math.min(1, Math.max(0, rgb[c]));
                }
            }
            known = write(new Image(linear.width(), linear.height(), components), source.filter(), place);
            made.put(key, known);
        }
        return known;
    }

    /** A texture's picture with linear components: finite, at least 0. */
    Image linear(Texture.File source, Place place) {
        try {
            Image image = ImageFiles.read(source.file());
            float[] c = image.toArray();
            for (int i = 0; i < c.length; i++) {
                double v = source.encoding() == Texture.Encoding.SRGB ? TransferCurve.decode(c[i]) : c[i];
                c[i] = v > 0 && v < Double.POSITIVE_INFINITY ? (float) v : 0;
            }
            return new Image(image.width(), image.height(), c, Color.Encoding.LINEAR);
        } catch (IOException e) {
            throw place.failure(e.getMessage());
        }
    }

    /** The largest component of a picture, and at least {@code least}. */
    static double largest(Image image, double least) {
        double largest = least;
        for (float v : image.toArray()) {
            largest = Math.max(largest, v);
        }
        return largest;
    }

    /** Writes numbers of 0..1 as the texture that has them as linear components. */
    Texture.File write(Image numbers, Texture.Filter filter, Place place) {
        try {
            return new Texture.File(extracted.picture(numbers), filter, Texture.Encoding.LINEAR);
        } catch (IOException e) {
            throw place.failure(e.getMessage());
        }
    }
}
