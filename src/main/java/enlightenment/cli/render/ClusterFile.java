package enlightenment.cli.render;

import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.color.Color;
import enlightenment.file.WholeFile;
import enlightenment.render.RenderResult;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.text.WordList;
import java.io.IOException;
import java.nio.file.Path;

/** The file of {@code --dump-clusters}: what a method with ray clusters learned, for those who want to look at it. */
final class ClusterFile {
    private ClusterFile() {}

    /** Fails unless the settings make ray clusters and the file's name says how to write them. */
    static void check(Path file, RenderSettings settings) {
        if (!settings.method().hasClusters()) {
            String able = WordList.join(
                    Method.words(
                            Method.all().stream().filter(Method::hasClusters).toList()),
                    "or");
            throw CliException.wrongUsage("--dump-clusters needs --method " + able + "; "
                    + settings.method().word() + " has none");
        }
        TableFile.check("--dump-clusters", file);
    }

    static void write(Path file, RenderResult result, Terminal terminal) throws IOException {
        boolean csv = TableFile.isCsv(file);
        WholeFile.write(file, csv ? ClusterCsv.of(result.clusters()) : ClusterJson.of(result.clusters()));
        if (!result.report().sampling().method().hasClusters()) {
            terminal.say(
                    file + " is empty: with this few samples per pixel they were evenly spaced and made no clusters");
        } else if (result.image().encoding() == Color.Encoding.LINEAR) {
            terminal.say(file + " is empty: clusters of light points are made for classic shading only");
        }
    }
}
