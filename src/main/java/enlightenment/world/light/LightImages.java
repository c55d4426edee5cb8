package enlightenment.world.light;

import enlightenment.surroundings.Surroundings;
import enlightenment.world.camera.CompiledCamera;
import enlightenment.world.contact.CoincidentSurfaces;
import enlightenment.world.parts.CancellationCheck;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Finds the images of lights that samples of a pixel may miss, as if nothing occluded them.
 *
 * <p>All images smaller than a pixel are found. Of larger ones, which only samples of pixels at their edges miss, those of lights that are
 * bright compared to what is likely behind them: at least a sixteenth of the brightest light, and twice the background. Where an image is
 * sampled separately, direct hits of the light count as 0, which lowers variance only if the light is at least twice as bright as what is
 * behind it. The choice does not depend on the scale of all lights. Textured lights have none, since their radiance is not constant.
 */
public final class LightImages {
    /**
     * The largest number of images of a pixel or more, of which the first are kept: most edges in an emitting mesh are no edges of the
     * light.
     */
    private static final int MOST_LARGE = 64;

    /**
     * A light of this share of the brightest one's radiance is seldom dimmer than twice the surfaces that the brightest lights: that would
     * have to fill this share of half their sky.
     */
    private static final double BRIGHT = 1.0 / 16;

    private final CompiledCamera camera;
    private final LightOutline outline;
    private final ClippedPolygon polygon = new ClippedPolygon();
    private final List<LightImage> found = new ArrayList<>();

    /** The least brightness of larger images. */
    private final double least;

    private int large;

    private LightImages(CompiledCamera camera, PhysicalLight[] lights, double background) {
        this.camera = camera;
        outline = new LightOutline(camera);
        double brightest = Arrays.stream(lights)
                .filter(l -> !l.isPoint)
                .mapToDouble(LightImage::brightness)
                .max()
                .orElse(0);
        least = Math.max(BRIGHT * brightest, 2 * background);
    }

    /**
     * The images in a picture; none with a lens, which blurs them, nor in panoramas, which bend their outlines.
     *
     * @param surroundings null if there is only a constant background
     * @param background the constant radiance, in its brightest band
     * @param poll called regularly; what it throws ends this
     */
    public static LightImage[] of(
            CompiledCamera camera,
            PhysicalLight[] lights,
            CoincidentSurfaces coincident,
            Surroundings surroundings,
            double background,
            Runnable poll) {
        if (!camera.isPinholeOrParallel()) {
            return new LightImage[0];
        }
        LightImages images =
                new LightImages(camera, lights, surroundings == null ? background : Double.POSITIVE_INFINITY);
        for (int light = 0; light < lights.length; light++) {
            if (CancellationCheck.isDue(light)) {
                poll.run();
            }
            PhysicalLight l = lights[light];
            boolean canBeSeen = !l.isPoint
                    && l.texture == null
                    && LightImage.brightness(l) > 0
                    && !coincident.concerns(l.id, l.face);
            if (canBeSeen && images.outline.find(l)) {
                images.keep(light, l);
            }
        }
        return images.found.toArray(new LightImage[0]);
    }

    private void keep(int light, PhysicalLight l) {
        LightImage image = new LightImage(light, l, outline.x, outline.y);
        double columns = camera.columns;
        double rows = camera.rows;
        if (!image.reaches(0, 0, columns, rows)) {
            return;
        }
        if (image.area() >= 1) {
            polygon.set(image.x, image.y, 0, 0, columns, rows);
            boolean hasEdges = polygon.area() > 0 && polygon.area() < columns * rows;
            boolean isBright = outline.isExact && image.brightness >= least;
            if (!hasEdges || !isBright || large == MOST_LARGE) {
                return;
            }
            large++;
        }
        found.add(image);
    }
}
