package enlightenment.cli.render;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.WholeNumber;
import picocli.CommandLine.ITypeConverter;

/**
 * Which part of a picture.
 *
 * @param index counted from 1
 * @param count the number of parts, at least {@code index}
 */
record PartNumber(int index, int count) {
    /** As it is typed: {@code 3/16}. */
    @Override
    public String toString() {
        return index + "/" + count;
    }

    /** Reads {@code I/N}. */
    static final class Converter implements ITypeConverter<PartNumber> {
        @Override
        public PartNumber convert(String text) {
            int[] part = WholeNumber.several(text, "/", 2);
            if (part == null || part[0] < 1 || part[1] < part[0]) {
                throw BadValue.expected("I/N, part I of N, counted from 1, such as 3/16", text);
            }
            return new PartNumber(part[0], part[1]);
        }
    }
}
