package enlightenment.store;

import enlightenment.film.SampleLog;

/** The data of camera samples that are kept beside the results of units. */
public enum StoredSamples {
    /** Nothing. */
    NONE(-1),
    /** Place, colour and weight. */
    PIXELS(SampleLog.PIXELS),
    /** Place, colour, weight and rays. */
    RAYS(SampleLog.RAYS);

    /** The least kind of block that has them; -1 for none. */
    final int kind;

    StoredSamples(int kind) {
        this.kind = kind;
    }
}
