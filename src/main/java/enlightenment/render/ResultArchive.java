package enlightenment.render;

import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * Keeps what becomes of a render beyond the end of its process. A render is numbered units of work, each a pure function of scene,
 * settings, plan and its number; so a render that finds the results of some of its units kept needs to do only the others, and its picture
 * has the same bytes as if it had never been stopped.
 *
 * <p>An archive is of one picture: scene and settings without their budget. It holds plans, which say how many samples that picture is
 * to have, and the results of units of each. What they mean is the renderer's affair. Whoever opens an archive makes sure that it is of
 * this picture and this version of the program; what it gives is looked at all the same, and rendered again if it makes no sense.
 *
 * <p>Called by one thread at a time. An exception ends its use, and not the render: the picture is worth more.
 */
public interface ResultArchive extends Closeable {
    /** What messages call it, such as {@code checkpoint picture.ckpt}. */
    String name();

    /** The plans that are kept, by their numbers from 0. */
    List<byte[]> plans() throws IOException;

    /**
     * Keeps a plan.
     *
     * @return its number from now on; that of the same bytes if they are kept already
     */
    int keep(byte[] plan) throws IOException;

    /** Tells the results that are kept of a plan's units, in any order; damaged ones are left out. */
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

    /** Hears what an archive holds. */
    @FunctionalInterface
    interface Replay {
        /** The result of a unit; the array is the listener's. */
        void result(int unit, byte[] result) throws IOException;
    }

    /**
     * An archive that may want to hear of camera samples one by one, beside the results of units. Only methods that can tell of them do
     * ({@link Renderer#recordsSamples}).
     *
     * <p>Called by one thread at a time, as every {@link ResultArchive}.
     */
    interface OfSamples extends ResultArchive {
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
