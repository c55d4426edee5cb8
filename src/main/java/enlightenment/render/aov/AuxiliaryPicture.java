package enlightenment.render.aov;

import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.picture.HeatMap;
import enlightenment.render.RenderResult;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * A picture that shows the raw numbers of an {@link RenderResult.Auxiliary}.
 *
 * @param image the picture: as large as the numbers, but for the scale below the heat maps of error and samples
 * @param explanation the meaning of its colours, in one line
 * @param marks the numbers of its scale, spread evenly over it: of error and samples from black to pale yellow, of the depth from white
 *     to dark grey; empty where there is no scale
 */
public record AuxiliaryPicture(Image image, String explanation, List<String> marks) {
    /** The grey of the farthest thing: what is not there is black. */
    private static final double FAR = 0.1;

    /** The share of pixels that the scale of errors has room for; the few above it are shown as its end. */
    private static final double ON_SCALE = 0.99;

    /** Steps of hue from one object to the next: the golden section never comes near to where it was before. */
    private static final double GOLDEN = 0.6180339887498949;

    private static final double NOTHING_TO_SHOW = 1e-6;
    private static final int MARKS = 4;

    /** Copies the list. */
    public AuxiliaryPicture {
        marks = List.copyOf(marks);
    }

    private AuxiliaryPicture(Image image, String explanation) {
        this(image, explanation, List.of());
    }

    /** The picture of these numbers. */
    public static AuxiliaryPicture of(RenderResult.Auxiliary kind, Image numbers) {
        return of(kind, numbers, true);
    }

    /** As {@link #of}, but without a scale below it: as large as the numbers, for programs that draw a scale of their own. */
    public static AuxiliaryPicture withoutScale(RenderResult.Auxiliary kind, Image numbers) {
        return of(kind, numbers, false);
    }

    private static AuxiliaryPicture of(RenderResult.Auxiliary kind, Image numbers, boolean hasScale) {
        return switch (kind) {
            case ERROR -> error(numbers, hasScale);
            case SAMPLES -> samples(numbers, hasScale);
            case DEPTH -> depth(numbers);
            case NORMAL -> normal(numbers);
            case POSITION -> position(numbers);
            case OBJECT -> object(numbers);
            case ALBEDO -> albedo(numbers);
            case DIRECT ->
                new AuxiliaryPicture(
                        numbers, "light straight from lights, to what is seen or shown; as the picture is shown");
            case INDIRECT ->
                new AuxiliaryPicture(numbers, "light scattered more than once, and caustics; as the picture is shown");
        };
    }

    /** Reflectance is no light: the exposure is of no concern to it. */
    private static AuxiliaryPicture albedo(Image numbers) {
        return new AuxiliaryPicture(
                numbers.withCurve(DisplayCurve.SRGB),
                "reflectance of the first surface that is neither mirror nor glass: sRGB, white is 1");
    }

    private static AuxiliaryPicture heat(
            Image numbers, float[] shares, List<String> marks, String explanation, boolean hasScale) {
        int width = numbers.width();
        int height = numbers.height();
        Image image = hasScale ? HeatMap.withScale(width, height, shares, marks) : HeatMap.of(width, height, shares);
        return new AuxiliaryPicture(image, explanation, marks);
    }

    private static AuxiliaryPicture error(Image numbers, boolean hasScale) {
        float[] errors = first(numbers);
        float[] sorted = sortedFinite(errors);
        double most = sorted.length == 0 ? 0 : sorted[sorted.length - 1];
        double quantile = sorted.length == 0 ? 0 : sorted[(int) (ON_SCALE * (sorted.length - 1))];
        BigDecimal top = roundNumberAbove(Math.max(quantile, NOTHING_TO_SHOW));
        List<String> labels = new ArrayList<>();
        for (int i = 0; i <= MARKS; i++) {
            BigDecimal mark = top.multiply(BigDecimal.valueOf(i)).divide(BigDecimal.valueOf(MARKS));
            labels.add(mark.signum() == 0 ? "0" : mark.stripTrailingZeros().toPlainString());
        }
        float scale = top.floatValue();
        float[] shares = new float[errors.length];
        for (int i = 0; i < shares.length; i++) {
            shares[i] = Math.min(errors[i] / scale, 1);
        }
        String explanation = String.format(
                Locale.ROOT,
                "standard deviation, smoothed over 3x3 pixels: magma, 0..%s; largest %.6f",
                labels.get(MARKS),
                most);
        return heat(numbers, shares, labels, explanation, hasScale);
    }

    /** The next of 1, 2, 4 times a power of ten: their quarters are short. */
    private static BigDecimal roundNumberAbove(double value) {
        BigDecimal unit = new BigDecimal("1e-9");
        while (true) {
            for (int digit = 1; digit <= 4; digit *= 2) {
                BigDecimal candidate = unit.multiply(BigDecimal.valueOf(digit));
                if (candidate.doubleValue() >= value) {
                    return candidate;
                }
            }
            unit = unit.movePointRight(1);
        }
    }

