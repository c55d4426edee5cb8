package enlightenment.cli.serve;

import enlightenment.cli.option.CommandFiles;
import enlightenment.net.ServerOptions;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;

/** The options that say where a server keeps what it has done, so that another goes on from there. */
final class ServerKeepOptions {
    @Option(names = "--checkpoint", paramLabel = "FILE", description = "keep finished tiles here, and go on from them")
    private Path checkpoint;

    @Option(
            names = "--pardon",
            split = ",",
            paramLabel = "MACHINE",
            description = "readmit an expelled machine, named as in the log and the checkpoint")
    private List<String> pardoned = List.of();

    ServerKeepOptions() {}

    /** Adds what the options ask for. */
    ServerOptions.Builder addTo(ServerOptions.Builder options) {
        ServerOptions.Builder all = options.pardoned(pardoned);
        return checkpoint == null ? all : all.checkpoint(checkpoint);
    }

    /** Adds the file that is read and written. */
    void register(CommandFiles files) {
        files.writes("--checkpoint", checkpoint);
    }
}
