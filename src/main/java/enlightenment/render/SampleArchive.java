package enlightenment.render;

import java.io.IOException;

/**
 * An archive that may want to hear of camera samples one by one, beside the results of units. Only methods that can tell of them do
 * ({@link Renderer#recordsSamples}).
 *
 * <p>Called by one thread at a time, as every {@link ResultArchive}.
 */
public interface SampleArchive extends ResultArchive {
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
