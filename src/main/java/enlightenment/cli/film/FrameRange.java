package enlightenment.cli.film;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.WholeNumber;
import enlightenment.cli.terminal.CliException;
import java.util.stream.IntStream;
import picocli.CommandLine.ITypeConverter;

/**
 * Some frames of an animation that follow each other.
 *
 * @param first counted from 0
 * @param last not before the first
 */
record FrameRange(int first, int last) {
    /** As it is typed; like that of {@code AovSet}, because picocli asks for it at each start. */
    @Override
    public String toString() {
        return first == last ? Integer.toString(first) : first + "-" + last;
    }

    int count() {
        return last - first + 1;
    }

    IntStream frames() {
        return IntStream.rangeClosed(first, last);
    }

    /** Fails unless an animation with this number of frames has all of them. */
    FrameRange within(int frames) {
        if (last >= frames) {
            throw CliException.wrongUsage(
                    "--frames " + this + ": there is no frame " + last + "; the frames are 0.." + (frames - 1));
        }
        return this;
    }

    static final class Converter implements ITypeConverter<FrameRange> {
        @Override
        public FrameRange convert(String text) {
            int[] both = WholeNumber.several(text, "-", text.contains("-") ? 2 : 1);
            if (both == null || both[0] < 0 || both[both.length - 1] < both[0]) {
                throw BadValue.expected("FIRST-LAST or one frame, counted from 0, such as 0-99", text);
            }
            return new FrameRange(both[0], both[both.length - 1]);
        }
    }
}
