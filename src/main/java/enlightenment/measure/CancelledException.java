package enlightenment.measure;

/** Thrown when the user has cancelled the measurement. */
final class CancelledException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    CancelledException() {
        super("cancelled", null, false, false);
    }
}
