package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Texture;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The picture of an area light, whose upper edge lies at v = 1.
 *
 * @param texture the picture, divided by its largest component if it holds floats; empty if the lamp emits evenly
 * @param factor what the texture is to be multiplied by
 * @param luminance the mean luminance of the picture
 */
record LampPicture(Optional<Texture> texture, Rgb factor, double luminance) {
    /** Reads the picture that an area light names. */
    static LampPicture read(Parameters light, TokenSource files, DerivedPictures pictures, ImportNotes notes) {
        Place place = light.place();
        Path file = files.file(light.string("filename", ""), place);
        boolean isOfFloats = DerivedPictures.isOfFloats(file);
        Texture.File source = new Texture.File(
                file, Texture.Filter.BILINEAR, isOfFloats ? Texture.Encoding.LINEAR : Texture.Encoding.SRGB);
        Image linear = pictures.linear(source, place);
        if (light.has("L")) {
            notes.add(place.shown(), "L of a lamp with a picture is left out");
        }
        double largest = DerivedPictures.largest(linear, 0);
        double luminance = luminance(mean(linear));
        if (largest == 0) {
            return new LampPicture(Optional.empty(), Rgb.BLACK, luminance);
        }
        if (!isOfFloats) {
            return new LampPicture(Optional.of(source), Rgb.WHITE, luminance);
        }
        Texture scaled = pictures.of(source, "over " + largest, rgb -> divide(rgb, largest), place);
        return new LampPicture(Optional.of(scaled), Rgb.gray(largest), luminance);
    }

    /** The lamp that emits the mean of this one everywhere. */
    LampPicture even(DerivedPictures pictures, Place place) {
        return texture.isEmpty()
                ? this
                : new LampPicture(
                        Optional.empty(),
                        factor.times(mean(pictures.linear((Texture.File) texture.get(), place))),
                        luminance);
    }

    private static void divide(double[] rgb, double by) {
        for (int c = 0; c < rgb.length; c++) {
            rgb[c] /= by;
        }
    }

    private static Rgb mean(Image linear) {
        double[] sums = new double[3];
        for (int y = 0; y < linear.height(); y++) {
            for (int x = 0; x < linear.width(); x++) {
                for (int c = 0; c < sums.length; c++) {
                    sums[c] += linear.component(x, y, c);
                }
            }
        }
        double n = (double) linear.width() * linear.height();
        return new Rgb(sums[0] / n, sums[1] / n, sums[2] / n);
    }

    /** Of linear sRGB. */
    private static double luminance(Rgb c) {
        return 0.2126 * c.r() + 0.7152 * c.g() + 0.0722 * c.b();
    }
}
