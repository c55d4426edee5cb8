package enlightenment.cli;

import enlightenment.image.PngOptions;
import enlightenment.math.InvalidValueException;
import enlightenment.net.RenderServer;
import enlightenment.net.ServerOptions;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
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

    @Parameters(paramLabel = "SCENE", description = "the scene file; - for standard input")
    private Path sceneFile;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the picture: .png, or .pfm for exact floats; - for standard output")
    private Path output;

    @Option(names = "--host", paramLabel = "ADDRESS", description = "where to listen: 127.0.0.1 (default), 0.0.0.0 ...")
    private String host = "127.0.0.1";

    @Option(names = "--port", paramLabel = "PORT", description = "6002 by default; 0 for any that is free")
    private String port = Integer.toString(ServerOptions.DEFAULT_PORT);

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

    @Option(
            names = "--pardon",
            split = ",",
            paramLabel = "MACHINE",
            description = "let a machine in again that was expelled, as the log and the checkpoint call it")
    private List<String> pardoned = List.of();

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            description = "with -o -: png (default) or pfm, to standard output")
    private String format;

    @Option(names = "--depth", paramLabel = "BITS", description = "bits per component of a PNG file: 8 (default) or 16")
    private String depth;

    @Option(names = "--report", paramLabel = "FILE", description = "write what was done to this JSON file")
    private Path report;

    @Option(names = "--stats", description = "show what was done")
    private boolean stats;

    @Option(names = "--progress", paramLabel = "KIND", description = "auto (default), bar, plain or none")
    private String progress;

    private SceneInput input;

    ServerCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        PictureOptions.check(output, depth, format);
        if (progress != null) {
            OptionValues.word("--progress", progress, ProgressDisplay.KINDS);
        }
        options.check();
        ServerOptions server = serverOptions();
        input = new SceneInput(sceneFile, terminal);
        Scene scene = input.read(options.frame());
        RenderSettings settings = PictureOptions.forFile(options.settings(scene, input.name()), output, format, depth);
        options.tellOfStretch(scene, settings, terminal);
        outputFiles(scene).check();
        return finish(serve(scene, settings, server), scene, settings);
    }

    private ServerOptions serverOptions() throws IOException {
        ServerOptions.Builder o = ServerOptions.builder()
                .address(host, OptionValues.integer("--port", port, 0, MAX_PORT))
                .awaitWorkers(
                        OptionValues.integer("--min-workers", minWorkers, 0, ServerOptions.MAX_WORKERS),
                        OptionValues.number("--wait", wait, 0, MAX_WAIT))
                .shares(shares())
                .log(terminal::say);
        secure(o);
        if (statusPort != null) {
            o.statusPort(OptionValues.integer("--status-port", statusPort, 0, MAX_PORT));
        }
        if (localThreads != null) {
            o.localThreads(OptionValues.integer("--local-threads", localThreads, 0, MAX_THREADS));
        }
        if (audit != null) {
            o.auditRate(OptionValues.number("--audit", audit, 0, 1));
        }
        if (checkpoint != null) {
            if (options.hasTime()) {
                throw CliException.wrongUsage(
                        "--checkpoint must not be given with --time, which is planned anew each time: give --samples");
            }
            o.checkpoint(checkpoint);
        } else if (!pardoned.isEmpty()) {
            throw CliException.wrongUsage("--pardon needs --checkpoint, which remembers who was expelled");
        }
        return o.pardoned(pardoned).build();
    }

    private void secure(ServerOptions.Builder o) throws IOException {
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
        if (token != null) {
            o.tokenFile(token);
        }
        if (certificate != null) {
            o.tls(certificate, key);
        }
        if (tls != null) {
            o.tls(tls);
        }
    }

    private OutputFiles outputFiles(Scene scene) {
        return new OutputFiles()
                .reads(sceneFile, scene)
                .reads("the file of --tls-cert", certificate)
                .reads("the file of --tls-key", key)
                .makes("--token-file", token)
                .makes("--tls", tls)
                .writes("--checkpoint", checkpoint)
                .writes("-o", output)
                .writes("--report", report);
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
            throw options.blame(e, input.name());
        } catch (IllegalArgumentException e) {
            throw CliException.wrongUsage(e.getMessage());
        } catch (SceneException e) {
            throw Failures.inFile(input.name(), e);
        } finally {
            ProgressDisplay.end(display);
        }
    }

    private int finish(RenderResult result, Scene scene, RenderSettings settings) throws IOException {
        if (result.report().pixels() == 0) {
            terminal.say("stopped before anything was rendered; " + Standard.output(output) + " was not written");
            return CliException.FAILED;
        }
        double planned = result.report().sampling().plannedSamples();
        Map<String, String> text = PictureOptions.text(scene, options.replayable(settings, planned));
        PngOptions png = new PngOptions("16".equals(depth) ? 16 : 8, text);
        PictureOptions.write(result.image(), output, format, png, terminal);
        if (report != null) {
            OutputFile.write(report, ReportJson.of(result));
        }
        if (stats) {
            PictureOptions.printStatistics(result.report(), output, terminal);
        }
        if (!result.complete()) {
            RenderSettings.Crop region = settings.region();
            long percent = 100 * result.report().pixels() / ((long) region.width() * region.height());
            terminal.say("stopped: " + Standard.output(output) + " holds " + percent + " % of the picture");
            return CliException.FAILED;
        }
        OneColor.tell(scene, settings, result, terminal);
        return PictureOptions.keepsError(result.report(), terminal) ? CliException.DONE : CliException.FAILED;
    }
}
