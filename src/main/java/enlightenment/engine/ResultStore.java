package enlightenment.engine;

/**
 * Keeps results of units, to look at again those that are to be taken out of a picture in which they are added up with others.
 */
public interface ResultStore {
    /** Keeps nothing: nothing can be taken out. */
    ResultStore NONE = new ResultStore() {
        @Override
        public void keep(int unit, byte[] bytes) {}

        @Override
        public byte[] get(int unit) {
            throw new IllegalStateException("what unit " + unit + " was is not kept");
        }
    };

    /** Keeps a result, in place of what was kept of the unit. */
    void keep(int unit, byte[] bytes);

    /** The last result kept of a unit. */
    byte[] get(int unit);
}
