package enlightenment.importer;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import enlightenment.math.Vec3;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * Choices for reading files of other programs.
 *
 * @param extracted the folder that pictures are written to which the file holds inside, such as those of a GLB; made when it is needed. Scenes name
 *     them there, so they must stay as long as the scene is used. Empty for a temporary one that goes when the process ends
 * @param up the axis that points upwards for views and light that the file lacks; empty for z in STL files and y in others
 * @param camera the camera of the file: its number in the file's order, from 0, or its name, of which the first counts; empty for the first camera
 * @param orbit the view of the whole model from outside, in place of the file's camera; empty for the camera, and the usual view where there is none
 * @param backdrop the surroundings; empty for those of the file, and the studio's where nothing shines
 * @param framesPerSecond how many frames a second of a file's animation has, greater than 0 and finite; 24 as a film
 * @param animation the animation of the file: its number in the file's order, from 0, or its name, of which the first counts; empty for the first
 *     animation
 */
public record ImportOptions(
        Optional<Path> extracted,
        Optional<Up> up,
        Optional<String> camera,
        Optional<Orbit> orbit,
        Optional<Backdrop> backdrop,
        double framesPerSecond,
        Optional<String> animation) {
    /** The usual choices. */
    public static final ImportOptions DEFAULT = new ImportOptions(
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            24,
            Optional.empty());

    /** An axis that points upwards, with the front of a model that stands on it. */
    public enum Up {
        X(Vec3.X, Vec3.Z),
        Y(Vec3.Y, Vec3.Z),
        Z(Vec3.Z, new Vec3(0, -1, 0)),
        MINUS_X(new Vec3(-1, 0, 0), Vec3.Z),
        MINUS_Y(new Vec3(0, -1, 0), new Vec3(0, 0, -1)),
        MINUS_Z(new Vec3(0, 0, -1), Vec3.Y);

        private final Vec3 axis;
        private final Vec3 front;

        Up(Vec3 axis, Vec3 front) {
            this.axis = axis;
            this.front = front;
        }

        /** The unit vector upwards. */
        public Vec3 axis() {
            return axis;
        }

        /** The unit vector to which models face: +z where y points upwards (glTF 2.0, section 3.4), −y where z does. */
        public Vec3 front() {
            return front;
        }

        /** The unit vector to the right of the picture seen from the front: axis × front. */
        public Vec3 right() {
            return axis.cross(front);
        }
    }

    /**
     * A view towards the middle of the model.
     *
     * @param azimuth of the eye, degrees from the front of the model to the right, −360..360
     * @param elevation of the eye above the horizon, degrees, −90..90
     */
    public record Orbit(double azimuth, double elevation) {
        /** The usual view: three quarters, and somewhat from above. */
        public static final Orbit USUAL = new Orbit(35, 22);

        /** @throws enlightenment.math.InvalidValueException for an angle out of range */
        public Orbit {
            Check.range("azimuth", azimuth, -360, 360);
            Check.range("elevation", elevation, -90, 90);
        }
    }

    /** @throws enlightenment.math.InvalidValueException (key {@code framesPerSecond}) if it is not greater than 0 and finite */
    public ImportOptions {
        Check.positive("framesPerSecond", framesPerSecond);
        Objects.requireNonNull(extracted, "extracted");
        Objects.requireNonNull(up, "up");
        Objects.requireNonNull(camera, "camera");
        Objects.requireNonNull(orbit, "orbit");
        Objects.requireNonNull(backdrop, "backdrop");
        Objects.requireNonNull(animation, "animation");
    }

    /** These choices with a folder for pictures. */
    public ImportOptions withExtracted(Path folder) {
        return new ImportOptions(Optional.of(folder), up, camera, orbit, backdrop, framesPerSecond, animation);
    }

    /** These choices with an axis upwards. */
    public ImportOptions withUp(Up value) {
        return new ImportOptions(extracted, Optional.of(value), camera, orbit, backdrop, framesPerSecond, animation);
    }

    /** These choices with a camera of the file, by its number or name. */
    public ImportOptions withCamera(String value) {
        return new ImportOptions(extracted, up, Optional.of(value), orbit, backdrop, framesPerSecond, animation);
    }

    /** These choices with a view from outside. */
    public ImportOptions withOrbit(Orbit value) {
        return new ImportOptions(extracted, up, camera, Optional.of(value), backdrop, framesPerSecond, animation);
    }

    /** These choices with other surroundings. */
    public ImportOptions withBackdrop(Backdrop value) {
        return new ImportOptions(extracted, up, camera, orbit, Optional.of(value), framesPerSecond, animation);
    }

    /** These choices with another number of frames in a second. */
    public ImportOptions withFramesPerSecond(double value) {
        return new ImportOptions(extracted, up, camera, orbit, backdrop, value, animation);
    }

    /** These choices with an animation of the file, by its number or name. */
    public ImportOptions withAnimation(String value) {
        return new ImportOptions(extracted, up, camera, orbit, backdrop, framesPerSecond, Optional.of(value));
    }

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
}
