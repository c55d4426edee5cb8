package enlightenment.cli.serve;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.option.WholeNumber;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Launcher;
import enlightenment.cli.terminal.Terminal;
import enlightenment.net.RenderServer;
import enlightenment.net.ServerOptions;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import picocli.CommandLine.Option;

/** The options that say how a server serves: where, to whom and with whose help. */
public final class ServingOptions {
    @Option(
            names = "--host",
            paramLabel = "ADDRESS",
            description = "address to listen at: 127.0.0.1 (default), 0.0.0.0 for all ...")
    private String host = "127.0.0.1";

    @Option(
            names = "--port",
            paramLabel = "PORT",
            converter = WholeNumber.Port.class,
            description = "port to listen at (default: 6002); 0 for any that is free")
    private int port = ServerOptions.DEFAULT_PORT;

    @Option(
            names = "--min-workers",
            paramLabel = "N",
            converter = MinWorkers.class,
            description = "begin when this many workers are connected (default: 0)")
    private int minWorkers;

    @Option(
            names = "--wait",
            paramLabel = "SECONDS",
            converter = Wait.class,
            description = "wait for workers no longer than this (default: 30)")
    private double wait = 30;

    @Option(
            names = "--shares",
            paramLabel = "HOST=WEIGHT,...",
            converter = SpeedShares.Converter.class,
            description = "first guesses of the workers' speeds; others have 1")
    private SpeedShares shares = SpeedShares.NONE;

    @Option(
            names = "--token-file",
            paramLabel = "FILE",
            description = "the secret that workers must know; made if there is no such file")
    private Path token;

    @Option(
            names = "--tls",
            paramLabel = "FILE",
            description = "use TLS with the certificate and private key in this file (PEM); made if there is none")
    private Path tls;

    @Option(
            names = "--tls-cert",
            paramLabel = "FILE",
            description = "instead of --tls: use TLS with this certificate (PEM)")
    private Path certificate;

    @Option(names = "--tls-key", paramLabel = "FILE", description = "with --tls-cert: its private key (PEM, PKCS #8)")
    private Path key;

    @Option(
            names = "--status-port",
            paramLabel = "PORT",
            converter = WholeNumber.Port.class,
            description = "show the state of the render as a web page on this machine; 0 for any free port")
    private Integer statusPort;

    @Option(
            names = "--local-threads",
            paramLabel = "N",
            converter = LocalThreads.class,
            description = "threads that render in the server itself (default: all processors but one)")
    private Integer localThreads;

    @Option(
            names = "--audit",
            paramLabel = "SHARE",
            converter = Audit.class,
            description =
                    "share of the tiles that two machines render, to find one that computes wrongly (default: 0.002)")
    private Double audit;

    @Option(
            names = "--audit-required",
            description = "fail where no second machine was there to render a tile that --audit asks for")
    private boolean isAuditRequired;

    public ServingOptions() {}

    /** The server's options as a builder; warns of what is not secret. */
    public ServerOptions.Builder options(Terminal terminal) throws IOException {
        if (isAuditRequired && audit != null && audit == 0) {
            throw CliException.wrongUsage("--audit-required must not be given with --audit 0, which audits nothing");
        }
        checkSecrets(terminal);
        ServerOptions.Builder o = ServerOptions.builder()
                .address(host, port)
                .awaitWorkers(minWorkers, wait)
                .shares(shares.byHost())
                .log(terminal::say);
        if (token != null) {
            o.tokenFile(token);
        }
        if (certificate != null) {
            o.tls(certificate, key);
        }
        if (tls != null) {
            o.tls(tls);
        }
        if (statusPort != null) {
            o.statusPort(statusPort);
        }
        if (localThreads != null) {
            o.localThreads(localThreads);
        }
        if (audit != null) {
            o.auditRate(audit);
        }
        return o;
    }

    private void checkSecrets(Terminal terminal) throws IOException {
        if (InetAddress.getByName(host).isLoopbackAddress()) {
            return;
        }
        if (token == null) {
            throw CliException.wrongUsage("--host " + host + " is beyond this machine: --token-file FILE must be given;"
                    + " a token is made if there is no such file");
        }
        if (tls == null && certificate == null) {
            terminal.say("without --tls FILE anyone on the network can see scene and picture;"
                    + " a certificate is made if there is no such file");
        }
    }

    /** Adds the files that the server reads and writes. */
    public void register(CommandFiles files) {
        files.reads("the file of --tls-cert", certificate)
                .reads("the file of --tls-key", key)
                .makes("--token-file", token)
                .makes("--tls", tls);
    }

    /**
     * Prints how workers join a server, and where its status page is.
     *
     * @param status the port of the page, negative for none
     */
    public void announce(int listening, String pin, int status, Terminal terminal) throws IOException {
        JoinLines.of(Launcher.command(), host, listening, token, pin).forEach(terminal::say);
        if (status >= 0) {
            terminal.say("status: http://127.0.0.1:" + status + "/");
        }
    }

    /** Warns of audits that were not made, unless {@link #requireAudits} makes that a failure. */
    public void tellAudits(RenderServer.AuditReport audits, Terminal terminal) {
        if (!audits.isComplete() && !isAuditRequired) {
            terminal.say("warning: " + audits.sentence() + "; --audit-required makes that a failure");
        }
    }

    /** Fails where audits were not made that have to be. */
    public void requireAudits(RenderServer.AuditReport audits) {
        if (!audits.isComplete() && isAuditRequired) {
            throw CliException.failed(audits.sentence() + ", which --audit-required asks for");
        }
    }

    static final class MinWorkers extends WholeNumber {
        MinWorkers() {
            super(0, ServerOptions.MAX_WORKERS);
        }
    }

    static final class LocalThreads extends WholeNumber {
        LocalThreads() {
            super(0, Threads.MAX);
        }
    }

    static final class Wait extends DecimalNumber {
        private static final double MAX = 1e7;

        Wait() {
            super(0, MAX);
        }
    }

    static final class Audit extends DecimalNumber {
        Audit() {
            super(0, 1);
        }
    }
}
