package enlightenment.cli;

import enlightenment.math.InvalidValueException;
import enlightenment.sampling.Distribution;
import enlightenment.scene.Budget;
import enlightenment.scene.Method;
import enlightenment.scene.RenderDefaults;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;

/** The options that change what a scene says about how it is rendered. */
final class RenderOptions {
    private static final int MAX_THREADS = 4096;

    /** Smaller errors are below the rounding of the picture's floats. */
    private static final double LEAST_ERROR = 1e-7;

    /** The finest that a clock tells. */
    private static final double LEAST_TIME = 1e-9;

    private static final double MOST_TIME = 1e9;

    @Option(
            names = "--method",
            paramLabel = "METHOD",
            completionCandidates = MethodNames.class,
            description = "how: ${COMPLETION-CANDIDATES}")
    private String method;

    @Option(names = "--size", paramLabel = "WxH", description = "size of the whole picture in pixels")
    private String size;

    @Option(names = "--antialias", paramLabel = "N", description = "N x N positions per pixel, 1..256")
    private String antialias;

    @Option(names = "--shadow-samples", paramLabel = "N", description = "light points per hit and light, 1..1000000")
    private String shadowSamples;

    @Option(
            names = "--samples",
            paramLabel = "N",
            description = "camera rays per pixel, in the mean; instead of --antialias")
    private String samples;

    @Option(
            names = "--error",
            paramLabel = "E",
            description = "stop when the picture's root mean square error is at most E, in 0..1")
    private String error;

    @Option(names = "--time", paramLabel = "SECONDS", description = "take about this long")
    private String time;

    @Option(
            names = "--proposal",
            paramLabel = "KIND",
            description = "what ray clusters propose light points from: normal (default), zeta or linear")
    private String proposal;

    @Option(names = "--seed", paramLabel = "N", description = "another choice of random numbers")
    private String seed;

    @Option(
            names = "--threads",
            paramLabel = "N",
            description = "how many threads share the work; the picture does not depend on it")
    private String threads;

    @Option(
            names = "--crop",
            paramLabel = "X,Y,W,H",
            description = "only this part of the picture, counted from its upper left corner")
    private String crop;

    @Option(names = "--frame", paramLabel = "N", description = "the frame of an animation, counted from 0")
    private String frame;

    RenderOptions() {}

    /** Whether the render is to take some time, so that it is not the same each time. */
    boolean hasTime() {
        return time != null;
    }

    /** Whether the render is to have an error that is not exceeded. */
    boolean hasError() {
        return error != null;
    }

    /** Which frame is wanted, if any is named. */
    Optional<Integer> frame() {
        return frame == null
                ? Optional.empty()
                : Optional.of(OptionValues.integer("--frame", frame, 0, Integer.MAX_VALUE));
    }

    /** Says that {@code --size} stretches the picture, if it does. */
    void tellOfStretch(Scene scene, RenderSettings settings, Terminal terminal) {
        if (size != null) {
            Stretch.of(scene, settings).ifPresent(terminal::say);
        }
    }

    /** Fails on what is wrong whatever the scene; called before the scene is read. */
    void check() {
        frame();
        budget();
        if (method != null) {
            OptionValues.word("--method", method, Method.words().toArray(new String[0]));
        }
        if (size != null) {
            OptionValues.size("--size", size);
        }
        if (crop != null) {
            OptionValues.crop("--crop", crop);
        }
        applyNumbers(null);
    }

    /** The settings for a scene: what it asks for, changed by the options. */
    RenderSettings settings(Scene scene, String sceneFile) {
        RenderSettings s;
        try {
            s = RenderSettings.of(scene);
        } catch (InvalidValueException e) {
            throw Failures.inFile(sceneFile, e);
        }
        if (method != null) {
            s = s.withMethod(Method.named(method));
        }
        if (size != null) {
            int[] sides = OptionValues.size("--size", size);
            s = s.withSize(sides[0], sides[1]);
        }
        s = applyNumbers(s);
        if (crop != null) {
            int[] c = OptionValues.crop("--crop", crop);
            try {
                s = s.withCrop(new RenderSettings.Crop(c[0], c[1], c[2], c[3]));
            } catch (InvalidValueException e) {
                throw CliException.wrongUsage("--crop " + e.problem());
            }
        }
        return s;
    }

