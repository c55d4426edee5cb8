package enlightenment.cli.option;

import picocli.CommandLine.TypeConversionException;

/** A value that an option cannot have. The message goes on from the option's name: {@code must be ..., not "..."}. */
public final class BadValue extends TypeConversionException {
    private static final long serialVersionUID = 1L;

    public BadValue(String message) {
        super(message);
    }

    /** @param expected what the value should have been: {@code a whole number in 1..256} */
    public static BadValue expected(String expected, String given) {
        return new BadValue("must be " + expected + ", not \"" + given + "\"");
    }
}
