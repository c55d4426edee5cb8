package enlightenment.cli.film;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.serve.ServingOptions;
import enlightenment.cli.setting.DeviceOption;
import enlightenment.cli.terminal.Terminal;
import enlightenment.net.RenderServer;
import enlightenment.net.ServerOptions;
import enlightenment.render.RenderRequest;
import java.io.IOException;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options that have a film made with the help of workers. */
final class FilmServing {
    @Option(
            names = "--server",
            description =
                    "render with the help of workers, as the command server does; the options from here on are for that")
    private boolean server;

    @Mixin
    private ServingOptions serving = new ServingOptions();

    FilmServing() {}

    /**
     * The server's options; null without {@code --server}.
     *
     * @param device that the server has
     * @param scratch the folder for a frame that is too large for the memory
     */
    ServerOptions options(DeviceOption device, RenderRequest.ScratchFolder scratch, Terminal terminal)
            throws IOException {
        return server
                ? serving.options(terminal)
                        .device(device.word())
                        .scratch(scratch)
                        .build()
                : null;
    }

    /** The options of a server. */
    ServingOptions options() {
        return serving;
    }

    /** Adds the files that the server reads and writes. */
    void register(CommandFiles files) {
        if (server) {
            serving.register(files);
        }
    }

    /** Prints how workers join and where the status page is. */
    void announce(RenderServer.OfFilm started, Terminal terminal) throws IOException {
        serving.announce(started.port(), started.pin(), started.statusPort(), terminal);
    }
}