    /** Reads all single numbers, and puts them into the settings if there are any yet. */
    private RenderSettings applyNumbers(RenderSettings settings) {
        RenderSettings s = settings;
        if (antialias != null) {
            int n = OptionValues.integer("--antialias", antialias, 1, RenderDefaults.MAX_ANTIALIAS);
            s = s == null ? null : s.withAntialias(n);
        }
        if (shadowSamples != null) {
            int n = OptionValues.integer("--shadow-samples", shadowSamples, 1, RenderDefaults.MAX_SHADOW_SAMPLES);
            s = s == null ? null : s.withShadowSamples(n);
        }
        if (proposal != null) {
            OptionValues.word("--proposal", proposal, Distribution.NAMES.toArray(new String[0]));
            s = s == null ? null : s.withProposal(proposal);
        }
        s = s == null ? null : s.withBudget(budget());
        if (seed != null) {
            long n = OptionValues.wholeNumber("--seed", seed);
            s = s == null ? null : s.withSeed(n);
        }
        if (threads != null) {
            int n = OptionValues.integer("--threads", threads, 1, MAX_THREADS);
            s = s == null ? null : s.withThreads(n);
        }
        return s;
    }

    /** The options given that decide what is in the picture and who works on it, as they were typed; not how long. */
    List<String> given() {
        List<String> all = new ArrayList<>();
        add(all, "--size", size);
        add(all, "--shadow-samples", shadowSamples);
        add(all, "--proposal", proposal);
        add(all, "--seed", seed);
        add(all, "--threads", threads);
        add(all, "--crop", crop);
        add(all, "--frame", frame);
        return all;
    }

    private static void add(List<String> all, String option, String value) {
        if (value != null) {
            all.add(option);
            all.add(value);
        }
    }

    /** For commands that decide on methods and budgets themselves: fails if one was given. */
    void refuseBudgets(String instead) {
        List<String> refused = new ArrayList<>();
        add(refused, "--method", method);
        add(refused, "--samples", samples);
        add(refused, "--error", error);
        add(refused, "--time", time);
        if (!refused.isEmpty()) {
            throw CliException.wrongUsage(refused.get(0) + " must not be given here: " + instead);
        }
    }

    /** Leaves the options that {@link #refuseBudgets} refuses out of the help; they are still known, to say what to use instead. */
    static void hideBudgets(CommandSpec command) {
        for (String name : List.of("--method", "--samples", "--error", "--time")) {
            OptionSpec option = command.findOption(name);
            command.remove(option);
            command.addOption(OptionSpec.builder(option).hidden(true).build());
        }
    }

    /** A number with as many digits as it has, and no exponent. */
    static String number(double value) {
        return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
    }

    private Budget budget() {
        Budget budget = Budget.NONE;
        if (samples != null) {
            budget = budget.withSamples(OptionValues.number("--samples", samples, 1, Budget.MAX_SAMPLES));
        }
        if (error != null) {
            budget = budget.withError(OptionValues.number("--error", error, LEAST_ERROR, 1));
        }
        if (time != null) {
            budget = budget.withSeconds(OptionValues.number("--time", time, LEAST_TIME, MOST_TIME));
        }
        return budget;
    }

    /**
     * What to tell of a value that the renderer refused: the option's fault where there is one of that name, the scene's
     * otherwise.
     */
    RuntimeException blame(InvalidValueException e, String sceneFile) {
        if (e.key().equals("size")) {
            // The message speaks of a picture of so many pixels, which may come from the scene as well.
            return size != null
                    ? CliException.wrongUsage("--size: " + e.problem())
                    : Failures.inFile(sceneFile, new InvalidValueException("image", e.problem()));
        }
        if (e.key().equals("error")) {
            return CliException.wrongUsage("--error " + e.problem() + "; more bits (--depth 16) or a .pfm file can");
        }
        return Failures.inFile(sceneFile, e);
    }

    /** The same line for a picture that so many samples were planned for: with it the same bytes can be made again. */
    String replayable(RenderSettings s, double planned) {
        return canonical(s.withBudget(s.budget().replayable(planned)));
    }

    /** The settings that the picture depends on, in one line that never changes its form. */
    String canonical(RenderSettings s) {
        StringBuilder line = new StringBuilder("method=").append(s.method());
        line.append(" size=").append(s.width()).append('x').append(s.height());
        line.append(" antialias=").append(s.antialias());
        if (s.budget().samples().isPresent()) {
            line.append(" samples=").append(number(s.budget().samples().getAsDouble()));
        }
        if (s.budget().error().isPresent()) {
            line.append(" error=").append(number(s.budget().error().getAsDouble()));
        }
        if (s.method().has(Method.Setting.PROPOSAL)) {
            line.append(" proposal=").append(s.proposal());
        }
        line.append(" shadowSamples=").append(s.shadowSamples());
        line.append(" seed=").append(s.seed());
        if (s.crop().isPresent()) {
            RenderSettings.Crop c = s.crop().get();
            line.append(" crop=").append(c.x()).append(',').append(c.y()).append(',');
            line.append(c.width()).append(',').append(c.height());
        }
        if (frame().isPresent()) {
            line.append(" frame=").append(frame().get());
        }
        return line.toString();
    }
}
