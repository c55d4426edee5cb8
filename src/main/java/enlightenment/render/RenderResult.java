package enlightenment.render;

import enlightenment.classic.cluster.ClusterStatistics;
import enlightenment.frame.SceneFrame;
import enlightenment.image.Image;
import enlightenment.math.ExactPoint;
import enlightenment.method.metropolis.ChainStatistics;
import enlightenment.numeric.Scale;
import enlightenment.plan.Rounds;
import enlightenment.report.RenderReport;
import enlightenment.sampling.RunningStatistics;
import java.io.Closeable;
import java.io.IOException;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The result of a render: the picture, a report, and the further outputs of the request.
 *
 * @param image the picture; where the render was cancelled, the pixels that were not reached are those of the coarse passes of a
 *     progressive render, or else black
 * @param report statistics and times of the render
 * @param complete false where the render was cancelled, or its thread interrupted, before its end
 * @param shownPixels how many pixels of the picture are not left black: the finished ones, and those that only a coarse pass reached
 * @param auxiliary the requested images beside the picture, in raw numbers: {@link Auxiliary} defines them
 * @param clusters the ray clusters in the order of their blocks, if they were requested and the method has any
 * @param chains the Markov chains in the order of their blocks and groups, if they were requested and the method has any
 * @param denoised the picture without grain, if it was asked for and the picture is complete; its error is not known
 */
