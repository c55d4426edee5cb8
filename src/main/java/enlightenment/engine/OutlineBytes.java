package enlightenment.engine;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.film.SplatScale;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.text.Plain;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Settings, what was decided from them, and whole outlines as bytes. What has no influence on the picture (threads) is left out, so that
 * the same picture has the same bytes.
 */
public final class OutlineBytes {
    /** Largest number of texts in a list. */
    private static final int MAX_TEXTS = 1_000;

    private static final int MAX_TEXT_BYTES = 1 << 20;

    /** Longest name of a part of the budget, or of a kind of primitives. */
    private static final int LONGEST_WORD = 200;

    private OutlineBytes() {}

    /** Writes what {@link #read} reads. */
    public static void write(DataOutputStream out, RenderSettings s, RenderPlan plan) throws IOException {
        text(out, s.method().word());
        out.writeInt(s.width());
        out.writeInt(s.height());
        RenderSettings.Crop region = s.region();
        out.writeBoolean(s.crop().isPresent());
        out.writeInt(region.x());
        out.writeInt(region.y());
        out.writeInt(region.width());
        out.writeInt(region.height());
        out.writeInt(s.antialias());
        out.writeLong(s.seed());
        write(out, s.budget().samples());
        write(out, s.budget().error());
        write(out, s.budget().seconds());
        write(out, chosen(s));
        out.writeInt(s.tileSize());
        text(out, plan.method().word());
        out.writeDouble(plan.level());
        out.writeDouble(plan.samples());
        text(out, plan.decidedBy());
        out.writeLong(plan.lightPaths());
    }

    /**
     * The settings that have an influence on the pictures of the method in use, but for the seed, as a list of keys and values, so
     * that a reader that does not know the method can go on behind them.
     */
    private static List<String> chosen(RenderSettings s) {
        List<String> texts = new ArrayList<>();
        for (Method.Setting setting : listed(s.method())) {
            texts.addAll(List.of(setting.key(), s.chosen().value(setting).toString()));
        }
        return texts;
    }

    private static List<Method.Setting> listed(Method method) {
        List<Method.Setting> listed = new ArrayList<>(Method.influences(method));
        ChosenSettings.Common.ALL.stream()
                .filter(s -> s != ChosenSettings.Common.SEED)
                .forEach(listed::add);
        return listed;
    }

    private static ChosenSettings chosen(long seed, Method method, List<String> texts) {
        ChosenSettings chosen = ChosenSettings.NONE.with(ChosenSettings.Common.SEED, seed);
        List<Method.Setting> settings = listed(method);
        if (texts.size() != 2 * settings.size()) {
            throw new IllegalArgumentException(
                    method.word() + " has " + settings.size() + " settings, not these: " + texts);
        }
        for (int i = 0; i < settings.size(); i++) {
            Method.Setting setting = settings.get(i);
            if (!texts.get(2 * i).equals(setting.key())) {
                throw new IllegalArgumentException("the setting " + setting.key() + " is missing: " + texts);
            }
            String value = texts.get(2 * i + 1);
            chosen = chosen.with(
                    setting, setting instanceof Method.Setting.Whole ? (Object) Long.valueOf(value) : value);
        }
        return chosen;
    }

    private static void write(DataOutputStream out, OptionalDouble value) throws IOException {
        // A budget's numbers are greater than 0.
        out.writeDouble(value.orElse(0));
    }

    /** Settings that were read, and the plan. */
    public record Decided(RenderSettings settings, RenderPlan plan) {}

