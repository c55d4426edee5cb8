package enlightenment.cli;

import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.math.Check.InvalidValueException;
import enlightenment.net.RenderServer;
import enlightenment.net.ServerOptions;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment server}: makes a picture of a scene with the help of workers. */
@Command(name = "server", description = "Makes a picture of a scene with the help of workers.", sortOptions = false)
final class ServerCommand extends Subcommand {
    private static final int MAX_PORT = 65_535;
    private static final int MAX_THREADS = 4096;
    private static final double MAX_WAIT = 1e7;

    @Parameters(paramLabel = "SCENE", description = "the scene file")
    private Path sceneFile;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the picture: .png, or .pfm for exact floats")
    private Path output;

    @Option(names = "--host", paramLabel = "ADDRESS", description = "where to listen: 127.0.0.1 (default), 0.0.0.0 ...")
    private String host = "127.0.0.1";

    @Option(names = "--port", paramLabel = "PORT", description = "6002 by default; 0 for any that is free")
    private String port = Integer.toString(ServerOptions.PORT);

    @Option(names = "--min-workers", paramLabel = "N", description = "begin when so many workers are there")
    private String minWorkers = "0";

    @Option(names = "--wait", paramLabel = "SECONDS", description = "but wait no longer than this for workers (30)")
    private String wait = "30";

    @Option(
            names = "--shares",
            paramLabel = "HOST=WEIGHT,...",
            description = "first guesses of the workers' speeds; others have 1")
    private String shares;

    @Option(
            names = "--token-file",
            paramLabel = "FILE",
            description = "the secret that workers must know; made if there is none")
    private Path token;

    @Option(
            names = "--tls",
            paramLabel = "FILE",
            description = "TLS with the certificate and private key in this file (PEM), which is made if there is none")
    private Path tls;

    @Option(
            names = "--tls-cert",
            paramLabel = "FILE",
            description = "instead of --tls: TLS with this certificate (PEM)")
    private Path certificate;

    @Option(names = "--tls-key", paramLabel = "FILE", description = "and this private key (PEM, PKCS #8)")
    private Path key;

    @Option(
            names = "--status-port",
            paramLabel = "PORT",
            description = "show how far it is to browsers on this machine")
    private String statusPort;

    @Option(names = "--checkpoint", paramLabel = "FILE", description = "keep what is done here, and go on from it")
    private Path checkpoint;

    @Option(names = "--local-threads", paramLabel = "N", description = "threads that render here too")
    private String localThreads;

    @Option(
            names = "--audit",
            paramLabel = "SHARE",
            description = "share of the tiles that two machines render, to find one that is wrong; 0.002 by default")
    private String audit;

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Option(names = "--depth", paramLabel = "BITS", description = "bits per component of a PNG file: 8 (default) or 16")
    private String depth;

    @Option(names = "--report", paramLabel = "FILE", description = "write what was done to this JSON file")
    private Path report;

    @Option(names = "--stats", description = "show what was done")
    private boolean stats;

    @Option(names = "--progress", paramLabel = "KIND", description = "auto (default), bar, plain or none")
    private String progress;

    ServerCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        PictureOptions.check(output, depth);
        if (progress != null) {
            OptionValues.word("--progress", progress, ProgressDisplay.KINDS);
        }
        options.check();
        ServerOptions server = serverOptions();
        for (Path file : new Path[] {output, report, checkpoint}) {
            if (file != null) {
                Target.check(file);
            }
        }
        checkSecrets();
        if (Target.same(output, sceneFile) || (checkpoint != null && Target.same(checkpoint, sceneFile))) {
            throw CliException.wrongUsage("-o and --checkpoint must not name the scene itself, \"" + sceneFile + "\"");
        }
        Scene scene = options.frame().isPresent()
                ? SceneReader.read(sceneFile, options.frame().get())
                : SceneReader.read(sceneFile);
        RenderSettings settings = PictureOptions.forFile(options.settings(scene, sceneFile.toString()), output, depth);
        return finish(serve(scene, settings, server), scene, settings);
    }

    private ServerOptions serverOptions() throws IOException {
        ServerOptions o = ServerOptions.DEFAULT
                .withAddress(host, OptionValues.integer("--port", port, 0, MAX_PORT))
                .withWait(
                        OptionValues.integer("--min-workers", minWorkers, 0, ServerOptions.MOST_WORKERS),
                        OptionValues.number("--wait", wait, 0, MAX_WAIT))
                .withShares(shares())
                .withLog(terminal::say);
        o = secured(o);
        o = statusPort == null ? o : o.withStatusPort(OptionValues.integer("--status-port", statusPort, 0, MAX_PORT));
        o = localThreads == null
                ? o
                : o.withLocalThreads(OptionValues.integer("--local-threads", localThreads, 0, MAX_THREADS));
        o = audit == null ? o : o.withAuditRate(OptionValues.number("--audit", audit, 0, 1));
        if (checkpoint != null) {
            if (options.hasTime()) {
                throw CliException.wrongUsage(
                        "--checkpoint must not be given with --time, which is planned anew each time: give --samples");
            }
            o = o.withCheckpoint(checkpoint);
        }
        return o;
    }

    private ServerOptions secured(ServerOptions plain) throws IOException {
        if ((certificate == null) != (key == null)) {
            throw CliException.wrongUsage("--tls-cert and --tls-key go together");
        }
        if (tls != null && certificate != null) {
            throw CliException.wrongUsage("--tls must not be given together with --tls-cert and --tls-key");
        }
        if (!InetAddress.getByName(host).isLoopbackAddress()) {
            if (token == null) {
                throw CliException.wrongUsage(
                        "--host " + host + " is beyond this machine: --token-file FILE must be given;"
                                + " a token is made if there is no such file");
            }
            if (tls == null && certificate == null) {
                terminal.say("without --tls FILE whoever is on the network can see scene and picture;"
                        + " a certificate is made if there is no such file");
            }
        }
        ServerOptions o = token == null ? plain : plain.withTokenFile(token);
        o = certificate == null ? o : o.withTls(certificate, key);
        return tls == null ? o : o.withTls(tls);
    }

    /** Secrets are not written over, nor one into the place of another file. */
    private void checkSecrets() throws IOException {
        for (Path secret : new Path[] {token, tls, certificate, key}) {
            for (Path file : new Path[] {sceneFile, output, report, checkpoint}) {
                if (secret != null && file != null && Target.same(secret, file)) {
                    throw CliException.wrongUsage(
                            "\"" + secret + "\" must not be a secret and another file of this render");
                }
            }
        }
        if (token != null && tls != null && Target.same(token, tls)) {
            throw CliException.wrongUsage("--token-file and --tls must be two files");
        }
    }

    private Map<String, Double> shares() {
        Map<String, Double> map = new LinkedHashMap<>();
        for (String share : shares == null ? new String[0] : shares.split(",", -1)) {
            int equals = share.lastIndexOf('=');
            if (equals < 1) {
                throw CliException.wrongUsage(
                        "--shares must be HOST=WEIGHT,... such as fast=4,10.0.0.7=1.5, not \"" + shares + "\"");
            }
            map.put(
                    share.substring(0, equals),
                    OptionValues.number("--shares", share.substring(equals + 1), 0.001, 1000));
        }
        return map;
    }

    private RenderResult serve(Scene scene, RenderSettings settings, ServerOptions serverOptions) throws IOException {
        RenderProgress display = ProgressDisplay.of(progress == null ? "auto" : progress, terminal.err());
        try (RenderServer server = RenderServer.start(scene, settings, serverOptions, terminal.stop())) {
            JoinLines.of(host, server.port(), token, server.pin()).forEach(terminal::say);
            if (server.statusPort() >= 0) {
                terminal.say("status: http://127.0.0.1:" + server.statusPort() + "/");
            }
            return server.await(display, terminal.stop());
        } catch (InvalidValueException e) {
            throw options.blame(e, sceneFile.toString());
        } catch (IllegalArgumentException e) {
            throw CliException.wrongUsage(e.getMessage());
        } catch (SceneException e) {
            throw Failures.inFile(sceneFile.toString(), e);
        } finally {
            ProgressDisplay.end(display);
        }
    }

    private int finish(RenderResult result, Scene scene, RenderSettings settings) throws IOException {
        if (result.report().pixels() == 0) {
            terminal.say("stopped before anything was rendered; " + output + " was not written");
            return CliException.FAILED;
        }
        double planned = result.report().sampling().plannedSamples();
        Map<String, String> text = PictureOptions.text(scene, options.replayable(settings, planned));
        ImageFiles.write(result.image(), output, new PngOptions("16".equals(depth) ? 16 : 8, text));
        if (report != null) {
            Target.write(report, ReportJson.of(result));
        }
        if (stats) {
            terminal.out().print(StatsTable.of(result.report()));
        }
        if (!result.complete()) {
            RenderSettings.Crop region = settings.region();
            long percent = 100 * result.report().pixels() / ((long) region.width() * region.height());
            terminal.say("stopped: " + output + " holds " + percent + " % of the picture");
            return CliException.FAILED;
        }
        return PictureOptions.keepsError(result.report(), terminal) ? CliException.DONE : CliException.FAILED;
    }
}
