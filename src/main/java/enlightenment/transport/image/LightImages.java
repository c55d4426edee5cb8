package enlightenment.transport.image;

import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.primitive.SupportSurface;
import enlightenment.primitive.TorusPrimitive;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.SurfaceMaterial;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Finds the images of lights that samples of a pixel may miss: as they are seen straight, in flat mirrors, and, by the balls around them,
 * in curved mirrors; glass and panes reflect as mirrors do. Whether something hides them is not asked. Through glass, and in several mirrors,
 * only images that are smaller than a pixel are found, by {@link ChainImages}.
 *
 * <p>Images smaller than a pixel are all found. Of larger ones, which only samples of pixels at their edges miss, those of lights that are
 * bright beside what is likely to be behind them: not dimmer than a sixteenth of the brightest light, nor than twice the background. Black
 * takes the light's place among the samples of the pixel, and must be nearer to what is behind than the light is. The choice is the same
 * however bright all lights together are.
 */
final class LightImages {
    /** Mirrors and lights are many in few scenes: so many pairs of them are looked at, the first ones. */
    private static final int MOST_PAIRS = 64;

    /**
     * So many images that are not smaller than a pixel are taken, the first ones: most edges in a mesh that glows are no edges of the
     * light.
     */
    private static final int MOST_LARGE = 64;

    /**
     * A light of so much of the brightest one's radiance is seldom dimmer than twice what that makes of surfaces: it would have to fill
     * this share of half their sky.
     */
    private static final double BRIGHT = 1.0 / 16;

    /** The polygon around a mirrored ball's image. */
    private static final int MIRRORED_CORNERS = 4;

    private final CompiledScene scene;
    private final LightOutline outline;
    private final boolean isParallel;
    private final Ray middle = new Ray();
    private final MirrorImage mirrorImage = new MirrorImage();
    private final CurvedMirrorImages curved;
    private final double[][] corners = new double[MIRRORED_CORNERS][3];
    private final ClippedPolygon polygon = new ClippedPolygon();
    private final List<LightImage> found = new ArrayList<>();

    /** The least brightness of larger images. */
    private final double least;

    private int pairs;
    private int large;

    private LightImages(CompiledScene scene) {
        this.scene = scene;
        outline = new LightOutline(scene.camera);
        curved = new CurvedMirrorImages(scene);
        isParallel = new EyeProjection(scene.camera).isParallel();
        scene.camera.ray(0.5, 0.5, middle);
        PhysicalScene p = scene.physical;
        double brightest = Arrays.stream(p.lights)
                .filter(l -> !l.isPoint)
                .mapToDouble(LightImage::brightness)
                .max()
                .orElse(0);
        double background = Math.max(p.backgroundR, Math.max(p.backgroundG, p.backgroundB));
        least = p.surroundings == null ? Math.max(BRIGHT * brightest, 2 * background) : Double.POSITIVE_INFINITY;
    }

    /** The images in the picture of a scene of physical shading. */
    static LightImage[] of(CompiledScene scene) {
        LightImages images = new LightImages(scene);
        PhysicalLight[] lights = scene.physical.lights;
        for (int light = 0; light < lights.length; light++) {
            if (images.canBeSeen(lights[light])) {
                images.addFlat(light, null, LightImage.STRAIGHT, LightImage.ANY_FACE, 1);
            }
        }
        if (scene.physical.maxBounces > 0 && scene.physical.showsMirrored) {
            for (int id = 0; id < scene.primitives.length && images.pairs < MOST_PAIRS; id++) {
                images.addMirrored(id);
            }
        }
        new ChainImages(scene).find().forEach(image -> images.keep(image, 0));
        return images.found.toArray(new LightImage[0]);
    }

    private boolean canBeSeen(PhysicalLight l) {
        return !l.isPoint && LightImage.brightness(l) > 0 && !scene.coincident.concerns(l.id, l.face);
    }

