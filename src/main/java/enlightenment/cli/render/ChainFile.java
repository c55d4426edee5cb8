package enlightenment.cli.render;

import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.render.RenderResult;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Path;

/** The file of {@code --dump-chains}: what became of each Markov chain, for those who want to look at it. */
final class ChainFile {
    private ChainFile() {}

    /** Fails unless the settings make chains and the file's name says how to write them. */
    static void check(Path file, RenderSettings settings) {
        if (settings.method() != Method.METROPOLIS) {
            throw CliException.wrongUsage("--dump-chains needs --method " + Method.METROPOLIS.word() + "; "
                    + settings.method().word() + " has none");
        }
        TableFile.check("--dump-chains", file);
    }

    static void write(Path file, RenderResult result, Terminal terminal) throws IOException {
        boolean csv = TableFile.isCsv(file);
        WholeFile.write(file, csv ? csv(result) : ChainJson.of(result.chains()));
        if (result.report().sampling().method() != Method.METROPOLIS) {
            terminal.say(
                    file + " is empty: with this few samples per pixel they were evenly spaced and made no chains");
        }
    }

    /** A header and one line for each chain. */
    private static String csv(RenderResult result) {
        StringBuilder text = new StringBuilder("block x,block y,group,start x,start y,end x,end y,start brightness,"
                + "mean brightness,steps,accepted,large steps,large accepted\n");
        for (RenderResult.PathChain c : result.chains()) {
            text.append(c.blockX()).append(',').append(c.blockY()).append(',').append(c.group());
            text.append(',').append(c.startX()).append(',').append(c.startY());
            text.append(',').append(c.endX()).append(',').append(c.endY());
            text.append(',').append(c.startBrightness()).append(',').append(c.meanBrightness());
            text.append(',').append(c.steps()).append(',').append(c.accepted());
            text.append(',').append(c.largeSteps()).append(',').append(c.largeAccepted());
            text.append('\n');
        }
        return text.toString();
    }
}
