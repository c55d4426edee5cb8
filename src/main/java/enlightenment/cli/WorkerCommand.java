package enlightenment.cli;

import enlightenment.math.InvalidValueException;
import enlightenment.net.RenderWorker;
import enlightenment.net.WorkerOptions;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment worker}: helps a server. */
@Command(name = "worker", description = "Renders for a server.", sortOptions = false)
final class WorkerCommand extends Subcommand {
    private static final int MAX_PORT = 65_535;
    private static final int MAX_THREADS = 4096;
    private static final double MAX_RECONNECT = 1e9;

    @Parameters(paramLabel = "HOST:PORT", description = "the server")
    private String server;

    @Option(names = "--threads", paramLabel = "N", description = "how many tiles are rendered at once")
    private String threads;

    @Option(names = "--token-file", paramLabel = "FILE", description = "the server's secret; - for standard input")
    private Path token;

    @Option(names = "--tls-ca", paramLabel = "FILE", description = "TLS; these certificates (PEM) vouch for the server")
    private Path authorities;

    @Option(names = "--pin", paramLabel = "HASH", description = "TLS; the SHA-256 of the server's certificate")
    private String pin;

    @Option(
            names = "--reconnect",
            paramLabel = "SECONDS",
            description = "how long to try again when the server is away; 60 by default")
    private String reconnect;

    WorkerCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        int colon = server.lastIndexOf(':');
        if (colon < 1) {
            throw CliException.wrongUsage("the server must be HOST:PORT such as 10.0.0.5:6002, not \"" + server + "\"");
        }
        int port = OptionValues.integer("the server's port", server.substring(colon + 1), 1, MAX_PORT);
        String host = server.substring(0, colon).replaceAll("^\\[(.*)]$", "$1");
        WorkerOptions o = options();
        if (pin == null && authorities == null && !isLoopback(host)) {
            terminal.say("without --pin or --tls-ca whoever is on the network can see scene and picture");
        }
        RenderWorker.Outcome outcome = RenderWorker.run(host, port, o, terminal.stop());
        terminal.say(outcome.reason() + "; " + outcome.tiles() + " tiles made here");
        return outcome.isDone() ? CliException.DONE : CliException.FAILED;
    }

    private static boolean isLoopback(String host) {
        try {
            return InetAddress.getByName(host).isLoopbackAddress();
        } catch (IOException e) {
            return false;
        }
    }

    private WorkerOptions options() throws IOException {
        WorkerOptions.Builder o = WorkerOptions.builder().log(terminal::say);
        if (pin != null && authorities != null) {
            throw CliException.wrongUsage("--pin and --tls-ca must not be given together");
        }
        if (threads != null) {
            o.threads(OptionValues.integer("--threads", threads, 1, MAX_THREADS));
        }
        if (token != null && token.toString().equals("-")) {
            typedToken(o);
        } else if (token != null) {
            o.tokenFile(token);
        }
        if (authorities != null) {
            o.authorities(authorities);
        }
        if (reconnect != null) {
            o.reconnectSeconds(OptionValues.number("--reconnect", reconnect, 0, MAX_RECONNECT));
        }
        try {
            return pin == null ? o.build() : o.pin(pin).build();
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage("--pin " + e.problem());
        }
    }

    /** With the first line of standard input, which {@code ssh} carries to where no file has the token. */
    private static void typedToken(WorkerOptions.Builder o) throws IOException {
        String line = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.ISO_8859_1)).readLine();
        try {
            o.token(line == null ? "" : line);
        } catch (IllegalArgumentException e) {
            throw CliException.failed("the token on standard input: " + e.getMessage());
        }
    }
}
