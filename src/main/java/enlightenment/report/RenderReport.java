package enlightenment.report;

import enlightenment.numeric.Counts;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a render did: counts that depend on scene and settings only, and times that do not.
 *
 * @param sceneName the scene's name
 * @param settings the settings in force
 * @param features what was modelled, in plain words
 * @param raysByKind number of rays by kind: camera, mirror, refracted, shadow
 * @param lightSamples light points that were asked for: hits × lights × shadow samples
 * @param lightSamplesWithoutRay those of them that needed no shadow ray, because nothing can stand before the light
 * @param sampling how many samples there are, why, and how exact the picture is
 * @param testsByPrimitive intersection tests by kind of primitive
 * @param hitsByPrimitive surface points shaded or passed, by kind of primitive
 * @param textureLookups texture colours looked up
 * @param phases wall-clock and processor time per phase, in order
 * @param pixels pixels finished; where paths may end anywhere, the share of the pixels that is the share of the paths
 * @param peakMemoryBytes most heap memory in use, as far as it was observed
 *
 */
public record RenderReport(
        String sceneName,
        RenderSettings settings,
        List<String> features,
        Map<String, Long> raysByKind,
        long lightSamples,
        long lightSamplesWithoutRay,
        Sampling sampling,
        Map<String, Long> testsByPrimitive,
        Map<String, Long> hitsByPrimitive,
        long textureLookups,
        List<Phase> phases,
        long pixels,
        long peakMemoryBytes) {

    /**
     * How the picture was sampled.
     *
     * @param method what made the samples: the method of the settings, or its {@link Method#standIn stand-in} where there were too few
     *     samples for its survey
     * @param decidedBy which part of the budget was decisive: antialias, samples, error or time; nothing if it was stopped before it was planned
     * @param plannedSamples camera rays per pixel that were planned; as {@code --samples} this makes the same picture; 0 if it was stopped before
     * @param samplesPerPixel camera rays per pixel that were taken, those of surveys included
     * @param estimatedError root mean square error of the picture as its own samples tell, in display units 0..1
     * @param errorLow lower end of an interval that is to hold the true error in 95 of 100 pictures
     * @param errorHigh upper end of that interval
     * @param clusters ray clusters that proposed light points; of {@link Method#METROPOLIS} Markov chains
     * @param proposals light points that were proposed; of chains steps
     * @param accepted those of them that were of the kind sought; of chains steps that were made
     * @param rounding root mean square of what rounding to the depth of the budget changes; 0 where there is none
     * @param rounds how often the picture was rendered: more than once where it was not as exact as asked
     * @param light the error of linear light beside that; empty for display-referred pictures
     */
    public record Sampling(
            Method method,
            String decidedBy,
            double plannedSamples,
            double samplesPerPixel,
            double estimatedError,
            double errorLow,
            double errorHigh,
            long clusters,
            long proposals,
            long accepted,
            double rounding,
            int rounds,
            Optional<Light> light) {
        /** How it was sampled, for a display-referred picture. */
        public Sampling(
                Method method,
                String decidedBy,
                double plannedSamples,
                double samplesPerPixel,
                double estimatedError,
                double errorLow,
                double errorHigh,
                long clusters,
                long proposals,
                long accepted,
                double rounding,
                int rounds) {
            this(
                    method,
                    decidedBy,
                    plannedSamples,
                    samplesPerPixel,
                    estimatedError,
                    errorLow,
                    errorHigh,
                    clusters,
                    proposals,
                    accepted,
                    rounding,
                    rounds,
                    Optional.empty());
        }

        /** The error that is to be counted on, with that of rounding: the upper end of the interval. */
        public double errorInFile() {
            return Math.hypot(errorHigh, rounding);
        }

        private Sampling with(double newRounding) {
            return new Sampling(
                    method,
                    decidedBy,
                    plannedSamples,
                    samplesPerPixel,
                    estimatedError,
                    errorLow,
                    errorHigh,
                    clusters,
                    proposals,
                    accepted,
                    newRounding,
                    rounds,
                    light);
        }
    }

    /**
     * What the samples tell of linear light, where {@link Sampling#estimatedError} tells of what a screen shows.
     *
     * @param relativeError root of the mean, over pixels and bands, of the estimated variance over m² + (0.05 M)², where m is the
     *     pixel's value and M the mean of the band over the picture; NaN where it is not known, as of a single sample per pixel
     * @param kurtosis how unevenly what tells the error is spread over the pixels: 1 where all tell the same, n where one of n tells
     *     all, within blocks of 32 × 32 pixels; NaN where it is not known
     * @param heavyTail whether few bright samples carry the error, so that it may be underestimated
     * @param lostSamples how many samples were infinite or no numbers, and taken for black; more than none is a fault of the program
     * @param undersampled why the error may be underestimated whatever the samples show, each as the end of a sentence: it follows from scene and
     *     method; empty if no reason is known
     */
    public record Light(
            double relativeError, double kurtosis, boolean heavyTail, long lostSamples, List<String> undersampled) {
        public Light {
            undersampled = List.copyOf(undersampled);
        }

        /** Where all light transport is sampled. */
        public Light(double relativeError, double kurtosis, boolean heavyTail, long lostSamples) {
            this(relativeError, kurtosis, heavyTail, lostSamples, List.of());
        }
    }

    /** How many samples were infinite or no numbers: if there are any, the picture is not to be trusted. */
    public long lostSamples() {
        return sampling.light().map(Light::lostSamples).orElse(0L);
    }

    /**
     * How long a phase took.
     *
     * @param name compile, auxiliary (only where that takes rays of its own), plan, preview (only where asked for), earlier render
     *     (only where there was more than one round), render or finish
     * @param wallSeconds by the clock
     * @param cpuSeconds of all threads together, 0 where the machine cannot tell
     */
    public record Phase(String name, double wallSeconds, double cpuSeconds) {}

    /**
     * False if an error was asked for that is not sure to be kept: where the upper end of the interval, together with the rounding
     * of the file, is larger.
     */
    public boolean isErrorMet() {
        return settings.budget().error().isEmpty()
                || sampling.errorInFile() <= settings.budget().error().getAsDouble();
    }

    /**
     * Which part of the budget was decisive: antialias, samples, error or time. That is the time, too, where an error would have been met
     * if there had been time for another picture.
     */
    public String decidedBy() {
        String decisive = sampling.decidedBy();
        boolean ranOut = decisive.equals("error") && settings.budget().seconds().isPresent() && !isErrorMet();
        return ranOut ? "time" : decisive;
    }

    /** This report with another root mean square of the rounding of its file. */
    public RenderReport withRounding(double rounding) {
        return with(sampling.with(rounding), phases);
    }

    /** This report of a render of which these are the phases. */
    public RenderReport withPhases(List<Phase> all) {
        return with(sampling, all);
    }

    private RenderReport with(Sampling figures, List<Phase> all) {
        return new RenderReport(
                sceneName,
                settings,
                features,
                raysByKind,
                lightSamples,
                lightSamplesWithoutRay,
                figures,
                testsByPrimitive,
                hitsByPrimitive,
                textureLookups,
                all,
                pixels,
                peakMemoryBytes);
    }

    /** All rays of all kinds; the largest number there is where they are more. */
    public long rays() {
        return Counts.sum(raysByKind.values().stream().mapToLong(Long::longValue));
    }

    /** Rays per second of the render phase's wall-clock time; 0 where there was none. */
    public double raysPerSecond() {
        return phases.stream()
                .filter(p -> p.name().equals("render"))
                .mapToDouble(p -> p.wallSeconds() > 0 ? rays() / p.wallSeconds() : 0)
                .sum();
    }
}
