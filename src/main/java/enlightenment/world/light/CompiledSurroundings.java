package enlightenment.world.light;

import enlightenment.color.Rgb;
import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import enlightenment.surroundings.Sun;
import enlightenment.surroundings.Surroundings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;

/** Compiles backgrounds to surroundings. */
public final class CompiledSurroundings {
    private CompiledSurroundings() {}

    /**
     * Compiles a background; null if its radiance is constant.
     *
     * @param files returns the content of an image file, or null if it must be read from the disk
     * @throws SceneException if the file of a picture cannot be used, or its radiance or that of a sky is too large
     */
    static Surroundings of(Shading.Background background, Function<Path, byte[]> files) {
        try {
            return made(background, files);
        } catch (InvalidValueException e) {
            throw SceneException.of("/shading/background/" + e.key(), e.problem());
        }
    }

    /**
     * Throws where the radiance of a picture or a sky is too large, as {@link #of} does. It never is if it is unscaled or dimmed: then no
     * file is read.
     */
    public static void check(Scene scene, SceneImages images) {
        Shading.Background background = scene.shading() instanceof Shading.Physical p ? p.background() : null;
        if (background instanceof Shading.Background.Picture p && p.radiance().max() > 1) {
            images.around(new Shading.Background.Picture(p.picture(), p.radiance(), 0));
        } else if (background instanceof Shading.Background.Sky s
                && s.radiance().max() > 1) {
            images.around(new Shading.Background.Sky(
                    s.elevation(), 0, s.turbidity(), s.groundAlbedo(), s.radiance(), s.hasSun()));
        }
    }

    /**
     * Adds the disks of distant lights, in an order that does not depend on that in the scene.
     *
     * @param around the compiled background; null if it is constant
     * @return {@code around}, which may be null, without distant lights that emit
     */
    public static Surroundings withDistantLights(
            Surroundings around, Shading.Background background, List<Light> lights) {
        List<Sun> suns = lights.stream()
                .filter(light ->
                        light instanceof Light.Distant && light.emitted().max() > 0)
                .map(Light.Distant.class::cast)
                .map(light -> Sun.distant(light.direction(), light.angle(), light.emitted()))
                .sorted(Comparator.<Sun>comparingDouble(sun -> sun.x)
                        .thenComparingDouble(sun -> sun.y)
                        .thenComparingDouble(sun -> sun.z)
                        .thenComparingDouble(sun -> sun.solidAngle)
                        .thenComparingDouble(sun -> sun.r)
                        .thenComparingDouble(sun -> sun.g)
                        .thenComparingDouble(sun -> sun.b))
                .toList();
        if (suns.isEmpty()) {
            return around;
        }
        Rgb even = background instanceof Shading.Background.Constant c ? c.radiance() : Rgb.BLACK;
        return (around == null ? Surroundings.constant(even) : around).with(suns);
    }

    private static Surroundings made(Shading.Background background, Function<Path, byte[]> files) {
        if (background instanceof Shading.Background.Picture p) {
            return picture(p, files.apply(p.picture().file()));
        }
        if (background instanceof Shading.Background.Sky s) {
            return Surroundings.sky(
                    s.elevation(), s.azimuth(), s.turbidity(), s.groundAlbedo(), s.hasSun(), s.radiance());
        }
        return null;
    }

    private static Surroundings picture(Shading.Background.Picture p, byte[] content) {
        Surroundings.Texels texels = new Surroundings.Texels(
                p.picture().encoding() == Texture.Encoding.LINEAR, p.picture().filter() == Texture.Filter.NEAREST);
        try {
            return content == null
                    ? Surroundings.read(p.picture().file(), p.radiance(), p.rotation(), texels)
                    : Surroundings.of(content, p.radiance(), p.rotation(), texels);
        } catch (IOException e) {
            String problem = content == null
                    ? e.getMessage()
                    : "cannot read " + p.picture().file() + ": " + e.getMessage();
            throw SceneException.of("/shading/background/texture", problem);
        }
    }
}
