package enlightenment.scene;

import enlightenment.check.Check;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * How a scene is rendered: by which method, in which size, with how many samples or to which error, on how many threads. What has no influence on
 * the picture says so. Begin with {@link #of} and change what should differ by the {@code with} methods, or several settings at once by {@link
 * #toBuilder}.
 *
 * @param method which samples are taken
 * @param width width of the whole picture in pixels
 * @param height height of the whole picture in pixels
 * @param crop the part to render; its pixels are the same as in the whole picture
 * @param antialias n for n × n positions per pixel, 1..256
 * @param budget what ends the render, if not the number of positions
 * @param chosen the {@link ChosenSettings.Common}, and those of methods, any of them: {@link BuiltInMethod.RayTraceSettings#of} and its like tell one's
 * @param threads how many threads share the work, 1..4096; has no influence on the picture
 * @param tileSize side of the square tiles in pixels that the work is cut into, at least 1; has no influence on the picture
 */
public record RenderSettings(
        Method method,
        int width,
        int height,
        Optional<Crop> crop,
        int antialias,
        Budget budget,
        ChosenSettings chosen,
        int threads,
        int tileSize) {
    private static final int DEFAULT_TILE_SIZE = 8;
    private static final int MAX_THREADS = 4096;

    /**
     * A part of the picture.
     *
     * @param x first column
     * @param y first row, counted from the top
     * @param width number of columns, at least 1
     * @param height number of rows, at least 1
     */
    public record Crop(int x, int y, int width, int height) {
        /** The pixels that are also in the other rectangle; there must be some. */
        public Crop intersection(Crop other) {
            int left = Math.max(x, other.x);
            int top = Math.max(y, other.y);
            int right = Math.min(x + width, other.x + other.width);
            int bottom = Math.min(y + height, other.y + other.height);
            return new Crop(left, top, right - left, bottom - top);
        }
    }

    /**
     * Checks the ranges.
     *
     * @throws enlightenment.math.InvalidValueException if a setting is out of its range, or the crop not inside the picture
     */
    public RenderSettings {
        Objects.requireNonNull(budget, "budget");
        Scene.checkSize(width, height);
        if (crop.isPresent()) {
            Crop c = crop.get();
            boolean inside = c.x >= 0
                    && c.y >= 0
                    && c.width >= 1
                    && c.height >= 1
                    && (long) c.x + c.width <= width
                    && (long) c.y + c.height <= height;
            Check.that(
                    inside,
                    "crop",
                    "must lie inside the picture of " + width + "x" + height + " pixels, not " + c.x + "," + c.y + ","
                            + c.width + "," + c.height);
        }
        // One place knows the limits.
        new Defaults(method, antialias, chosen);
        Check.that(
                threads >= 1 && threads <= MAX_THREADS,
                "threads",
                "must lie in 1.." + MAX_THREADS + ", not " + threads);
        Check.that(tileSize >= 1, "tileSize", "must be at least 1, not " + tileSize);
    }

    /** What the scene asks for, of the whole picture, on all processors. */
    public static RenderSettings of(Scene scene) {
        Defaults d = scene.render();
        return new RenderSettings(
                d.method(),
                scene.width(),
                scene.height(),
                Optional.empty(),
                d.antialias(),
                Budget.NONE,
                d.chosen(),
                Runtime.getRuntime().availableProcessors(),
                DEFAULT_TILE_SIZE);
    }

    /** A builder that begins with these settings. */
    public Builder toBuilder() {
        return new Builder(this);
    }

    /** These settings with another method. */
    public RenderSettings withMethod(Method value) {
        return toBuilder().method(value).build();
    }

    /** These settings for a whole picture of another size in pixels. */
    public RenderSettings withSize(int w, int h) {
        return toBuilder().size(w, h).build();
    }

    /** These settings for a part of the picture. */
    public RenderSettings withCrop(Crop value) {
        return toBuilder().crop(value).build();
    }

    /** These settings with n × n positions per pixel. */
    public RenderSettings withAntialias(int value) {
        return toBuilder().antialias(value).build();
    }

    /** These settings with other values of one method's own, whichever method is in use. */
    public RenderSettings with(Method.Settings value) {
        return toBuilder().with(value).build();
    }

    /** These settings with another value of one that some methods have, or all. */
    public RenderSettings with(Method.Setting setting, Object value) {
        return toBuilder().chosen(chosen.with(setting, value)).build();
    }

    /** These settings with the method of these values, and with the values. */
    public RenderSettings using(Method.Settings value) {
        return toBuilder().method(value.method()).with(value).build();
    }

    /** The seed that all random numbers are derived from. */
    public long seed() {
        return (Long) chosen.value(ChosenSettings.Common.SEED);
    }

    /** These settings with another seed. */
    public RenderSettings withSeed(long value) {
        return with(ChosenSettings.Common.SEED, value);
    }

    /** These settings with another budget. */
    public RenderSettings withBudget(Budget value) {
        return toBuilder().budget(value).build();
    }

    /** These settings with another number of samples per pixel in their budget, {@link Budget#samples}. */
    public RenderSettings withSamples(double value) {
        return withBudget(budget.withSamples(value));
    }

    /** These settings with another error in their budget, {@link Budget#error}. */
    public RenderSettings withError(double value) {
        return withBudget(budget.withError(value));
    }

    /** These settings with another time in their budget, {@link Budget#seconds}. */
    public RenderSettings withSeconds(double value) {
        return withBudget(budget.withSeconds(value));
    }

    /** These settings with another number of threads. */
    public RenderSettings withThreads(int value) {
        return toBuilder().threads(value).build();
    }

    /** These settings with tiles of another side in pixels. */
    public RenderSettings withTileSize(int value) {
        return toBuilder().tileSize(value).build();
    }

    /** The part of the picture that is rendered: the crop, or all of it. */
    public Crop region() {
        return crop.orElse(new Crop(0, 0, width, height));
    }

    /** Changes several settings at once; nothing is checked before {@link #build}. For use by one thread. */
    public static final class Builder {
        private Method method;
        private int width;
        private int height;
        private Optional<Crop> crop;
        private int antialias;
        private Budget budget;
        private ChosenSettings chosen;
        private int threads;
        private int tileSize;

        private Builder(RenderSettings s) {
            method = s.method;
            width = s.width;
            height = s.height;
            crop = s.crop;
            antialias = s.antialias;
            budget = s.budget;
            chosen = s.chosen;
            threads = s.threads;
            tileSize = s.tileSize;
        }

        /** Sets {@link RenderSettings#method}. */
        public Builder method(Method value) {
            method = value;
            return this;
        }

        /** Sets {@link RenderSettings#width} and {@link RenderSettings#height}. */
        public Builder size(int w, int h) {
            width = w;
            height = h;
            return this;
        }

        /** Sets {@link RenderSettings#crop}. */
        public Builder crop(Crop value) {
            crop = Optional.of(value);
            return this;
        }

        /** Renders the whole picture. */
        public Builder wholePicture() {
            crop = Optional.empty();
            return this;
        }

        /** Sets {@link RenderSettings#antialias}. */
        public Builder antialias(int value) {
            antialias = value;
            return this;
        }

        /** Sets {@link RenderSettings#seed}. */
        public Builder seed(long value) {
            chosen = chosen.with(ChosenSettings.Common.SEED, value);
            return this;
        }

        /** Sets {@link RenderSettings#budget}. */
        public Builder budget(Budget value) {
            budget = value;
            return this;
        }

        /** Sets {@link RenderSettings#chosen}. */
        public Builder chosen(ChosenSettings value) {
            chosen = value;
            return this;
        }

        /** Sets all settings of one method. */
        public Builder with(Method.Settings value) {
            chosen = chosen.with(value);
            return this;
        }

        /** Sets {@link RenderSettings#threads}. */
        public Builder threads(int value) {
            threads = value;
            return this;
        }

        /** Sets {@link RenderSettings#tileSize}. */
        public Builder tileSize(int value) {
            tileSize = value;
            return this;
        }

        /**
         * The settings.
         *
         * @throws enlightenment.math.InvalidValueException if one is out of its range, or the crop not inside the picture
         */
        public RenderSettings build() {
            return new RenderSettings(method, width, height, crop, antialias, budget, chosen, threads, tileSize);
        }
    }

    /**
     * The settings that a scene asks to be rendered with, unless the user says otherwise.
     *
     * @param method which samples are taken, {@link Method#RAYTRACE} unless given
     * @param antialias n for n × n positions per pixel, 1..256
     * @param chosen what the scene says of all other settings; not only of those of its own method
     */
    public record Defaults(Method method, int antialias, ChosenSettings chosen) {
        /** The largest n for n × n positions per pixel. */
        public static final int MAX_ANTIALIAS = 256;

        /** What a scene asks for that says nothing. */
        public static final Defaults DEFAULT = new Defaults(Method.RAYTRACE, 4, ChosenSettings.NONE);

        /**
         * Checks the ranges.
         *
         * @throws enlightenment.math.InvalidValueException if a number is out of its range
         */
        public Defaults {
            Objects.requireNonNull(method, "method");
            Check.that(
                    antialias >= 1 && antialias <= MAX_ANTIALIAS,
                    "antialias",
                    "must lie in 1.." + MAX_ANTIALIAS + ", not " + antialias);
            Objects.requireNonNull(chosen, "chosen");
        }
    }

    /**
     * How much a picture may cost, or how exact it must be: whichever comes first ends the render. With nothing given,
     * {@code antialias} says how many samples there are.
     *
     * @param samples camera rays per pixel, in the mean over the picture; 1..16,777,216. The method
     *     {@code cluster} cannot do with less than about 2.3, and may take some per cent more where it learns
     * @param error root mean square error of the picture, in display units 0..1, that need not be undercut; greater than 0. It is met
     *     where the upper end of the interval that is to hold the true error is at most this
     * @param seconds time by the clock for planning and rendering; greater than 0. It is turned into a number of samples early, so
     *     that the picture can be made again with that number
     * @param depth bits per component, 1..16, of the file that is to keep the error: its rounding counts as error, too. 0 where
     *     only the picture itself, in floats, is meant. Without an error it means nothing
     */
    public record Budget(OptionalDouble samples, OptionalDouble error, OptionalDouble seconds, int depth) {
        /** More samples per pixel than this are refused. */
        public static final double MAX_SAMPLES = 1 << 24;

        private static final int MAX_DEPTH = 16;

        /** No limits. */
        public static final Budget NONE =
                new Budget(OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty(), 0);

        public Budget {
            if (samples.isPresent()) {
                double n = samples.getAsDouble();
                Check.that(
                        n >= 1 && n <= MAX_SAMPLES, "samples", "must lie in 1.." + (long) MAX_SAMPLES + ", not " + n);
            }
            if (error.isPresent()) {
                double e = error.getAsDouble();
                Check.that(e > 0 && e < Double.POSITIVE_INFINITY, "error", "must be greater than 0, not " + e);
            }
            if (seconds.isPresent()) {
                double s = seconds.getAsDouble();
                Check.that(s > 0 && s < Double.POSITIVE_INFINITY, "time", "must be greater than 0, not " + s);
            }
            Check.that(depth >= 0 && depth <= MAX_DEPTH, "depth", "must lie in 0.." + MAX_DEPTH + ", not " + depth);
        }

        /** This budget with another number of samples per pixel, as {@link #samples}. */
        public Budget withSamples(double value) {
            return new Budget(OptionalDouble.of(value), error, seconds, depth);
        }

        /** This budget with another error, as {@link #error}. */
        public Budget withError(double value) {
            return new Budget(samples, OptionalDouble.of(value), seconds, depth);
        }

        /** This budget with another time, as {@link #seconds}. */
        public Budget withSeconds(double value) {
            return new Budget(samples, error, OptionalDouble.of(value), depth);
        }

        /** This budget for a file of another depth, as {@link #depth}. */
        public Budget withDepth(int value) {
            return new Budget(samples, error, seconds, value);
        }

        /**
         * The budget with which the same picture is made again: a number of samples in place of an error or a time.
         *
         * @param planned the number of samples that this budget has become
         */
        public Budget replayable(double planned) {
            return error.isEmpty() && seconds.isEmpty() ? this : NONE.withSamples(planned);
        }

        /** Whether nothing is given. */
        public boolean isNone() {
            return samples.isEmpty() && error.isEmpty() && seconds.isEmpty();
        }
    }
}
