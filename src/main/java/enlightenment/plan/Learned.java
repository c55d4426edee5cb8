package enlightenment.plan;

import enlightenment.classic.cluster.ClusterStatistics;
import enlightenment.film.SampleLog;
import enlightenment.method.metropolis.ChainStatistics;
import java.util.List;
import java.util.function.Consumer;

/**
 * Listeners for what methods learn while they render. Several threads call the consumers at once.
 *
 * @param clusters receives the ray clusters of each block, if the method has any; null without a listener
 * @param chains receives the Markov chains of a quarter of each block, if the method has any; null without a listener
 * @param samples receives the camera samples that one thread takes, if {@link Integrators#recordsSamples}; null without a listener
 */
public record Learned(
        Consumer<List<ClusterStatistics>> clusters, Consumer<List<ChainStatistics>> chains, SampleLog samples) {
    /** No listener at all. */
    public static final Learned UNSEEN = new Learned(null, null);

    /** Listeners without a log of samples. */
    public Learned(Consumer<List<ClusterStatistics>> clusters, Consumer<List<ChainStatistics>> chains) {
        this(clusters, chains, null);
    }
}
