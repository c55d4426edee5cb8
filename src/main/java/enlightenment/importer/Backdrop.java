package enlightenment.importer;

import enlightenment.check.Radiance;
import enlightenment.color.Rgb;

/** The surroundings that replace those of a file, or stand in for them where it has none. */
public sealed interface Backdrop permits Backdrop.Studio, Backdrop.Sky, Backdrop.Constant {
    /** Soft grey light from everywhere, as around models without a camera and light. */
    record Studio() implements Backdrop {}

    /** A clear sky with its sun; up must be y. Its radiance is that of {@link enlightenment.scene.Background.Sky}. */
    record Sky() implements Backdrop {}

    /**
     * One radiance from everywhere.
     *
     * @param radiance linear, in the unit of lights; 1 is shown as white without an exposure
     */
    record Constant(Rgb radiance) implements Backdrop {
        /** @throws enlightenment.math.InvalidValueException (key {@code radiance}) if it is beyond the range of lights */
        public Constant {
            Radiance.check("radiance", radiance.max());
        }
    }
}
