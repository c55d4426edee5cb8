package enlightenment.nff;

/** Something in the file is not what the format asks for; caught by the reader, which goes on with the next entity. */
final class NffSyntaxException extends Exception {
    private static final long serialVersionUID = 1L;

    private final int line;
    private final int column;

    NffSyntaxException(NffToken at, String message) {
        super(message, null, false, false);
        line = at.line();
        column = at.column();
    }

    int line() {
        return line;
    }

    int column() {
        return column;
    }
}
