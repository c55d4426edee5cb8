package enlightenment.plan;

import enlightenment.classic.cluster.ClusterStatistics;
import enlightenment.film.SampleLog;
import enlightenment.method.metropolis.ChainStatistics;
import java.util.List;
import java.util.function.Consumer;

/**
 * Who is shown what methods learn on their way: the consumers from several threads at once.
 *
 * @param clusters is shown the ray clusters of each block, if the method has any; null for nobody
 * @param chains is shown the Markov chains of a quarter of each block, if the method has any; null for nobody
 * @param samples is told of the camera samples that one thread takes, if {@link Integrators#recordsSamples}; null for nobody
 */
public record Learned(
        Consumer<List<ClusterStatistics>> clusters, Consumer<List<ChainStatistics>> chains, SampleLog samples) {
    /** Nobody wants to see anything. */
    public static final Learned UNSEEN = new Learned(null, null);

    /** Who does not want to see samples. */
    public Learned(Consumer<List<ClusterStatistics>> clusters, Consumer<List<ChainStatistics>> chains) {
        this(clusters, chains, null);
    }
}
