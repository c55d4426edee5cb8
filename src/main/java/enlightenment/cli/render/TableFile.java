package enlightenment.cli.render;

import enlightenment.cli.option.FileNames;
import enlightenment.cli.terminal.CliException;
import java.nio.file.Path;

/** Files of rows that are written as a table or as objects, as their names say. */
final class TableFile {
    private TableFile() {}

    /**
     * Fails unless a file's name says how to write it.
     *
     * @param option that names the file
     */
    static void check(String option, Path file) {
        if (!isCsv(file) && !FileNames.extension(file).equals(".json")) {
            throw CliException.wrongUsage(
                    option + " must name a file that ends in .json or .csv, not \"" + file + "\"");
        }
    }

    static boolean isCsv(Path file) {
        return FileNames.extension(file).equals(".csv");
    }
}