    /** Numbers of samples are powers of two or means between them: so is the scale. */
    private static AuxiliaryPicture samples(Image numbers, boolean hasScale) {
        float[] counts = first(numbers);
        float most = 1;
        for (float count : counts) {
            most = Math.max(most, count);
        }
        int doublings = Math.max((int) Math.ceil(log2(most)), 1);
        int step = (doublings + MARKS - 1) / MARKS;
        doublings = (doublings + step - 1) / step * step;
        List<String> labels = new ArrayList<>();
        for (int i = 0; i <= doublings; i += step) {
            labels.add(Long.toString(1L << i));
        }
        float[] shares = new float[counts.length];
        for (int i = 0; i < shares.length; i++) {
            shares[i] = counts[i] < 1 ? 0 : (float) (log2(counts[i]) / doublings);
        }
        String explanation = "samples per pixel: magma, equal steps for doublings, 1.." + (1L << doublings) + "; most "
                + (long) most;
        return heat(numbers, shares, labels, explanation, hasScale);
    }

    private static double log2(double x) {
        return StrictMath.log(x) / StrictMath.log(2);
    }

    private static AuxiliaryPicture depth(Image numbers) {
        float[] depths = first(numbers);
        float[] sorted = sortedFinite(depths);
        double near = sorted.length == 0 ? 0 : sorted[0];
        double far = sorted.length == 0 ? 0 : sorted[sorted.length - 1];
        float[] rgb = new float[3 * depths.length];
        for (int i = 0; i < depths.length; i++) {
            if (depths[i] < Float.POSITIVE_INFINITY) {
                double share = far > near ? (depths[i] - near) / (far - near) : 0;
                Arrays.fill(rgb, 3 * i, 3 * i + 3, (float) (1 + share * (FAR - 1)));
            }
        }
        String range = sorted.length == 0
                ? "nothing is seen"
                : "white " + Float.toString((float) near) + " .. dark grey (" + FAR + ") " + Float.toString((float) far)
                        + " in the scene's units, linear";
        return new AuxiliaryPicture(
                new Image(numbers.width(), numbers.height(), rgb),
                "depth along the ray from the eye: " + range + "; black: nothing there",
                sorted.length == 0 ? List.of() : List.of(Float.toString((float) near), Float.toString((float) far)));
    }

    private static AuxiliaryPicture normal(Image numbers) {
        float[] n = numbers.toArray();
        for (int i = 0; i < n.length; i += 3) {
            boolean nothing = !hasValue(n, i);
            for (int c = i; c < i + 3; c++) {
                n[c] = nothing ? 0 : 0.5f + 0.5f * n[c];
            }
        }
        return new AuxiliaryPicture(
                new Image(numbers.width(), numbers.height(), n),
                "normal on the viewer's side: 0.5 + 0.5 n, x y z as red green blue; black: nothing there");
    }

    /** Colours as places in the box of all that is seen. */
    private static AuxiliaryPicture position(Image numbers) {
        float[] p = numbers.toArray();
        float[] low = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY};
        float[] high = {Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
        for (int i = 0; i < p.length; i++) {
            if (hasValue(p, i - i % 3)) {
                low[i % 3] = Math.min(low[i % 3], p[i]);
                high[i % 3] = Math.max(high[i % 3], p[i]);
            }
        }
        float[] rgb = new float[p.length];
        for (int i = 0; i < p.length; i++) {
            double size = (double) high[i % 3] - low[i % 3];
            rgb[i] = hasValue(p, i - i % 3) && size > 0 ? (float) (((double) p[i] - low[i % 3]) / size) : 0;
        }
        String box = low[0] > high[0] ? "nothing is seen" : "from " + text(low) + " to " + text(high);
        return new AuxiliaryPicture(
                new Image(numbers.width(), numbers.height(), rgb),
                "position, x y z as red green blue: " + box + " in the scene's units; black: nothing there");
    }

    private static boolean hasValue(float[] xyz, int first) {
        return xyz[first] != 0 || xyz[first + 1] != 0 || xyz[first + 2] != 0;
    }

    private static String text(float[] xyz) {
        return "(" + xyz[0] + ", " + xyz[1] + ", " + xyz[2] + ")";
    }

    private static AuxiliaryPicture object(Image numbers) {
        float[] ids = first(numbers);
        float[] rgb = new float[3 * ids.length];
        for (int i = 0; i < ids.length; i++) {
            if (ids[i] >= 0) {
                color((int) ids[i], rgb, 3 * i);
            }
        }
        return new AuxiliaryPicture(
                new Image(numbers.width(), numbers.height(), rgb),
                "objects: one colour for each place in the scene's list, lights after the last; black: nothing there");
    }

    /** A hue of its own; objects whose hues come near to each other differ in lightness. */
    private static void color(int id, float[] rgb, int k) {
        double hue = id * GOLDEN - Math.floor(id * GOLDEN);
        double value = id % 3 == 0 ? 1 : id % 3 == 1 ? 0.75 : 0.5;
        double saturation = id % 2 == 0 ? 0.75 : 0.5;
        for (int c = 0; c < 3; c++) {
            double turned = hue + (3 - c) / 3.0;
            double toPeak = Math.abs(turned - Math.floor(turned) - 0.5) * 6 - 1;
            double pure = Math.min(Math.max(toPeak, 0), 1);
            rgb[k + c] = (float) (value * (1 - saturation * (1 - pure)));
        }
    }

    private static float[] first(Image image) {
        float[] values = new float[image.width() * image.height()];
        for (int i = 0; i < values.length; i++) {
            values[i] = image.component(i % image.width(), i / image.width(), 0);
        }
        return values;
    }

    private static float[] sortedFinite(float[] values) {
        float[] sorted = values.clone();
        Arrays.sort(sorted);
        int n = 0;
        while (n < sorted.length && sorted[n] < Float.POSITIVE_INFINITY) {
            n++;
        }
        return Arrays.copyOf(sorted, n);
    }
}
