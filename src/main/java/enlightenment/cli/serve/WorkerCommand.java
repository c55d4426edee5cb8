package enlightenment.cli.serve;

import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.option.OptionRule;
import enlightenment.cli.option.OptionRules;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.option.WholeNumber;
import enlightenment.cli.setting.DeviceOption;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.math.InvalidValueException;
import enlightenment.net.RenderWorker;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment worker}: helps a server. */
@Command(name = "worker", description = "Renders tiles for a server.", sortOptions = false)
public final class WorkerCommand extends Subcommand {
    @Parameters(
            paramLabel = "HOST:PORT",
            converter = HostPort.Converter.class,
            description = "where the server listens")
    private HostPort server;

    @Option(
            names = "--threads",
            paramLabel = "N",
            converter = WholeNumber.Threads.class,
            description = "number of tiles rendered at once, 1..4096")
    private Integer threads;

    @Mixin
    private DeviceOption device = new DeviceOption();

    @Option(names = "--token-file", paramLabel = "FILE", description = "the server's secret; - for standard input")
    private Path token;

    @Option(
            names = "--tls-ca",
            paramLabel = "FILE",
            description = "use TLS; trust the authorities with these certificates (PEM)")
    private Path authorities;

    @Option(
            names = "--pin",
            paramLabel = "HASH",
            description = "use TLS; trust the server whose certificate has this SHA-256")
    private String pin;

    @Option(
            names = "--reconnect",
            paramLabel = "SECONDS",
            converter = Reconnect.class,
            description = "keep trying for this long when the server is away or of no use (default: 60)")
    private Double reconnect;

    public WorkerCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    public List<OptionRule> rules() {
        return OptionRules.WORKER;
    }

    @Override
    protected int execute() throws IOException {
        RenderWorker.Options options = options();
        if (pin == null && authorities == null && !isLoopback(server.host())) {
            terminal.say("without --pin or --tls-ca anyone on the network can see scene and picture");
        }
        RenderWorker.Outcome outcome = run(options);
        String said = outcome.reason() + "; " + outcome.tiles() + " tiles made here";
        if (!outcome.isDone()) {
            throw CliException.failed(said);
        }
        terminal.say(said);
        return ExitCode.DONE;
    }

    private RenderWorker.Outcome run(RenderWorker.Options options) throws IOException {
        try {
            return RenderWorker.run(server.host(), server.port(), options, terminal.stop());
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage("--device " + e.problem());
        }
    }

    private static boolean isLoopback(String host) {
        try {
            return InetAddress.getByName(host).isLoopbackAddress();
        } catch (IOException e) {
            return false;
        }
    }

    private RenderWorker.Options options() throws IOException {
        RenderWorker.Options.Builder o =
                RenderWorker.Options.builder().log(terminal::say).device(device.word());
        if (threads != null) {
            o.threads(threads);
        }
        if (token != null && StandardStreams.isNamed(token)) {
            typedToken(o);
        } else if (token != null) {
            o.tokenFile(token);
        }
        if (authorities != null) {
            o.authorities(authorities);
        }
        if (reconnect != null) {
            o.reconnectSeconds(reconnect);
        }
        try {
            return pin == null ? o.build() : o.pin(pin).build();
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage("--pin " + e.problem());
        }
    }

    /** The first line of standard input, which {@code ssh} carries to where no file holds the token. */
    private static void typedToken(RenderWorker.Options.Builder o) throws IOException {
        String line = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.ISO_8859_1)).readLine();
        try {
            o.token(line == null ? "" : line);
        } catch (IllegalArgumentException e) {
            throw CliException.failed("the token on standard input: " + e.getMessage());
        }
    }

    static final class Reconnect extends DecimalNumber {
        private static final double MAX = 1e9;

        Reconnect() {
            super(0, MAX);
        }
    }
}