    private void addMirrored(int id) {
        Primitive p = scene.primitives[id];
        for (int face = 0; face < p.faceCount(); face++) {
            SurfaceMaterial m = scene.material(id, face);
            if (!scene.coincident.concerns(id, face) && m.isDelta && !m.isBlack && (!m.isGlass || reflectsOutside(m))) {
                addMirrored(id, face);
            }
        }
    }

    /** Whether the outside of smooth glass, or a pane, reflects one share of the light at all wavelengths: a sample knows it. */
    private boolean reflectsOutside(SurfaceMaterial m) {
        return m.transparency > 0 && m.medium == null && !scene.physical.hasDispersion;
    }

    /** The share that glass reflects at right angles; other mirrors reflect most. */
    private static double share(Primitive p, SurfaceMaterial m) {
        if (!m.isGlass) {
            return 1;
        }
        double amplitude = (m.indexOfRefraction - 1) / (m.indexOfRefraction + 1);
        double share = amplitude * amplitude;
        // Of a pane both faces reflect, to and fro.
        return m.transparency * (p.isSolid() ? share : 2 * share / (1 + share));
    }

    private void addMirrored(int id, int face) {
        PhysicalLight[] lights = scene.physical.lights;
        double share = share(scene.primitives[id], scene.material(id, face));
        for (int light = 0; light < lights.length && pairs < MOST_PAIRS; light++) {
            if (!canBeSeen(lights[light]) || lights[light].id == id) {
                continue;
            }
            if (scene.primitives[id] instanceof SpherePrimitive ball) {
                addInBall(id, ball, light, share);
                pairs++;
            } else if (scene.primitives[id].support(face) instanceof SupportSurface.Plane plane) {
                addFlat(light, plane, id, face, share);
                pairs++;
            } else {
                addCurved(id, face, light);
                pairs++;
            }
        }
    }

    /** Adds what is seen straight or in a flat mirror. */
    private void addFlat(int light, SupportSurface.Plane plane, int mirror, int face, double share) {
        PhysicalLight l = scene.physical.lights[light];
        if (outline.find(l, plane)) {
            keep(light, mirror, face, l.surface instanceof TorusPrimitive ? 0 : share);
        }
    }

    /** What an eye sees in a ball from outside has a closed form; parallel rays have no eye. */
    private void addInBall(int id, SpherePrimitive ball, int light, double share) {
        PhysicalLight l = scene.physical.lights[light];
        if (isParallel || !mirrorImage.aim(ball, l, middle.ox, middle.oy, middle.oz)) {
            addCurved(id, 0, light);
            return;
        }
        for (int k = 0; k < MIRRORED_CORNERS; k++) {
            mirrorImage.corner(k, corners[k]);
        }
        if (outline.around(corners)) {
            keep(light, id, LightImage.ANY_FACE, share);
        }
    }

    private void addCurved(int id, int face, int light) {
        boolean isGlass = scene.material(id, face).isGlass && scene.primitives[id].isSolid();
        for (LightImage image : curved.find(id, face, isGlass, light)) {
            keep(image, 0);
        }
    }

    private void keep(int light, int mirror, int face, double share) {
        keep(new LightImage(light, scene.physical.lights[light], mirror, face, outline.x, outline.y), share);
    }

    /**
     * Keeps an image.
     *
     * @param share how much of the light's radiance the image has; 0 if its outline is not that of the light
     */
    private void keep(LightImage image, double share) {
        double columns = scene.camera.columns;
        double rows = scene.camera.rows;
        if (!image.reaches(0, 0, columns, rows)) {
            return;
        }
        if (image.area() >= 1) {
            polygon.set(image.x, image.y, 0, 0, columns, rows);
            boolean hasEdges = polygon.area() > 0 && polygon.area() < columns * rows;
            boolean isBright = share * image.brightness >= least;
            if (!hasEdges || !isBright || large == MOST_LARGE) {
                return;
            }
            large++;
        }
        found.add(image);
    }
}