public record RenderResult(
        Image image,
        RenderReport report,
        boolean complete,
        long shownPixels,
        Map<Auxiliary, Image> auxiliary,
        List<RayCluster> clusters,
        List<PathChain> chains,
        Optional<Image> denoised) {

    /** A result without chains and without a second picture. */
    public RenderResult(
            Image image,
            RenderReport report,
            boolean complete,
            long shownPixels,
            Map<Auxiliary, Image> auxiliary,
            List<RayCluster> clusters) {
        this(image, report, complete, shownPixels, auxiliary, clusters, List.of(), Optional.empty());
    }

    public RenderResult {
        EnumMap<Auxiliary, Image> copy = new EnumMap<>(Auxiliary.class);
        copy.putAll(auxiliary);
        clusters = List.copyOf(clusters);
        chains = List.copyOf(chains);
        auxiliary = Collections.unmodifiableMap(copy);
    }

    /**
     * About how many samples per pixel would keep the error that was asked for, whatever other limits there were; empty if it is
     * kept, or no number of samples would do.
     */
    public OptionalDouble samplesForError() {
        return Rounds.samplesForError(report);
    }

    /** This result with the root mean square of the rounding of the file that keeps it. */
    public RenderResult withRounding(double rounding) {
        return new RenderResult(
                image, report.withRounding(rounding), complete, shownPixels, auxiliary, clusters, chains, denoised);
    }

    /** This result with a second picture, and the report that counts it. */
    RenderResult withDenoised(Optional<Image> picture, RenderReport counted) {
        return new RenderResult(image, counted, complete, shownPixels, auxiliary, clusters, chains, picture);
    }

    /**
     * A ray cluster as the paper describes it: rays that pass close to each other through the window and end on the same surface
     * and light, with one distribution for each coordinate of their three points. Rays whose light point turned out to be hidden
     * are not valid and do not count in the distributions.
     *
     * @param x first column of the block of pixels
     * @param y first row of the block of pixels
     * @param surface number of the last surface; the same as in the auxiliary image of objects
     * @param light index of the light in the scene
     * @param bounces how many mirrors and glass surfaces the rays met before
     * @param tried rays that were tried
     * @param valid rays whose light point was visible
     * @param gain how many times smaller proposals were expected to make the variance of a light point; 1 where none were used
     * @param distributions of the coordinates, in the scene's units: {@link #COORDINATES} names them; empty without valid rays
     */
    public record RayCluster(
            int x,
            int y,
            int surface,
            int light,
            int bounces,
            long tried,
            long valid,
            double gain,
            List<Coordinate> distributions) {
        /** P is the point on the window, S that on the surface, L that on the light. */
        public static final List<String> COORDINATES = List.of("Px", "Py", "Pz", "Sx", "Sy", "Sz", "Lx", "Ly", "Lz");

        /**
         * The distribution of a coordinate.
         *
         * @param mean its mean
         * @param deviation its standard deviation
         */
        public record Coordinate(double mean, double deviation) {}

        static RayCluster of(ClusterStatistics record, SceneFrame frame) {
            List<Coordinate> distributions = new ArrayList<>();
            long valid = record.coordinate(0).count();
            for (int k = 0; k < ClusterStatistics.COORDINATES && valid > 0; k++) {
                RunningStatistics s = record.coordinate(k);
                double mean = originComponent(frame.origin(), k % 3) + Scale.scalb(s.mean(), frame.exponent());
                distributions.add(new Coordinate(mean, Scale.scalb(s.standardDeviation(), frame.exponent())));
            }
            return new RayCluster(
                    record.blockX,
                    record.blockY,
                    record.surface,
                    record.light,
                    record.bounces,
                    record.tried(),
                    valid,
                    record.gain(),
                    List.copyOf(distributions));
        }

        private static double originComponent(ExactPoint origin, int axis) {
            BigDecimal c = axis == 0 ? origin.x() : axis == 1 ? origin.y() : origin.z();
            return c.doubleValue();
        }
    }

    /**
     * A Markov chain of method {@code metropolis}: a path that found light, and the paths near it that it led to, one after the other, all
     * of which begin in one block of the picture.
     *
     * @param blockX first column of the block of pixels
     * @param blockY first row of the block
     * @param group the group of independent paths that it began with one of, 0..7: groups do not depend on each other
     * @param startX column of the pixel that it began in
     * @param startY row of that pixel
     * @param endX column of the pixel that it ended in
     * @param endY row of that pixel
     * @param startBrightness how bright its first path was: luminance and a third of the mean of the bands, of light or of what a screen
     *     takes, as the scene's shading has it
     * @param meanBrightness how bright the group's independent paths were in the mean: the first is in proportion more probable, the
     *     brighter it is
     * @param steps how many steps were proposed
     * @param accepted how many of them were made
     * @param largeSteps how many of the proposals were new paths altogether
     * @param largeAccepted how many of these were accepted
     */
    public record PathChain(
            int blockX,
            int blockY,
            int group,
            int startX,
            int startY,
            int endX,
            int endY,
            double startBrightness,
            double meanBrightness,
            long steps,
            long accepted,
            long largeSteps,
            long largeAccepted) {

        static PathChain of(ChainStatistics c) {
            return new PathChain(
                    c.blockX(),
                    c.blockY(),
                    c.group(),
                    c.startX(),
                    c.startY(),
                    c.endX(),
                    c.endY(),
                    c.startBrightness(),
                    c.meanBrightness(),
                    c.steps(),
                    c.accepted(),
                    c.largeSteps(),
                    c.largeAccepted());
        }
    }

    /**
     * Keeps what becomes of a render beyond the end of its process. A render is numbered units of work, each a pure function of scene,
     * settings, plan and its number; so a render that finds the results of some of its units kept needs to do only the others, and its
     * picture has the same bytes as if it had never been stopped.
     *
     * <p>An archive is of one picture: scene and settings without their budget. It holds plans, which say how many samples that picture is
     * to have, and the results of units of each. Only the renderer interprets their bytes. The caller that opens an archive makes sure that
     * it is of this picture and this version of the program; the renderer checks its results all the same, and renders a unit again whose
     * result is not valid.
     *
     * <p>Called by one thread at a time. An exception ends its use, and not the render: the picture is worth more.
     */
    public interface Archive extends Closeable {
        /** Its name in messages, such as {@code checkpoint picture.ckpt}. */
        String name();

        /** The plans that are kept, by their numbers from 0. */
        List<byte[]> plans() throws IOException;

        /**
         * Keeps a plan.
         *
         * @return its number from now on; that of the same bytes if they are kept already
         */
        int keep(byte[] plan) throws IOException;

        /** Passes the kept results of a plan's units to a listener, in any order, without damaged ones. */
        void replay(int plan, Replay to) throws IOException;

        /** The result that is kept of one unit; empty if there is none, or a damaged one. */
        Optional<byte[]> find(int plan, int unit) throws IOException;

        /**
         * Keeps the result of a unit, in place of what is kept of it. What was kept before the last {@link #tick} outlives the end of the
         * process, and of the machine as far as its disk does.
         *
         * @param worker who made it, to be looked up later: any text
         */
        void keep(int plan, int unit, String worker, byte[] result) throws IOException;

        /** Forgets what is kept of a unit: who made it is not to be trusted. */
        void remove(int plan, int unit) throws IOException;

        /**
         * Forgets what one worker made of a plan's units: it is not to be trusted. An archive that does not know who made what forgets nothing.
         *
         * @param worker as it was told when results were kept
         */
        default void removeAll(int plan, String worker) throws IOException {}

        /** Time has passed: called a few times a second while the render runs, by some thread. */
        default void tick() throws IOException {}

        /** Lets all of it reach the disk, and closes it. */
        @Override
        void close() throws IOException;

        /** Receives the results of an archive. */
        @FunctionalInterface
        interface Replay {
            /** The result of a unit; the array is the listener's. */
            void result(int unit, byte[] result) throws IOException;
        }

        /**
         * An archive that may want to hear of camera samples one by one, beside the results of units. Only methods that can tell of them do
         * ({@link Renderer#recordsSamples}).
         *
         * <p>Called by one thread at a time, as every {@link Archive}.
         */
        interface OfSamples extends Archive {
            /** Whether samples are wanted. Units without them are rendered again. */
            boolean keepsSamples();

            /** Whether their rays are wanted, too. */
            boolean keepsRays();

            /**
             * Keeps samples of a unit; its result follows. A unit may have several blocks, and a unit without samples has an empty one.
             *
             * @param kind 0 for samples alone, 1 for samples with their rays
             * @param samples how many
             * @param block what is known of them, column by column: docs/guide/sample-store.md has its form
             */
            void keepSamples(int plan, int unit, int kind, int samples, byte[] block) throws IOException;
        }
    }

    /**
     * The kinds of images beside the picture. Each is an {@link enlightenment.image.Image} of raw numbers, as large as the picture; where
     * there is one number per pixel, all three components are equal.
     */
    public enum Auxiliary {
        /**
         * The estimated standard deviation of the pixel's colour, in display units 0..1. The estimate of a single pixel is a rough
         * guess, so this is the root of the mean variance over the 3×3 finished pixels around it; +∞ where nothing is finished.
         */
        ERROR,

        /** The number of samples in the pixel; 0 where it is not finished. */
        SAMPLES,

        /**
         * The depth of the first surface on the ray through the pixel's middle. It is the distance from the eye along the ray, in the
         * scene's units; +∞ where there is nothing. The orthographic camera's rays start on the plane through its eye; in the isometric
         * view, which has no eye, it is the plane through the point that the camera looks at, and what lies before that has a negative
         * depth.
         */
        DEPTH,

        /**
         * The unit normal there, in the scene's axes, on the side that faces the viewer: x, y, z in −1..1 as the three components;
         * 0, 0, 0 where there is nothing.
         */
        NORMAL,

        /**
         * The position of that surface point: x, y, z in the scene's units and axes. They are the nearest floats; 0, 0, 0 where there is
         * nothing.
         */
        POSITION,

        /**
         * The object of that surface: its index in the scene's list of objects, from 0. Lights count on after the last object; −1 where
         * there is nothing.
         */
        OBJECT,

        /**
         * The albedo of the first surface that is neither a mirror nor glass. It is linear, 0..1: the colour, or of a metal the reflectance
         * at normal incidence; the mean over the samples of the pixel. Where mirrors and glass show the surface, it includes their colours.
         * Black where there is nothing. Physical shading only, as are those that follow.
         */
        ALBEDO,

        /**
         * The part of the picture that comes from lights, emitters and the background straight: as they are seen, and from them to the
         * first surface that is neither a mirror nor glass; also where mirrors and glass show it. Linear light.
         */
        DIRECT,

        /**
         * The rest of the picture: light that has been scattered at least twice, and caustics, which are light that came by way of mirrors
         * or glass to the surface that is seen. The picture less {@link #DIRECT}, so that both add up to it; noise can make it negative
         * where the picture is not made of the same paths, as by method {@code cluster}.
         */
        INDIRECT;

        /** The names that the command line knows, in order. */
        public static List<String> words() {
            return Arrays.stream(values()).map(Auxiliary::word).toList();
        }

        /** The kind with this name, if there is any. */
        public static Optional<Auxiliary> of(String word) {
            return Arrays.stream(values()).filter(a -> a.word().equals(word)).findFirst();
        }

        /** Its name in small letters, as on the command line and in names of files. */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** Whether one ray per pixel gives it rather than the samples of the picture. */
        boolean needsRays() {
            return this == DEPTH || this == NORMAL || this == POSITION || this == OBJECT;
        }

        /**
         * The channels of its layer, which has this {@linkplain #word name}, as in OpenEXR files. They are R, G, B of what is light or
         * reflectance, X, Y, Z of points and directions, Z of the depth and Y of other single numbers.
         */
        public List<String> channels() {
            return switch (this) {
                case ERROR, SAMPLES, OBJECT -> List.of("Y");
                case DEPTH -> List.of("Z");
                case NORMAL, POSITION -> List.of("X", "Y", "Z");
                case ALBEDO, DIRECT, INDIRECT -> List.of("R", "G", "B");
            };
        }

        /** Whether the numbers are light or reflectance, of physical shading. */
        public boolean needsPaths() {
            return this == ALBEDO || this == DIRECT || this == INDIRECT;
        }
    }
}
