package enlightenment.view;

/** Thrown for a request parameter that an action cannot take; the message names the accepted values. */
final class BadParameter extends RuntimeException {
    private static final long serialVersionUID = 1;

    BadParameter(String message) {
        super(message);
    }
}
