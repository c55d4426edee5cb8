package enlightenment.render;

import enlightenment.image.Image;
import enlightenment.plan.Rounds;
import enlightenment.report.RenderReport;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What a render gave.
 *
 * @param image the picture; where the render was cancelled, the pixels that were not reached are those of the coarse passes of
 *     a progressive render, or else black
 * @param report what was done and how long it took
 * @param complete false where the render was cancelled, or its thread interrupted, before its end
 * @param shownPixels how many pixels of the picture are not left black: the finished ones, and those that only a coarse pass
 *     reached
 * @param auxiliary what was asked for beside the colours, in raw numbers: {@link Auxiliary} tells what they mean
 * @param clusters the ray clusters in the order of their blocks, if they were asked for and the method has any
 * @param chains the Markov chains in the order of their blocks and groups, if they were asked for and the method has any
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

    /** The same result, to be kept in a file, with the root mean square of what its rounding changes. */
    public RenderResult withRounding(double rounding) {
        return new RenderResult(
                image, report.withRounding(rounding), complete, shownPixels, auxiliary, clusters, chains, denoised);
    }

    /** This result with a second picture, and the report that counts it. */
    RenderResult withDenoised(Optional<Image> picture, RenderReport counted) {
        return new RenderResult(image, counted, complete, shownPixels, auxiliary, clusters, chains, picture);
    }
}
