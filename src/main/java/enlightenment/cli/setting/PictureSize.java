package enlightenment.cli.setting;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.WholeNumber;
import enlightenment.scene.Scene;
import picocli.CommandLine.ITypeConverter;

/** The size of a picture in pixels. */
record PictureSize(int width, int height) {
    /** As it is typed: {@code 800x400}. */
    @Override
    public String toString() {
        return width + "x" + height;
    }

    /** Reads {@code WIDTHxHEIGHT}. */
    static final class Converter implements ITypeConverter<PictureSize> {
        @Override
        public PictureSize convert(String text) {
            int[] sides = WholeNumber.several(text, "x", 2);
            if (sides == null || !isSide(sides[0]) || !isSide(sides[1])) {
                throw BadValue.expected(
                        "WIDTHxHEIGHT, two whole numbers in 1.." + Scene.MAX_SIDE + " such as 800x400", text);
            }
            return new PictureSize(sides[0], sides[1]);
        }

        private static boolean isSide(int side) {
            return side >= 1 && side <= Scene.MAX_SIDE;
        }
    }
}