    /**
     * Reads what {@link #write} wrote.
     *
     * @param threads what the settings are to say of threads
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Decided read(DataInputStream in, int threads) throws IOException {
        Method method = Method.named(text(in));
        int width = in.readInt();
        int height = in.readInt();
        boolean cropped = in.readBoolean();
        RenderSettings.Crop region = new RenderSettings.Crop(in.readInt(), in.readInt(), in.readInt(), in.readInt());
        int antialias = in.readInt();
        long seed = in.readLong();
        // The depth of the file, 0 here, only matters while an error is planned; this plan exists.
        RenderSettings.Budget budget =
                new RenderSettings.Budget(readOptional(in), readOptional(in), readOptional(in), 0);
        RenderSettings settings = new RenderSettings(
                method,
                width,
                height,
                cropped ? Optional.of(region) : Optional.empty(),
                antialias,
                budget,
                chosen(seed, method, readTexts(in)),
                threads,
                in.readInt());
        return new Decided(
                settings,
                new RenderPlan(
                        Method.named(text(in)), in.readDouble(), in.readDouble(), plain(text(in)), in.readLong()));
    }

    private static OptionalDouble readOptional(DataInputStream in) throws IOException {
        double value = in.readDouble();
        return value == 0 ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    /** Writes what {@link #readOutline} reads. */
    public static void write(DataOutputStream out, RenderOutline outline) throws IOException {
        text(out, outline.sceneName());
        write(out, outline.settings(), outline.plan());
        write(out, outline.features());
        write(out, outline.kinds());
        out.writeInt(outline.splatScale().exponent());
        write(out, outline.display());
        write(out, outline.undersampled());
    }

    /**
     * Reads an outline.
     *
     * @param threads what the settings are to say of threads
     * @throws IllegalArgumentException if a value is out of range
     */
    public static RenderOutline readOutline(DataInputStream in, int threads) throws IOException {
        String name = text(in);
        Decided decided = read(in, threads);
        List<String> features = readTexts(in);
        List<String> kinds = readTexts(in);
        kinds.forEach(OutlineBytes::plain);
        return new RenderOutline(name, decided.settings(), decided.plan(), features, kinds)
                .withSplatScale(new SplatScale(in.readInt()))
                .withDisplay(readDisplay(in))
                .withUndersampled(readTexts(in));
    }

    /** The kind of the pixels' numbers, exposure, and kind of the tone curve. */
    private static void write(DataOutputStream out, DisplayCurve curve) throws IOException {
        out.writeBoolean(curve.encoding() == Color.Encoding.LINEAR);
        out.writeDouble(curve.exposure());
        out.writeByte(curve.tone().ordinal());
    }

    /** @throws IllegalArgumentException for what is no curve */
    private static DisplayCurve readDisplay(DataInputStream in) throws IOException {
        boolean isLinear = in.readBoolean();
        double exposure = in.readDouble();
        int tone = in.readUnsignedByte();
        DisplayCurve.Tone[] tones = DisplayCurve.Tone.values();
        if (tone >= tones.length) {
            throw new IllegalArgumentException("tone curve " + tone);
        }
        return isLinear ? DisplayCurve.of(exposure, tones[tone]) : DisplayCurve.NONE;
    }

    /** Writes a list of texts. */
    public static void write(DataOutputStream out, List<String> texts) throws IOException {
        out.writeInt(texts.size());
        for (String text : texts) {
            text(out, text);
        }
    }

    /**
     * Reads a list of texts.
     *
     * @throws IllegalArgumentException if there are too many, or one is too long
     */
    public static List<String> readTexts(DataInputStream in) throws IOException {
        int count = in.readInt();
        if (count < 0 || count > MAX_TEXTS) {
            throw new IllegalArgumentException("a list of " + count + " texts");
        }
        List<String> texts = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            texts.add(text(in));
        }
        return texts;
    }

    /** Length in bytes, then UTF-8. */
    static void text(DataOutputStream out, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    /** A word of this program, which shows it as it is: one from elsewhere that says something to terminals is none. */
    private static String plain(String word) {
        if (!word.equals(Plain.line(word, LONGEST_WORD))) {
            throw new IllegalArgumentException(Plain.quoted(word) + " is no word of this program");
        }
        return word;
    }

    static String text(DataInputStream in) throws IOException {
        int length = in.readInt();
        if (length < 0 || length > MAX_TEXT_BYTES) {
            throw new IllegalArgumentException("a text of " + length + " bytes");
        }
        byte[] bytes = in.readNBytes(length);
        if (bytes.length < length) {
            throw new IllegalArgumentException("a text that ends too early");
        }
        return new String(bytes, StandardCharsets.UTF_8);
    }
}
