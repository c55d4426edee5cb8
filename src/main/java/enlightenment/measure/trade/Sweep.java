package enlightenment.measure.trade;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A sweep of one render setting over values, with all others constant.
 *
 * @param name one of {@link #NAMES}
 * @param values the values, ascending, each at least 1
 */
public record Sweep(String name, List<Integer> values) {
    /** The settings that can be swept. */
    public static final List<String> NAMES =
            List.of("antialias", BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.key(), "threads");

    private static final Pattern FORM = Pattern.compile("([A-Za-z]+)=(\\d{1,7})\\.\\.(\\d{1,7}|N)");
    private static final int MAX_SINGLE_STEPS = 16;

    public Sweep {
        values = List.copyOf(values);
    }

    /**
     * Reads {@code NAME=FROM..TO}. Values go up by one where that makes at most 16 of them, else by doubling;
     * {@code shadowSamples} always doubles. The last value is TO. {@code N} stands for the number of processors.
     *
     * @throws IllegalArgumentException with a message that says what was expected
     */
    public static Sweep parse(String text) {
        Matcher m = FORM.matcher(text);
        if (!m.matches() || !NAMES.contains(m.group(1))) {
            throw new IllegalArgumentException("must be NAME=FROM..TO such as antialias=1..8, with NAME one of "
                    + String.join(", ", NAMES) + ", not \"" + text + "\"");
        }
        int from = Integer.parseInt(m.group(2));
        int to = m.group(3).equals("N")
                ? Math.max(Runtime.getRuntime().availableProcessors(), from)
                : Integer.parseInt(m.group(3));
        if (from < 1 || to < from) {
            throw new IllegalArgumentException("must go upwards from at least 1, not \"" + text + "\"");
        }
        boolean doubling =
                m.group(1).equals(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.key()) || to - from >= MAX_SINGLE_STEPS;
        List<Integer> values = new ArrayList<>();
        for (long v = from; v <= to; v = doubling ? 2 * v : v + 1) {
            values.add((int) v);
        }
        if (values.get(values.size() - 1) < to) {
            values.add(to);
        }
        return new Sweep(m.group(1), values);
    }

    /**
     * These settings with the swept one at a value.
     *
     * @throws enlightenment.math.InvalidValueException if the value is out of range; its key names the setting
     */
    public RenderSettings at(RenderSettings settings, int value) {
        if (name.equals(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.key())) {
            return settings.with(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES, value);
        }
        return name.equals("antialias") ? settings.withAntialias(value) : settings.withThreads(value);
    }

    /** The value that a run was made with. */
    public int valueOf(TradeRun run) {
        if (name.equals(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.key())) {
            return run.shadowSamples();
        }
        return name.equals("antialias") ? run.antialias() : run.threads();
    }

    /** The {@link TradeRun#kind} of the runs of this sweep. */
    public String kind() {
        return TradeRun.SWEEP + name;
    }
}
