package enlightenment.image;

import enlightenment.color.Color;
import enlightenment.math.InvalidValueException;

/** What two images must have in common to be compared. */
final class ImagePair {
    private static final String[] CHANNELS = {"red", "green", "blue"};

    private ImagePair() {}

    /** Fails unless both have one size, one encoding and finite components. */
    static void check(Image test, Image reference) {
        if (test.width() != reference.width() || test.height() != reference.height()) {
            throw new InvalidValueException(
                    "size", "must be that of the reference, " + size(reference) + " pixels, not " + size(test));
        }
        if (test.encoding() != reference.encoding()) {
            throw new InvalidValueException(
                    "encoding",
                    "must be that of the reference, which " + holds(reference) + "; the picture to judge "
                            + holds(test));
        }
        checkFinite("test", test);
        checkFinite("reference", reference);
    }

    private static void checkFinite(String which, Image image) {
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    float value = image.component(x, y, c);
                    if (!Float.isFinite(value)) {
                        throw new InvalidValueException(
                                which, "there is " + value + " in column " + x + ", row " + y + ", " + CHANNELS[c]);
                    }
                }
            }
        }
    }

    private static String holds(Image image) {
        return image.encoding() == Color.Encoding.LINEAR ? "holds linear light" : "is display-referred";
    }

    private static String size(Image image) {
        return image.width() + "x" + image.height();
    }

    static String channel(int c) {
        return CHANNELS[c];
    }
}
