package enlightenment.emitter;

/** A light that a {@link LightPicker} chose. A mutable work object, one per thread. */
public final class LightChoice {
    /** The light's index in the picker's list; −1 if no light can contribute. */
    public int light;

    /** The probability of this choice. */
    public double probability;

    /** What is left of the number that chose, again evenly distributed in 0..1. */
    public double rest;

    final double[] weights = new double[LightPicker.FEW];

    /** A choice to be made. */
    public LightChoice() {}

    void none(double number) {
        light = -1;
        probability = 0;
        rest = number;
    }
}
