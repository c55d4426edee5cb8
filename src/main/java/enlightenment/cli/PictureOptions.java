package enlightenment.cli;

import java.nio.file.Path;

/** What commands that write pictures check alike. */
final class PictureOptions {
    private PictureOptions() {}

    /** Fails unless the file's kind is known and may have that depth, which may be null. */
    static void check(Path output, String depth) {
        String extension = Target.extension(output);
        if (!extension.equals(".png") && !extension.equals(".pfm")) {
            throw CliException.wrongUsage("-o must name a file that ends in .png or .pfm, not \"" + output + "\"");
        }
        if (depth != null) {
            OptionValues.word("--depth", depth, "8", "16");
            if (extension.equals(".pfm")) {
                throw CliException.wrongUsage("--depth must not be given for a .pfm file, which holds floats");
            }
        }
    }
}
