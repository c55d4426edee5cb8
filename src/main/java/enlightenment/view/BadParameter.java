package enlightenment.view;

/** A request says something that an action cannot take; the message says what it takes. */
final class BadParameter extends RuntimeException {
    private static final long serialVersionUID = 1;

    BadParameter(String message) {
        super(message);
    }
}
