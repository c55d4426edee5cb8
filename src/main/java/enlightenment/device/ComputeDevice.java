package enlightenment.device;

/** A device that can shade samples. */
public interface ComputeDevice {
    /** As messages name it, its vendor included; made harmless. */
    String name();

    /** Whether it is a graphics processor, rather than the processor under another name. */
    boolean isGpu();

    /** Bytes of its memory. */
    long memory();

    /** What can be said of how fast it is: how many units it has, and their clock rate. */
    String speed();

    /** Why it cannot be used, without a full stop; empty if it can, as far as is known without trying. */
    String problem();

    /**
     * Measures how many operations in double precision it makes in a second, a fused product and sum being two; in some seconds.
     *
     * @throws DeviceFailure if it does not run the program, or does not compute as the processor does
     */
    double measureDoubleRate();

    /**
     * Compiles the program for scenes of a kind.
     *
     * @throws DeviceFailure if the device does not take it, or does not compute as the processor does
     */
    DeviceProgram compile(DeviceScene.Program which);
}
