package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.UvMap;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import java.io.IOException;
import java.util.Optional;

/** Reads point lights that shine along +z, with +y upwards and +x to the left in a projected picture. */
final class DirectedLights {
    private final SceneIndex scene;
    private final Affine world;
    private final EmissionReader emissions;

    DirectedLights(SceneIndex scene, Affine world) {
        this.scene = scene;
        this.world = world;
        emissions = new EmissionReader(scene);
    }

    /** Adds a spotlight: from {@code beam_width} to {@code cutoff_angle} its intensity falls linearly with the angle. */
    void spot(Properties p) {
        XmlElement e = p.element();
        double cutoff = p.number("cutoff_angle", 20);
        double beam = p.number("beam_width", cutoff * 3 / 4);
        if (!(cutoff > 0 && cutoff <= 180 && beam >= 0 && beam <= cutoff)) {
            throw e.failure("must have 0 <= beam_width <= cutoff_angle <= 180 degrees, and a cutoff_angle above 0");
        }
        if (p.has("texture")) {
            scene.note(e, "the texture of a spotlight is left out");
        }
        Affine map = world.after(p.transform("to_world"));
        Rgb intensity = emissions.light(p, "intensity", 1);
        Falloff falloff = Falloff.of(beam, cutoff);
        if (beam < cutoff) {
            scene.note(e, "the edge of a spotlight becomes a smooth one of equal power");
        }
        scene.draft()
                .light(new Light.Spot(
                        Affine.exact(map.offset()),
                        map.vector(Vec3.Z),
                        falloff.angle(),
                        falloff.innerAngle(),
                        Rgb.WHITE,
                        Emission.intensity(intensity)));
    }

    /** The angles of our spotlight, in degrees. */
    record Falloff(double angle, double innerAngle) {
        /**
         * Of equal power, and of the same cutoff if that can be. A smoothstep of the cosine has the integral of one step at the mean of both
         * cosines; a linear fall between b and c has that of one at (sin c − sin b) / (c − b).
         */
        static Falloff of(double beam, double cutoff) {
            if (beam == cutoff) {
                return new Falloff(cutoff, cutoff);
            }
            double b = StrictMath.toRadians(beam);
            double c = StrictMath.toRadians(cutoff);
            double mean = (StrictMath.sin(c) - StrictMath.sin(b)) / (c - b);
            double inner = 2 * mean - StrictMath.cos(c);
            return inner <= 1
                    ? new Falloff(cutoff, StrictMath.min(degrees(inner), cutoff))
                    : new Falloff(StrictMath.min(degrees(2 * mean - 1), cutoff), 0);
        }

        private static double degrees(double cosine) {
            return StrictMath.toDegrees(StrictMath.acos(StrictMath.max(cosine, -1)));
        }
    }

    /** Adds a projector, whose picture lights a plane across its axis evenly: at distance 1 with π times its value. */
    void projector(Properties p) {
        XmlElement e = p.element();
        double scale = p.number("scale", 1);
        if (scale < 0) {
            throw e.failure("must have a scale that is not negative");
        }
        Affine map = world.after(p.transform("to_world"));
        Vec3 direction = map.vector(Vec3.Z);
        Vec3 up = map.vector(Vec3.Y);
        try {
            Optional<Texture.File> picture = picture(p);
            Rgb color = picture.isPresent() ? Rgb.WHITE : emissions.light(p, "irradiance", 1);
            Image source = picture.isPresent() ? ImageFiles.read(picture.get().file()) : null;
            double aspect = source == null ? 1 : (double) source.width() / source.height();
            double halfWidth = SensorReader.halfWidth(p, aspect);
            // Ours has the picture's right where up × direction points.
            boolean isMirrored = up.cross(direction).dot(map.vector(Vec3.X)) > 0;
            DerivedPictures.Scaled made = source == null
                    ? scene.pictures().plain(halfWidth)
                    : scene.pictures().projection(picture.get(), source, halfWidth, isMirrored);
            Rgb intensity = color.times(Rgb.gray(StrictMath.PI * scale * made.brightest()));
            if (!intensity.isBlack()) {
                scene.draft()
                        .light(new Light.Projector(
                                Affine.exact(map.offset()),
                                made.picture(),
                                direction,
                                up,
                                StrictMath.toDegrees(2 * StrictMath.atan(halfWidth)),
                                Rgb.WHITE,
                                Emission.intensity(intensity)));
            }
        } catch (IOException problem) {
            scene.note(e, "a projector is left out: " + problem.getMessage());
        }
    }

    private Optional<Texture.File> picture(Properties p) {
        Optional<XmlElement> e = p.find("irradiance").map(scene::resolved);
        if (e.isEmpty() || !e.get().tag().equals("texture") || !e.get().type().equals("bitmap")) {
            return Optional.empty();
        }
        TextureReader textures = new TextureReader(scene);
        Texture texture = textures.texture(e.get(), false);
        if (!textures.map().equals(UvMap.IDENTITY)) {
            scene.note(e.get(), "to_uv of a projected picture is left out");
        }
        return texture instanceof Texture.File file ? Optional.of(file) : Optional.empty();
    }
}
