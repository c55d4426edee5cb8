package enlightenment.cli.setting;

import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.MethodOptions;
import enlightenment.cli.option.WholeNumber;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** The options that change what a scene says about its rendering, except for method and budget: those of {@link RenderOptions}. */
public final class SettingsOptions {
    @Option(
            names = "--size",
            paramLabel = "WxH",
            converter = PictureSize.Converter.class,
            description = "size of the whole picture in pixels")
    private PictureSize size;

    @Option(
            names = "--antialias",
            paramLabel = "N",
            converter = Antialias.class,
            description = "N x N camera rays per pixel, 1..256")
    private Integer antialias;

    private final MethodOptions methods = new MethodOptions();

    @Mixin
    private CommandSpec methodsSpec = methods.spec();

    @Option(
            names = "--threads",
            paramLabel = "N",
            converter = WholeNumber.Threads.class,
            description = "number of threads, 1..4096; the picture does not depend on it")
    private Integer threads;

    @Option(
            names = "--crop",
            paramLabel = "X,Y,W,H",
            converter = CropConverter.class,
            description = "render only this part of the picture; 0,0 is the upper left corner")
    private RenderSettings.Crop crop;

    public SettingsOptions() {}

    /** The options of methods among these. */
    public MethodOptions methods() {
        return methods;
    }

    /** Warns if {@code --size} stretches the picture. */
    public void warnOfStretch(Scene scene, RenderSettings settings, Terminal terminal) {
        if (size != null) {
            StretchHint.of(scene, settings).ifPresent(terminal::say);
        }
    }

    /**
     * The settings for a scene: what it asks for, changed by the options.
     *
     * @param input where the scene comes from
     */
    public RenderSettings settings(Scene scene, SceneInput input) {
        RenderSettings s;
        try {
            s = RenderSettings.of(scene);
        } catch (InvalidValueException e) {
            throw SceneFailures.inFile(input, e);
        }
        s = size == null ? s : s.withSize(size.width(), size.height());
        s = antialias == null ? s : s.withAntialias(antialias);
        s = methods.applied(s);
        s = threads == null ? s : s.withThreads(threads);
        try {
            return crop == null ? s : s.withCrop(crop);
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage("--crop " + e.problem());
        }
    }

    /** The options given that decide what is in the picture and how many threads share the work, word by word. */
    public List<String> given() {
        List<String> words = new ArrayList<>();
        add(words, "--size", size);
        words.addAll(methods.given());
        add(words, "--threads", threads);
        add(words, "--crop", crop == null ? null : CropConverter.typed(crop));
        return words;
    }

    private static void add(List<String> words, String option, Object value) {
        if (value != null) {
            words.addAll(List.of(option, value.toString()));
        }
    }

    /** The exception for a value that the renderer refused: the option's fault where it was given, else the scene's. */
    public RuntimeException blame(InvalidValueException e, SceneInput input) {
        if (!e.key().equals("size")) {
            return SceneFailures.inFile(input, e);
        }
        return size != null
                ? CliException.wrongUsage("--size: " + e.problem())
                : SceneFailures.inFile(input, new InvalidValueException("image", e.problem()));
    }

    static final class Antialias extends WholeNumber {
        Antialias() {
            super(1, RenderSettings.Defaults.MAX_ANTIALIAS);
        }
    }
}
