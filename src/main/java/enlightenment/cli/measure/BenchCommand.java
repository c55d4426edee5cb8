package enlightenment.cli.measure;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.FileNames;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.option.WholeNumber;
import enlightenment.cli.setting.RenderOptions;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.measure.Bench;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code enlightenment bench}: measures how fast this machine renders. */
@Command(name = "bench", description = "Measures how fast this machine renders.", sortOptions = false)
public final class BenchCommand extends Subcommand {
    private static final double MILLION = 1e6;
    private static final String PAPER_SCENE = "fire-and-ice.json";

    @Option(names = "--json", paramLabel = "FILE", description = "write the figures to this JSON file as well")
    private Path json;

    @Option(names = "--scenes", paramLabel = "DIR", description = "where the shipped scenes are (default: scenes)")
    private Path scenes = Path.of("scenes");

    @Option(
            names = "--methods",
            paramLabel = "LIST",
            converter = MethodList.Converter.class,
            completionCandidates = RenderOptions.Methods.class,
            description =
                    "methods to measure, with commas, each with the scenes that it can render (default: all of our own)")
    private MethodList methods;

    @Option(
            names = "--repeat",
            paramLabel = "N",
            converter = Repeats.class,
            description = "renders of each scene that count, 1..1000 (default: 5)")
    private int repeat = 5;

    public BenchCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        List<Path> files = files();
        if (json != null) {
            CommandFiles outputs = new CommandFiles().writes("--json", json);
            files.forEach(file -> outputs.reads(file, SceneReader.read(file)));
            outputs.check();
        }
        Map<String, String> machine = Bench.machine();
        machine.forEach((label, value) -> terminal.out().printf(Locale.ROOT, "%-20s%s%n", label + ":", value));
        terminal.out().println();
        terminal.out()
                .println("scene                          settings                               seconds (low to high)"
                        + "     CPU s   Mrays/s  light samples/s");
        List<Bench> all = new ArrayList<>();
        Path paper = scenes.resolve(PAPER_SCENE);
        Scene fireAndIce = SceneReader.read(paper);
        boolean complete = line(all, "paper's benchmark", fireAndIce, Bench.paperSettings(fireAndIce));
        for (int i = 0; i < files.size() && complete; i++) {
            Scene scene = SceneReader.read(files.get(i));
            complete = lines(all, FileNames.stem(files.get(i)), scene);
        }
        if (json != null) {
            WholeFile.write(json, BenchJson.of(all, machine, repeat));
        }
        if (!complete) {
            throw CliException.failed("stopped");
        }
        return ExitCode.DONE;
    }

    private List<Path> files() throws IOException {
        if (!Files.isRegularFile(scenes.resolve(PAPER_SCENE))) {
            throw CliException.wrongUsage("--scenes must name the folder of the shipped scenes, with " + PAPER_SCENE
                    + " in it, not \"" + scenes + "\"");
        }
        try (Stream<Path> all = Files.list(scenes)) {
            return all.filter(f -> FileNames.extension(f).equals(".json"))
                    .sorted()
                    .toList();
        }
    }

    /** Measures a scene with each method that can render it; false where it was stopped. */
    private boolean lines(List<Bench> all, String name, Scene scene) {
        MethodList able = methods == null ? MethodList.oursFor(scene) : methods;
        for (Method method : able.methods()) {
            if (Method.supports(method, scene)
                    && !line(all, name, scene, RenderSettings.of(scene).withMethod(method))) {
                return false;
            }
        }
        return true;
    }

    /** Measures and prints; false where it was stopped. */
    private boolean line(List<Bench> all, String name, Scene scene, RenderSettings settings) {
        Optional<Bench> measured = Bench.run(name, scene, settings, repeat, terminal.stop());
        if (measured.isEmpty()) {
            return false;
        }
        Bench b = measured.get();
        all.add(b);
        terminal.out()
                .printf(
                        Locale.ROOT,
                        "%-31s%-39s%-26s%6.2f%10.2f%15.2f M%n",
                        name,
                        describe(settings),
                        String.format(
                                Locale.ROOT,
                                "%.3f (%.3f to %.3f)",
                                b.wall().median(),
                                b.wall().low(),
                                b.wall().high()),
                        b.cpu().median(),
                        b.raysPerSecond() / MILLION,
                        b.lightSamplesPerSecond() / MILLION);
        terminal.out().flush();
        return true;
    }

    private static String describe(RenderSettings s) {
        return s.method() + " " + s.width() + "x" + s.height() + " aa " + s.antialias() + " sh "
                + BuiltInMethod.RayTraceSettings.of(s).shadowSamples() + " th " + s.threads();
    }

    static final class Repeats extends WholeNumber {
        private static final int MAX = 1000;

        Repeats() {
            super(1, MAX);
        }
    }
}
