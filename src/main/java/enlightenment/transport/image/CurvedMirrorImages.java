package enlightenment.transport.image;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.world.CompiledScene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Finds where the eye sees the ball around a light in a mirror of any shape. What hides mirror or light is not looked at. A mutable work
 * object, one per thread.
 */
final class CurvedMirrorImages extends ImageSolver {
    /** So many camera rays are beside each other over the mirror's box on the film, and above each other. */
    private static final int GRID = 48;

    private final Ray ray = new Ray();
    private final Hit hit = new Hit();

    private Primitive mirror;
    private int face;
    private boolean isOutsideOnly;

    CurvedMirrorImages(CompiledScene scene) {
        super(scene);
    }

    /**
     * Finds images of a light's ball that do not overlap.
     *
     * @param mirrorId the mirror's id
     * @param mirrorFace its face
     * @param outsideOnly whether it reflects on its outside only
     * @param lightIndex the light's index
     */
    List<LightImage> find(int mirrorId, int mirrorFace, boolean outsideOnly, int lightIndex) {
        mirror = scene.primitives[mirrorId];
        face = mirrorFace;
        isOutsideOnly = outsideOnly;
        light = scene.physical.lights[lightIndex];
        List<LightImage> found = new ArrayList<>();
        if (lay(mirror.bounds(), GRID)) {
            double[] squares = new double[GRID * GRID];
            Arrays.setAll(
                    squares, k -> misses(middleX(k % GRID), middleY(k / GRID)) ? square() : Double.POSITIVE_INFINITY);
            for (int k = 0; k < squares.length; k++) {
                if (solve(squares, GRID, k % GRID, k / GRID)) {
                    LightImage image = new LightImage(lightIndex, light, mirrorId, face, x, y);
                    if (found.stream().noneMatch(image::overlaps)) {
                        found.add(image);
                    }
                }
            }
        }
        return found;
    }

    @Override
    boolean misses(double atX, double atY) {
        camera.ray(atX, atY, ray);
        if (!mirror.intersect(ray, hit) || hit.face != face || isOutsideOnly && hit.side != Ray.OUTSIDE) {
            return false;
        }
        double along = 2 * (ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz);
        double scale = 1 / Math.sqrt(ray.dd);
        return passes(
                hit.px,
                hit.py,
                hit.pz,
                scale * (ray.dx - along * hit.nx),
                scale * (ray.dy - along * hit.ny),
                scale * (ray.dz - along * hit.nz));
    }
}
