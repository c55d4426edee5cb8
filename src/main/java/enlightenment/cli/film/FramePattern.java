package enlightenment.cli.film;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.FilePath;
import enlightenment.text.PathText;
import enlightenment.text.Plain;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;

/**
 * The names of the files of frames. They have a folder, and a name in which one {@code %d} or {@code %04d} stands for the frame's number.
 * In a name {@code %%} is a percent sign; the folder is taken as it is. Frames of different numbers have different names.
 *
 * @param folder where they are; the working folder is {@code ""}
 * @param name the last part of the path as it was given
 * @param before what stands before the number
 * @param digits least number of digits, with leading zeros
 * @param after what stands behind it
 */
record FramePattern(Path folder, String name, String before, int digits, String after) {
    private static final Pattern NUMBER = Pattern.compile("((?:[^%]|%%)*)%(?:0([1-9]))?d((?:[^%]|%%)*)");
    private static final String EXAMPLE = "a .png file with a number in its name, such as frames/frame-%04d.png";

    /** @throws BadValue if the text is no such pattern */
    static FramePattern of(String text) {
        try {
            Path path = FilePath.reachable(Path.of(text));
            String name = path.getFileName() == null ? "" : path.getFileName().toString();
            Matcher m = NUMBER.matcher(name);
            if (!m.matches() || !name.toLowerCase(Locale.ROOT).endsWith(".png")) {
                throw BadValue.expected(EXAMPLE, text);
            }
            Path folder = path.getParent() == null ? Path.of("") : path.getParent();
            int digits = m.group(2) == null ? 1 : Integer.parseInt(m.group(2));
            return new FramePattern(folder, name, plain(m.group(1)), digits, plain(m.group(3)));
        } catch (InvalidPathException e) {
            throw PathText.isAboutLocale(e)
                    ? FilePath.unusable(PathText.reason(e))
                    : BadValue.expected(EXAMPLE, Plain.excerpt(text));
        }
    }

    private static String plain(String part) {
        return part.replace("%%", "%");
    }

    /** The file of a frame. */
    Path file(int frame) {
        return folder.resolve(before + String.format(Locale.ROOT, "%0" + digits + "d", frame) + after);
    }

    /** The pattern as it was given. */
    @Override
    public String toString() {
        return folder.resolve(name).toString();
    }

    /** The folder's name in messages. */
    String folderName() {
        return folder.toString().isEmpty() ? "the working folder" : folder.toString();
    }

    static final class Converter implements ITypeConverter<FramePattern> {
        @Override
        public FramePattern convert(String text) {
            return of(text);
        }
    }
}
