package enlightenment.codec;

/** The components of a picture that is to be written. */
@FunctionalInterface
public interface Components {
    /**
     * One component.
     *
     * @param x column, counted from 0 at the left
     * @param y row, counted from 0 at the top
     * @param channel 0 red, 1 green, 2 blue
     */
    float at(int x, int y, int channel);
}
