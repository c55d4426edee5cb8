package enlightenment.device;

import enlightenment.math.InvalidValueException;

/**
 * Which device takes part in a render.
 *
 * @param kind none, or one of a kind
 * @param number of the device among those of its kind, from 0
 */
public record DeviceChoice(Kind kind, int number) {
    /** What a choice may be. */
    public enum Kind {
        /** The processor alone. */
        CPU,
        /** A device that is programmed in OpenCL. */
        OPENCL,
        /** A graphics processor, where there is one and the render is one that it can take part in. */
        AUTO
    }

    /** The word for the processor alone. */
    public static final String NONE = "cpu";

    /** What the words may be. */
    public static final String WORDS = "cpu, opencl, opencl:N with N from 0, or auto";

    /** Devices of one machine. */
    private static final int MOST = 255;

    private static final String NUMBERED = "opencl:";

    /**
     * The choice that a word stands for.
     *
     * @throws InvalidValueException key {@code device} for another word
     */
    public static DeviceChoice of(String word) {
        if (word.equals(NONE)) {
            return new DeviceChoice(Kind.CPU, 0);
        }
        if (word.equals("auto")) {
            return new DeviceChoice(Kind.AUTO, 0);
        }
        boolean isNumbered = word.matches("opencl:[0-9]{1,3}");
        int number = isNumbered ? Integer.parseInt(word.substring(NUMBERED.length())) : 0;
        if (!isNumbered && !word.equals("opencl") || number > MOST) {
            throw new InvalidValueException("device", "must be " + WORDS);
        }
        return new DeviceChoice(Kind.OPENCL, number);
    }
}
